// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_stepping_premises_h
#define tribody_stepping_premises_h

#include <tribody/bushing/wearing_bushing.h>
#include <tribody/multibody/cycle/duty_cycle.h>

#include <string>

namespace Tribody
{
  namespace Coupling
  {
    /// How far a bushing is from the small strains that its elasticity and
    /// contact assume.
    struct Strains
    {
      /// Largest pressure over E/(1 - nu^2) of the bushing [-].
      double pressure = 0.;
      /// Largest penetration of the force law over the wall [-].
      double displacement = 0.;

      /// Beyond this, it is worth a note.
      static constexpr double noted = 0.02;
      /// Beyond this, a warning: the linear model errs by a part of the
      /// pressure about as large.
      static constexpr double doubtful = 0.1;
      /// Beyond this there is no linear model.
      static constexpr double largest_allowed = 0.4;

      /// The larger one.
      double
      largest() const;

      /// Each the larger of both.
      void
      widen(const Strains &other);
    };

    /// Those of @p contact under @p cycle.
    Strains
    compute_strains(const WearingBushing            &bushing,
                    const Multibody::JointDutyCycle &cycle,
                    const CycleContact              &contact);

    /// What they are at least under @p cycle, before any contact is solved: the
    /// largest pressure is not less than the force over the projected area.
    Strains
    compute_least_strains(const WearingBushing            &bushing,
                          const Multibody::JointDutyCycle &cycle);

    /// For the user; empty if they are small.
    std::string
    describe(const Strains &strains);

    /// @throws ExcRun where there is no linear model any more.
    void
    check_strains(const Strains &strains, const std::string &bushing);

    /**
     * The pin's centre is not farther from the bushing's than clearance and
     * wall together: beyond that no contact law holds it.
     * @param time of the samples [s].
     * @throws ExcRun naming joint, time and place.
     */
    void
    check_pin_in_bore(const WearingBushing            &bushing,
                      const Multibody::JointDutyCycle &cycle,
                      const Eigen::VectorXd           &time);

    /// The pin fits its bore, as warm as both are: nowhere is the bore narrower
    /// than the pin; and what depends on the temperature has a value.
    /// @throws ExcRun that has temperatures and clearance.
    void
    check_warmth(const WearingBushing &bushing, const Warmth &warmth);
  } // namespace Coupling
} // namespace Tribody

#endif

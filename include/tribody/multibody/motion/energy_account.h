// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_motion_energy_account_h
#define tribody_multibody_motion_energy_account_h

#include <tribody/multibody/motion/energy_record.h>
#include <tribody/multibody/system/mechanism_state.h>

namespace Tribody
{
  namespace Multibody
  {
    class EquationsOfMotion;

    /**
     * Adds up where the energy of a motion comes from and goes to. The powers
     * of drivers, dampers and contacts are integrated by Simpson's rule over
     * the steps of the motion, for which the states in the middle and at the
     * end of each step are wanted. The drivers' forces are those that the
     * equations of motion ask for at that state.
     */
    class EnergyAccount
    {
    public:
      /// Keeps a reference to @p equations.
      explicit EnergyAccount(const EquationsOfMotion &equations);

      /// Go on with other equations of the same coordinates and joints, to
      /// which a reference is kept: pins have begun or ceased to follow their
      /// bores.
      void
      set_equations(const EquationsOfMotion &present)
      {
        equations = &present;
      }

      /// Begin anew at @p state.
      void
      open(const MechanismState &state);

      /// Book the motion from time() on over @p middle to @p end.
      void
      advance(const MechanismState &middle, const MechanismState &end);

      /// Go on from @p state at the same time, in which velocities may have
      /// jumped: the energy lost by that is that of an impact.
      void
      restart(const MechanismState &state);

      /// Up to when the motion is booked [s].
      double
      time() const
      {
        return the_time;
      }

      /// Energies at time(); exchanged ones since open().
      const EnergyRecord &
      now() const
      {
        return the_record;
      }

      /// Largest error of the balance at any step since open(), relative to the
      /// largest of its terms until now [-].
      double
      relative_error() const;

    private:
      // Rates of the exchanged energies [W], in the order of `exchanged`.
      Eigen::VectorXd
      compute_powers(const MechanismState &state) const;

      // Of the forces and torques given as functions of time [W].
      double
      compute_applied_power(const MechanismState &state) const;

      void
      add_joint_powers(const unsigned int    joint,
                       const MechanismState &state,
                       Eigen::VectorXd      &powers) const;

      void
      update_record(const MechanismState &state);

      const EquationsOfMotion *equations;
      double                   the_time = 0.;
      Eigen::VectorXd          exchanged;
      Eigen::VectorXd          powers;
      EnergyRecord             at_opening;
      EnergyRecord             the_record;
      double                   largest_error   = 0.;
      double                   largest_term    = 0.;
      double                   largest_kinetic = 0.;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

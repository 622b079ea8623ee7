// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_run_operating_case_h
#define tribody_run_operating_case_h

#include <tribody/case/case_parameters.h>
#include <tribody/multibody/cycle/cycle_simulation.h>
#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/multibody/system/mechanism.h>

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace Tribody
{
  namespace Coupling
  {
    /// Do this, and let errors name the load case, if it has a name.
    /// @throws ExcRun as @p action does.
    void
    in_load_case(const LoadCase              &load_case,
                 const std::function<void()> &action);

    /// @p load_case with the friction coefficients of joints multiplied by
    /// these @p factors, by the name of the joint.
    LoadCase
    with_friction_factors(const LoadCase                      &load_case,
                          const std::map<std::string, double> &factors);

    /// A load case whose duty cycles can be computed.
    class OperatingCase
    {
    public:
      /// @param load_case one of those of the @p parameters; must outlive this
      ///   object.
      /// @throws ExcRun if the mechanism cannot be assembled.
      OperatingCase(const CaseParameters &parameters,
                    const LoadCase       &load_case);

      OperatingCase(const OperatingCase &) = delete;
      OperatingCase &
      operator=(const OperatingCase &) = delete;

      /// The one that is given, or that of the mechanism, see
      /// Multibody::CycleSimulation::run().
      /// @throws ExcRun that names the load case.
      Multibody::DutyCycle
      run(const Multibody::CycleSimulation::Clearances &clearances,
          const Multibody::CycleSimulation::Supports   &supports,
          const Multibody::CycleSimulation::Arcs       &arcs,
          const Multibody::DutyCycle                   *before) const;

      /// The bodies and joints of all cases, with the drivers and forces of
      /// this one; the null pointer where the duty cycle is given.
      const Multibody::Mechanism *
      mechanism() const
      {
        return machine ? &*machine : nullptr;
      }

    private:
      const LoadCase                     &load_case;
      std::optional<Multibody::Mechanism> machine;
      /// Refers to the machine.
      std::optional<Multibody::CycleSimulation> dynamics;
    };
  } // namespace Coupling
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/multibody/assembly/redundancy.h>
#include <tribody/run/operating_case.h>

#include <string>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // What 'Energy balance = without wear', 'Joint motion = automatic',
      // 'Accuracy' and 'Sampling tolerance' mean here.
      Multibody::DynamicsParameters
      make_dynamics_parameters(const CaseParameters &parameters,
                               const LoadCase       &load_case)
      {
        Multibody::DynamicsParameters dynamics = load_case.dynamics;
        if (dynamics.energy_balance == Multibody::EnergyBalance::without_wear)
          dynamics.energy_balance = parameters.cycles == 0
                                      ? Multibody::EnergyBalance::always
                                      : Multibody::EnergyBalance::never;
        // Energies ask more of the motion than wear does.
        if (dynamics.accuracy == 0. &&
            dynamics.energy_balance == Multibody::EnergyBalance::always)
          dynamics.accuracy = Multibody::DynamicsParameters().accuracy;
        if (parameters.cycles > 0)
          return dynamics;
        dynamics.sampling_tolerance = 0.;
        if (dynamics.accuracy == 0.)
          dynamics.accuracy = Multibody::DynamicsParameters().accuracy;
        if (dynamics.joint_motion == Multibody::JointMotion::automatic)
          dynamics.joint_motion = Multibody::JointMotion::dynamic;
        return dynamics;
      }



      // Where there are several, messages name the load case.
      void
      name_load_case(const LoadCase &load_case, Multibody::DutyCycle &cycle)
      {
        std::string &message = cycle.settling.message;
        if (!load_case.name.empty() && !message.empty())
          message = "of load case " + load_case.name + " " + message;
      }
    } // namespace



    void
    in_load_case(const LoadCase &load_case, const std::function<void()> &action)
    {
      try
        {
          action();
        }
      catch (const ExcRun &exception)
        {
          if (load_case.name.empty())
            throw;
          throw ExcRun(load_case.subsection() + ": " + message_of(exception));
        }
    }



    LoadCase
    with_friction_factors(const LoadCase                      &load_case,
                          const std::map<std::string, double> &factors)
    {
      LoadCase result = load_case;
      for (Multibody::JointParameters &joint : result.mechanism.joints)
        if (const auto found = factors.find(joint.name); found != factors.end())
          {
            joint.friction_coefficient *= found->second;
            joint.static_friction_coefficient *= found->second;
          }
      if (result.given_duty_cycle)
        for (Multibody::JointDutyCycle &joint : result.given_duty_cycle->joints)
          if (const auto found = factors.find(joint.name);
              found != factors.end())
            joint.friction_force *= found->second;
      return result;
    }



    OperatingCase::OperatingCase(const CaseParameters &parameters,
                                 const LoadCase       &load_case)
      : load_case(load_case)
    {
      if (load_case.given_duty_cycle)
        return;
      machine.emplace(
        Multibody::count_redundant_constraints(load_case.mechanism));
      dynamics.emplace(*machine,
                       make_dynamics_parameters(parameters, load_case));
    }



    Multibody::DutyCycle
    OperatingCase::run(const Multibody::CycleSimulation::Clearances &clearances,
                       const Multibody::CycleSimulation::Supports   &supports,
                       const Multibody::CycleSimulation::Arcs       &arcs,
                       const Multibody::DutyCycle *before) const
    {
      if (load_case.given_duty_cycle)
        return *load_case.given_duty_cycle;
      Multibody::DutyCycle cycle;
      in_load_case(load_case, [&]() {
        cycle = dynamics->run(clearances, supports, arcs, before);
      });
      name_load_case(load_case, cycle);
      return cycle;
    }
  } // namespace Coupling
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/significant_digits.h>
#include <tribody/case/repetition.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      constexpr unsigned int most_cycles = 24;

      // Relative to the largest value: rounding of t over many cycles.
      constexpr double tolerance = 1e-6;

      // Whether f(t + n cycles) is f(t), for an angle but for a constant.
      bool
      repeats_after(const Multibody::TimeFunction &function,
                    const double                   cycle,
                    const unsigned int             n,
                    const bool                     is_angle)
      {
        constexpr unsigned int n_times  = 97;
        double                 smallest = 0., largest = 0., size = 0.;
        for (unsigned int k = 0; k < n_times; ++k)
          {
            const double t      = cycle * (k + 0.3819660113) / n_times;
            const double now    = function.value(t);
            const double change = function.value(t + n * cycle) - now;
            smallest            = k == 0 ? change : std::min(smallest, change);
            largest             = k == 0 ? change : std::max(largest, change);
            size                = std::max(size, std::abs(now));
          }
        if (!is_angle)
          {
            smallest = std::min(smallest, 0.);
            largest  = std::max(largest, 0.);
          }
        return largest - smallest <= tolerance * size;
      }



      void
      check_function(const Multibody::TimeFunction &function,
                     const std::string             &path,
                     const double                   cycle,
                     const bool                     is_integrated,
                     const bool                     is_angle = false)
      {
        if (repeats_after(function, cycle, 1, is_angle))
          return;
        for (unsigned int n = 2; n <= most_cycles; ++n)
          AssertThrow(
            !repeats_after(function, cycle, n, is_angle),
            ExcParameter(path,
                         "repeats after " + std::to_string(n) + " cycles of " +
                           significant_digits(cycle, 6) +
                           " s, and results would be those of the "
                           "first of them. Write 'set Cycle duration = " +
                           significant_digits(n * cycle, 6) +
                           " s' in 'Dynamics'"));
        AssertThrow(!is_integrated,
                    ExcParameter(path,
                                 "does not repeat with the cycle of " +
                                   significant_digits(cycle, 6) +
                                   " s, which an integrated motion goes "
                                   "through more than once. Write 't - " +
                                   significant_digits(cycle, 6) + "*floor(t/" +
                                   significant_digits(cycle, 6) +
                                   ")' for t, or set another 'Dynamics/Cycle "
                                   "duration'"));
      }



      // Parts of a turn are wanted where somebody says how long the cycle is.
      void
      check_turns(const Multibody::Mechanism &mechanism, const double cycle)
      {
        const auto &drivers = mechanism.parameters().drivers;
        for (const Multibody::DriverParameters &driver : drivers)
          {
            const double turns =
              driver.speed * cycle / (2. * dealii::numbers::PI);
            AssertThrow(!driver.is_angle() ||
                          std::abs(turns - std::round(turns)) < tolerance,
                        ExcParameter(
                          "Driver " + driver.name + "/Speed",
                          "makes " + significant_digits(std::abs(turns), 6) +
                            " turns in a cycle, which is one turn of the first "
                            "driver, so that the motion does not repeat with "
                            "it. Set 'Dynamics/Cycle duration'"));
          }
      }
    } // namespace



    void
    check_repetition(const Multibody::Mechanism          &mechanism,
                     const Multibody::DynamicsParameters &parameters,
                     const bool                           wears)
    {
      const bool is_given = parameters.cycle_duration > 0.;
      if (!is_given && !mechanism.has_turning_driver())
        return;
      // Who says how long a cycle is, or records it from the start, may want a
      // part of the motion.
      if (!wears && (is_given || parameters.maximum_settling_cycles == 0))
        return;
      const double cycle =
        is_given ? parameters.cycle_duration : mechanism.period();
      // Nothing prescribes the motion of degrees of freedom that ideal joints
      // leave.
      const Multibody::Mechanism closed(
        Multibody::with_ideal_joints(mechanism.parameters()));
      const bool is_integrated =
        wears &&
        (parameters.analysis == Multibody::Analysis::dynamic ||
         (parameters.analysis == Multibody::Analysis::automatic &&
          (parameters.joint_motion == Multibody::JointMotion::dynamic ||
           closed.n_degrees_of_freedom() != 0)));
      const auto &names = mechanism.parameters();
      for (std::size_t i = 0; i < names.forces.size(); ++i)
        check_function(mechanism.applied_forces()[i].function,
                       "Force " + names.forces[i].name + "/Time function",
                       cycle,
                       is_integrated);
      for (std::size_t i = 0; i < names.torques.size(); ++i)
        check_function(mechanism.applied_torques()[i].function,
                       "Torque " + names.torques[i].name + "/Time function",
                       cycle,
                       is_integrated);
      for (std::size_t i = 0; i < names.drivers.size(); ++i)
        if (mechanism.drivers()[i].motion.amplitude != 0.)
          check_function(mechanism.drivers()[i].motion.function,
                         "Driver " + names.drivers[i].name + "/Time function",
                         cycle,
                         is_integrated,
                         names.drivers[i].is_angle());
      if (wears && !is_given)
        check_turns(mechanism, cycle);
    }
  } // namespace Coupling
} // namespace Tribody

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

      // Whether f(t + n cycles) is f(t), for an angle but for a constant. The
      // period of a table is known; of an expression, values are.
      bool
      repeats_after(const Multibody::TimeFunction &function,
                    const double                   cycle,
                    const unsigned int             n,
                    const bool                     is_angle)
      {
        if (function.period() > 0.)
          {
            const double periods = n * cycle / function.period();
            return periods > 0.5 &&
                   std::abs(periods - std::round(periods)) <= tolerance;
          }
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



      // Throw ExcParameter for a table whose period does not fit the cycle.
      void
      refuse_period(const Multibody::TimeFunction &function,
                    const std::string             &path,
                    const double                   cycle)
      {
        unsigned int n = 2;
        while (n <= most_cycles && !repeats_after(function, cycle, n, false))
          ++n;
        throw ExcParameter(
          path,
          "has a period of " + significant_digits(function.period(), 6) +
            " s, but a cycle takes " + significant_digits(cycle, 6) +
            " s; it must be a whole number of periods. Change the times in the "
            "table, or 'Table period', or " +
            (n <= most_cycles
               ? "write 'set Cycle duration = " +
                   significant_digits(n * cycle, 6) + " s' in 'Dynamics'"
               : "'Dynamics/Cycle duration'"));
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
        if (function.period() > 0.)
          refuse_period(function, path, cycle);
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
              driver.mean_speed() * cycle / (2. * dealii::numbers::PI);
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
      for (const Multibody::ForceParameters &force : names.forces)
        check_function(force.parts().front().function,
                       force.path_of_function(),
                       cycle,
                       is_integrated);
      for (const Multibody::TorqueParameters &torque : names.torques)
        check_function(torque.function(),
                       torque.path_of_function(),
                       cycle,
                       is_integrated);
      for (std::size_t i = 0; i < names.drivers.size(); ++i)
        if (mechanism.drivers()[i].motion.amplitude != 0.)
          check_function(mechanism.drivers()[i].motion.function,
                         names.drivers[i].path_of_function(),
                         cycle,
                         is_integrated,
                         names.drivers[i].is_angle());
      if (wears && !is_given)
        check_turns(mechanism, cycle);
    }
  } // namespace Coupling
} // namespace Tribody

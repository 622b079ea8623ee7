// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/math/tools/toms748_solve.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/base/significant_digits.h>
#include <tribody/stepping/constant_jump.h>
#include <tribody/wear/constant_extrapolation.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // Far enough below the stable length that a sawtooth decays; whole
      // cycles as long as there is more than one.
      double
      safe_step(const double max_stable_step)
      {
        const double step = 0.8 * max_stable_step;
        return step > 1. ? std::floor(step) : step;
      }



      std::vector<WearRates>
      rates_of(const std::vector<JointState> &joints)
      {
        std::vector<WearRates> rates;
        for (const JointState &joint : joints)
          rates.push_back(
            {joint.contact.wear_rate, joint.contact.removed_area});
        return rates;
      }
    } // namespace



    ConstantJump::ConstantJump(const std::deque<WearingBushing> &bushings,
                               const StopConditions &stop_conditions,
                               const double          cycles_per_step,
                               const bool            keep_first_rate)
      : CycleJump(bushings, stop_conditions)
      , cycles_per_step(cycles_per_step)
      , keep_first_rate(keep_first_rate)
    {}



    WearStep
    ConstantJump::advance(RunState &state, const double end)
    {
      update_stable_step(state);
      const Wear::ConstantExtrapolation extrapolation{
        cycles_per_step > 0. ? cycles_per_step
                             : safe_step(state.stepper.max_stable_step)};

      std::vector<WearRates> &rates = state.stepper.rates_taken;
      state.stepper.rates_before    = rates_of(state.joints);
      if (!keep_first_rate || rates.empty())
        rates = state.stepper.rates_before;

      WearStep step;
      double   n_cycles = extrapolation.next_step(state.cycles, end);
      if (const auto passed = find_passed_limit(rates, n_cycles))
        {
          step.reached = passed->first;
          n_cycles     = passed->second;
        }
      step.cycles = state.cycles + n_cycles;
      AssertThrow(step.cycles > state.cycles,
                  ExcRun("After " + significant_digits(state.cycles, 6) +
                         " cycles a wear step of " +
                         significant_digits(n_cycles) +
                         " cycles leads nowhere; steps longer than " +
                         significant_digits(state.stepper.max_stable_step) +
                         " cycles are not stable. Look at 'Wear coefficient' "
                         "and its factors"));
      step.depths = depths_after(rates, n_cycles);
      for (const WearRates &of_joint : rates)
        step.removed_areas.push_back(n_cycles * of_joint.removed_area);
      return step;
    }



    std::vector<Eigen::VectorXd>
    ConstantJump::depths_after(const std::vector<WearRates> &rates,
                               const double                  n_cycles) const
    {
      std::vector<Eigen::VectorXd> depths;
      for (std::size_t j = 0; j < bushings.size(); ++j)
        depths.push_back(
          bushings[j].depth_after_removing(n_cycles * rates[j].removed_area));
      return depths;
    }



    std::optional<std::pair<unsigned int, double>>
    ConstantJump::find_passed_limit(const std::vector<WearRates> &rates,
                                    const double n_cycles) const
    {
      // Within an explicit step the removed area is linear in the cycles: the
      // moment at which a limit is passed is a root of one number.
      double                                         last = n_cycles;
      std::optional<std::pair<unsigned int, double>> passed;
      for (unsigned int i = 0; i < stop_conditions.n_conditions(); ++i)
        {
          const auto value = [&](const double cycles) {
            return stop_conditions.evaluate(depths_after(rates, cycles))[i];
          };
          if (value(last) < 0.)
            continue;
          boost::uintmax_t max_iterations = 100;
          last                            = boost::math::tools::toms748_solve(
                   value,
                   0.,
                   last,
                   boost::math::tools::eps_tolerance<double>(40),
                   max_iterations)
                   .second;
          passed = std::make_pair(i, last);
        }
      return passed;
    }



    void
    ConstantJump::update_stable_step(RunState &state) const
    {
      // The bound follows the compliance, and costs an eigenvalue problem.
      StepperState &stepper = state.stepper;
      if (stepper.stable_step_builds == state.counts.compliance_builds)
        return;
      stepper.max_stable_step = std::numeric_limits<double>::max();
      for (std::size_t j = 0; j < bushings.size(); ++j)
        stepper.max_stable_step =
          std::min(stepper.max_stable_step,
                   bushings[j].max_stable_step(state.joints[j].contact));
      stepper.stable_step_builds = state.counts.compliance_builds;
    }



    std::vector<StepError>
    ConstantJump::estimate_error(RunState &state, const double cycles_kept)
    {
      std::vector<StepError> errors;
      for (std::size_t j = 0; j < bushings.size(); ++j)
        {
          // Without kept rates the first term vanishes.
          const WearRates    &taken  = state.stepper.rates_taken[j];
          const WearRates    &before = state.stepper.rates_before[j];
          const CycleContact &after  = state.joints[j].contact;
          errors.push_back(
            {Wear::euler_error(taken.wear_rate, before.wear_rate, cycles_kept) +
               Wear::euler_error(taken.wear_rate, after.wear_rate, cycles_kept),
             {}});
          const Eigen::VectorXd area_error =
            0.5 * cycles_kept *
            (before.removed_area + after.removed_area -
             2. * taken.removed_area);
          const std::vector<WearingSurface> surfaces = bushings[j].surfaces();
          for (std::size_t i = 0; i < surfaces.size(); ++i)
            errors.back().volumes[i] =
              surfaces[i].part_of(area_error).sum() *
              bushings[j].bushing_parameters().axial_length;
        }
      return errors;
    }
  } // namespace Coupling
} // namespace Tribody

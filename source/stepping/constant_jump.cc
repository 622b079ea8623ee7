// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/math/tools/toms748_solve.hpp>

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
    } // namespace



    ConstantJump::ConstantJump(std::list<WearingBushing> &bushings,
                               const StopConditions      &stop_conditions,
                               const double               cycles_per_step,
                               const bool                 keep_first_rate)
      : CycleJump(bushings, stop_conditions)
      , cycles_per_step(cycles_per_step)
      , keep_first_rate(keep_first_rate)
    {}



    int
    ConstantJump::advance(RunState &state, const double end)
    {
      update_stable_step(state);
      const Wear::ConstantExtrapolation extrapolation{
        cycles_per_step > 0. ? cycles_per_step
                             : safe_step(state.max_stable_step)};

      contacts_before = state.contacts;
      if (!keep_first_rate || used_contacts.empty())
        used_contacts = state.contacts;
      const auto depths_after = [&](const double n_cycles) {
        std::vector<Eigen::VectorXd> depths;
        for (const WearingBushing &bushing : bushings)
          depths.push_back(bushing.depth_after_removing(
            n_cycles * used_contacts[depths.size()].removed_area));
        return depths;
      };

      // Within an explicit step the removed area is linear in the cycles: the
      // moment at which a limit is passed is a root of one number.
      double last_step = extrapolation.next_step(state.cycles, end);
      int    reached   = -1;
      for (unsigned int i = 0; i < stop_conditions.n_conditions(); ++i)
        {
          const auto value = [&](const double n_cycles) {
            return stop_conditions.evaluate(depths_after(n_cycles))[i];
          };
          if (value(last_step) < 0.)
            continue;
          boost::uintmax_t max_iterations = 100;
          last_step                       = boost::math::tools::toms748_solve(
                        value,
                        0.,
                        last_step,
                        boost::math::tools::eps_tolerance<double>(40),
                        max_iterations)
                        .second;
          reached = i;
        }

      const std::vector<Eigen::VectorXd> depths = depths_after(last_step);
      std::size_t                        b      = 0;
      for (WearingBushing &bushing : bushings)
        {
          wear(bushing,
               state.totals[b],
               depths[b],
               last_step * used_contacts[b].removed_area);
          ++b;
        }
      state.cycles += last_step;
      return reached;
    }



    void
    ConstantJump::update_stable_step(RunState &state)
    {
      // The bound follows the compliance, and costs an eigenvalue problem.
      unsigned int n_builds = 0;
      for (const WearingBushing &bushing : bushings)
        n_builds += bushing.n_compliance_builds();
      if (n_builds == stable_step_builds)
        return;

      state.max_stable_step = std::numeric_limits<double>::max();
      std::size_t b         = 0;
      for (const WearingBushing &bushing : bushings)
        state.max_stable_step =
          std::min(state.max_stable_step,
                   bushing.max_stable_step(state.contacts[b++]));
      stable_step_builds = n_builds;
    }



    std::vector<StepError>
    ConstantJump::estimate_error(
      const std::vector<CycleContact> &contacts_after,
      const double                     cycles_kept)
    {
      std::vector<StepError> errors;
      std::size_t            b = 0;
      for (const WearingBushing &bushing : bushings)
        {
          // Without kept rates the first term vanishes.
          const CycleContact &used = used_contacts[b];
          errors.push_back({Wear::euler_error(used.wear_rate,
                                              contacts_before[b].wear_rate,
                                              cycles_kept) +
                              Wear::euler_error(used.wear_rate,
                                                contacts_after[b].wear_rate,
                                                cycles_kept),
                            {}});
          const Eigen::VectorXd area_error =
            0.5 * cycles_kept *
            (contacts_before[b].removed_area + contacts_after[b].removed_area -
             2. * used.removed_area);
          std::size_t i = 0;
          for (const WearingSurface &surface : bushing.surfaces())
            errors.back().volumes[i++] =
              surface.part_of(area_error).sum() *
              bushing.bushing_parameters().axial_length;
          ++b;
        }
      return errors;
    }
  } // namespace Coupling
} // namespace Tribody

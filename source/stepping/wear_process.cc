// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/base/inverted_mesh.h>
#include <tribody/base/significant_digits.h>
#include <tribody/base/units.h>
#include <tribody/stepping/combined_loads.h>
#include <tribody/stepping/make_jump.h>
#include <tribody/stepping/wear_process.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Tribody
{
  namespace Coupling
  {
    WearProcess::WearProcess(const WearParameters        &parameters,
                             std::deque<WearingBushing> &&bushings,
                             const std::vector<double>   &wear_factors,
                             const std::vector<double>   &ambient_temperatures)
      : dynamics_update(parameters.dynamics_update)
      , joint_bushings(std::move(bushings))
      , stop_conditions(joint_bushings)
      , jump(make_jump(parameters, joint_bushings, stop_conditions))
      , factors(wear_factors)
      , ambient(ambient_temperatures)
    {
      AssertDimension(factors.size(), ambient.size());
      run_state.cycles_of_cases = Eigen::VectorXd::Zero(factors.size());
      for (const WearingBushing &bushing : joint_bushings)
        {
          JointState joint;
          joint.depth               = bushing.depth();
          joint.depth_at_compliance = bushing.depth_at_compliance();
          joint.totals.depth_error  = Eigen::VectorXd::Zero(joint.depth.size());
          run_state.joints.push_back(joint);
          ++run_state.counts.compliance_builds;
        }
    }



    void
    WearProcess::restore(const RunState &state)
    {
      bool fits = state.joints.size() == joint_bushings.size();
      for (std::size_t j = 0; fits && j < joint_bushings.size(); ++j)
        fits =
          state.joints[j].depth.size() == run_state.joints[j].depth.size() &&
          state.joints[j].depth_at_compliance.size() ==
            run_state.joints[j].depth_at_compliance.size();
      // One that has not begun has no load cases yet.
      const bool has_begun = !state.duty_cycles.empty();
      fits = fits && (!has_begun || state.duty_cycles.size() == factors.size());
      AssertThrow(fits,
                  ExcRun(
                    "The state is not one of these bushings: their number, "
                    "or that of their nodes or load cases, differs."));
      for (std::size_t j = 0; j < joint_bushings.size(); ++j)
        {
          joint_bushings[j].set_warmth(state.joints[j].warmth);
          joint_bushings[j].restore(state.joints[j].depth,
                                    state.joints[j].depth_at_compliance);
        }
      run_state = state;
    }



    void
    WearProcess::check_duty_cycle(const Multibody::DutyCycle &cycle) const
    {
      for (const WearingBushing &bushing : joint_bushings)
        {
          const auto &joint = cycle.joint(bushing.name());
          check_pin_in_bore(bushing, joint, cycle.time);
          check_strains(compute_least_strains(bushing, joint), bushing.name());
        }
    }



    void
    WearProcess::renew_duty_cycles(
      const std::vector<Multibody::DutyCycle> &cycles,
      const Eigen::VectorXd                   &shares)
    {
      AssertDimension(cycles.size(), factors.size());
      std::vector<bool> was_quasi_static;
      for (std::size_t i = 0; i < cycles.size(); ++i)
        was_quasi_static.push_back(i < run_state.duty_cycles.size() &&
                                   run_state.duty_cycles[i].is_quasi_static);
      // Wear under other load cases has nothing to do with the last step.
      if (run_state.shares.size() > 0 && run_state.shares != shares)
        run_state.stepper = StepperState();
      run_state.duty_cycles        = cycles;
      run_state.shares             = shares;
      run_state.cycles_at_dynamics = run_state.cycles;
      for (std::size_t j = 0; j < joint_bushings.size(); ++j)
        {
          JointState &joint        = run_state.joints[j];
          joint.depth_at_dynamics  = joint.depth;
          joint.warmth_at_dynamics = joint.warmth;
          joint.loads_of_cases.clear();
          for (const Multibody::DutyCycle &cycle : cycles)
            joint.loads_of_cases.push_back(make_loads(cycle, j));
          joint.loads = combine_loads(joint.loads_of_cases, shares, factors);
        }
      for (std::size_t i = 0; i < cycles.size(); ++i)
        if (shares[i] > 0.)
          add_to_dynamics_totals(cycles[i], was_quasi_static[i]);
    }



    Multibody::BearingLoads
    WearProcess::make_loads(const Multibody::DutyCycle &cycle,
                            const std::size_t           j) const
    {
      // Of the wear in all. Where it is deepest it may change by several times
      // as much, which is part of the estimated error.
      constexpr double merging_tolerance = 2e-4;
      // Of the wear where it is deepest; likewise.
      constexpr double thinning_tolerance = 1e-4;

      const unsigned int            n_cycles = cycle.settling.n_averaged_cycles;
      const CycleContact           &contact  = run_state.joints[j].contact;
      const Multibody::BearingLoads loads =
        merge_cycles(cycle.joint(joint_bushings[j].name()),
                     n_cycles,
                     merging_tolerance);
      // What wears the bushing alone, and in proportion to the force, is all
      // that is looked at.
      const std::vector<WearingSurface> surfaces = joint_bushings[j].surfaces();
      if (factors.size() == 1 || n_cycles > 1 || contact.samples.empty() ||
          surfaces.size() > 1 || !surfaces.front().law.is_constant())
        return loads;
      // Smaller forces have narrower contacts.
      const double part = loads.mean_normal_force() /
                          run_state.joints[j].loads.normal_force.maxCoeff();
      return thin_out(loads,
                      reach_of(contact) * std::sqrt(std::min(1., part)),
                      thinning_tolerance);
    }



    void
    WearProcess::thin_out_loads()
    {
      for (std::size_t j = 0; j < joint_bushings.size(); ++j)
        {
          JointState &joint = run_state.joints[j];
          for (std::size_t i = 0; i < factors.size(); ++i)
            joint.loads_of_cases[i] = make_loads(run_state.duty_cycles[i], j);
          joint.loads =
            combine_loads(joint.loads_of_cases, run_state.shares, factors);
        }
    }



    void
    WearProcess::add_to_dynamics_totals(const Multibody::DutyCycle &cycle,
                                        const bool was_quasi_static)
    {
      const Multibody::SettlingReport &settling = cycle.settling;
      run_state.counts.dynamics_cycles += settling.n_cycles;
      DynamicsTotals &totals       = run_state.dynamics;
      const bool gave_up_following = was_quasi_static && !cycle.is_quasi_static;
      if (!settling.message.empty() &&
          (totals.settling_message.empty() || gave_up_following))
        {
          // Without wear, the results say it right away.
          std::ostringstream message;
          if (!joint_bushings.empty())
            message << "after " << run_state.cycles << " cycles: ";
          message << settling.message;
          totals.settling_message +=
            (totals.settling_message.empty() ? "" : "; ") + message.str();
        }
      totals.constraint_drift =
        std::max(totals.constraint_drift, cycle.constraint_drift);
      if (!settling.converged && totals.all_settled)
        totals.unsettled_message = settling.message;
      totals.all_settled = totals.all_settled && settling.converged;
      totals.contact_losses.resize(cycle.joints.size());
      for (std::size_t j = 0; j < cycle.joints.size(); ++j)
        totals.contact_losses[j] += cycle.joints[j].n_losses;
    }



    bool
    WearProcess::duty_cycle_is_outdated() const
    {
      bool is_outdated = false;
      for (std::size_t j = 0; j < joint_bushings.size(); ++j)
        {
          const JointState     &joint   = run_state.joints[j];
          const WearingBushing &bushing = joint_bushings[j];
          double                change =
            (joint.depth - joint.depth_at_dynamics).lpNorm<Eigen::Infinity>();
          if (joint.warmth.is_known())
            {
              const double closed =
                joint.warmth.closing - joint.warmth_at_dynamics.closing;
              change += std::abs(closed);
              const WarmBushing &heat = *bushing.warm_bushing();
              const double       friction =
                heat.friction_factor(joint.warmth) /
                heat.friction_factor(joint.warmth_at_dynamics);
              is_outdated =
                is_outdated || std::abs(friction - 1.) > dynamics_update;
            }
          is_outdated =
            is_outdated ||
            change > dynamics_update * (bushing.largest_clearance(joint.depth) -
                                        joint.warmth.closing);
        }
      return is_outdated;
    }



    bool
    WearProcess::gets_warm() const
    {
      return std::any_of(joint_bushings.begin(),
                         joint_bushings.end(),
                         [](const WearingBushing &bushing) {
                           return bushing.warm_bushing() != nullptr;
                         });
    }



    void
    WearProcess::settle_warmth(const std::function<void()> &renew_motion)
    {
      // A round makes the difference several times smaller where friction
      // depends on the temperature as it usually does.
      constexpr unsigned int max_rounds = 50;
      // What lies in the way every time is no matter of the steps.
      constexpr unsigned int max_obstructed_rounds = 10;
      unsigned int           n_obstructed          = 0;
      if (!gets_warm())
        return;
      std::vector<WarmthIteration> iterations(joint_bushings.size());
      for (unsigned int round = 0; round < max_rounds; ++round)
        {
          const WarmthRound result = update_warmth(iterations);
          if (result.have_settled)
            return;
          n_obstructed = result.obstacle.empty() ? 0 : n_obstructed + 1;
          AssertThrow(n_obstructed < max_obstructed_rounds,
                      ExcRun(result.obstacle));
          ++run_state.counts.temperature_rounds;
          if (duty_cycle_is_outdated())
            renew_motion();
          solve_contacts();
        }
      for (std::size_t j = 0; j < joint_bushings.size(); ++j)
        if (const Warmth &warmth = run_state.joints[j].warmth;
            joint_bushings[j].warm_bushing() != nullptr &&
            warmth.residual > joint_bushings[j].warm_bushing()->tolerance())
          throw ExcRun(
            "Joint " + joint_bushings[j].name() +
            ": its temperature comes to no end. After " +
            std::to_string(max_rounds) +
            " rounds of motion, contact and temperature it is " +
            Units::to_string(warmth.contact_temperature, "K", "degC", 4) +
            " in the contact, and still " +
            significant_digits(warmth.residual, 2) +
            " K off: friction that rises with the temperature, or a clearance "
            "that is nearly gone, may let it. Look at the 'Friction factor' "
            "and at the clearance, or allow a larger 'Temperature "
            "tolerance'");
    }



    WearProcess::WarmthRound
    WearProcess::update_warmth(std::vector<WarmthIteration> &iterations)
    {
      WarmthRound round;
      double      time = 0., temperature_over_time = 0.;
      for (std::size_t i = 0; i < factors.size(); ++i)
        {
          const double of_case =
            run_state.shares[i] * run_state.duty_cycles[i].period;
          time += of_case;
          temperature_over_time += of_case * ambient[i];
        }
      for (std::size_t j = 0; j < joint_bushings.size(); ++j)
        if (const WarmBushing *heat = joint_bushings[j].warm_bushing())
          {
            JointState &joint    = run_state.joints[j];
            const auto  at_power = [&](const double power) {
              return heat->compute(joint.contact.force_over_sliding,
                                   power,
                                   temperature_over_time / time);
            };
            if (!joint.warmth.is_known())
              joint.warmth = at_power(0.);
            const Warmth found = at_power(frictional_power(j));
            const Warmth corrected =
              correct(joint.warmth, found, iterations[j]);
            if (corrected.residual <= heat->tolerance())
              {
                joint.warmth.power               = found.power;
                joint.warmth.shaft_power         = found.shaft_power;
                joint.warmth.ambient_temperature = found.ambient_temperature;
                joint.warmth.residual            = corrected.residual;
                iterations[j]                    = {};
                joint.totals.max_temperature =
                  std::max({joint.totals.max_temperature,
                            joint.warmth.max_temperature,
                            found.max_temperature});
                continue;
              }
            round.have_settled = false;
            if (const std::string obstacle =
                  become_warm(j, corrected, iterations[j]);
                !obstacle.empty())
              round.obstacle = obstacle;
          }
      return round;
    }



    std::string
    WearProcess::become_warm(const std::size_t j,
                             Warmth            warmth,
                             WarmthIteration  &iteration)
    {
      // A step may pass what the temperature that it is on its way to does
      // not.
      constexpr unsigned int max_halvings = 8;
      WearingBushing        &bushing      = joint_bushings[j];
      JointState            &joint        = run_state.joints[j];
      std::string            obstacle;
      for (unsigned int n = 0;; ++n)
        try
          {
            check_warmth(bushing, warmth);
            break;
          }
        catch (const ExcRun &exception)
          {
            if (n == max_halvings)
              throw;
            obstacle = message_of(exception);
            warmth   = between(joint.warmth, warmth, 0.5);
            iteration.relaxation *= 0.5;
          }
      const WarmBushing &heat = *bushing.warm_bushing();
      if (heat.modulus_factor(warmth) != heat.modulus_factor(joint.warmth))
        ++run_state.counts.compliance_builds;
      joint.warmth = warmth;
      bushing.set_warmth(warmth);
      joint.depth_at_compliance = bushing.depth_at_compliance();
      return obstacle;
    }



    double
    WearProcess::frictional_power(const std::size_t j) const
    {
      double work = 0., time = 0.;
      for (std::size_t i = 0; i < factors.size(); ++i)
        if (run_state.shares[i] > 0.)
          {
            const Multibody::DutyCycle      &cycle = run_state.duty_cycles[i];
            const Multibody::JointDutyCycle &of_joint =
              cycle.joint(joint_bushings[j].name());
            work +=
              run_state.shares[i] * of_joint.friction_force.cwiseAbs().dot(
                                      of_joint.sliding_increment);
            time += run_state.shares[i] * cycle.period;
          }
      return work / time;
    }



    void
    WearProcess::solve_contacts()
    {
      for (std::size_t j = 0; j < joint_bushings.size(); ++j)
        {
          JointState &joint = run_state.joints[j];
          joint.contact     = joint_bushings[j].compute_cycle_contact(
            joint.depth,
            joint.loads,
            joint.contact.samples.empty() ? nullptr : &joint.contact,
            joint.totals.sliding_distance);
          for (std::size_t i = 0; i < factors.size(); ++i)
            if (run_state.shares[i] > 0.)
              joint.totals.strains.widen(compute_strains(
                joint_bushings[j],
                run_state.duty_cycles[i].joint(joint_bushings[j].name()),
                joint.contact));
          check_strains(joint.totals.strains, joint_bushings[j].name());
        }
      count_rate_evaluations(1);
    }



    WearStep
    WearProcess::advance(double end)
    {
      // Beyond the wall there is no contact to be found for the stages of a
      // long step; rates change little on the way there.
      constexpr double beyond_wall = 1.25;
      for (std::size_t j = 0; j < joint_bushings.size(); ++j)
        end = std::min(end,
                       run_state.cycles +
                         beyond_wall * joint_bushings[j].cycles_to_wear_through(
                                         run_state.joints[j].contact));

      // Of the cycles so far; a life need not be known better.
      constexpr double   shortest_last_step = 1e-3;
      const StepperState before             = run_state.stepper;
      while (true)
        {
          WearStep step;
          try
            {
              step = jump->advance(run_state, end);
              for (std::size_t j = 0; j < joint_bushings.size(); ++j)
                joint_bushings[j].set_depth(step.depths[j]);
              return step;
            }
          catch (const ExcInvertedMesh &)
            {
              run_state.stepper = before;
              restore(run_state);
              const double n_cycles = step.cycles - run_state.cycles;
              if (n_cycles <= shortest_last_step * run_state.cycles)
                throw;
              end = run_state.cycles + 0.5 * n_cycles;
            }
          catch (...)
            {
              // Whatever it is: other ranks are told that a run has failed.
              run_state.stepper = before;
              restore(run_state);
              throw;
            }
        }
    }



    void
    WearProcess::take_step(const double end)
    {
      const WearStep step = advance(end);
      for (std::size_t j = 0; j < joint_bushings.size(); ++j)
        {
          JointState            &joint = run_state.joints[j];
          const Eigen::VectorXd &built =
            joint_bushings[j].depth_at_compliance();
          if (built != joint.depth_at_compliance)
            ++run_state.counts.compliance_builds;
          joint.depth               = step.depths[j];
          joint.depth_at_compliance = built;
          add_to_joint_totals(step, j);
        }
      const double n_cycles = step.cycles - run_state.cycles;
      for (std::size_t i = 0; i < factors.size(); ++i)
        {
          const double of_case = n_cycles * run_state.shares[i];
          run_state.cycles_of_cases[i] += of_case;
          run_state.operating_time += of_case * run_state.duty_cycles[i].period;
        }
      run_state.cycles = step.cycles;
      if (step.reached)
        run_state.stopped_by = stop_conditions.describe(*step.reached);
      count_rate_evaluations(step.n_rate_evaluations);
      ++run_state.counts.wear_steps;
    }



    void
    WearProcess::add_to_joint_totals(const WearStep &step, const std::size_t j)
    {
      const WearingBushing &bushing  = joint_bushings[j];
      const double          n_cycles = step.cycles - run_state.cycles;
      JointState           &joint    = run_state.joints[j];
      JointTotals          &totals   = joint.totals;
      // The errors count as much as each case wears.
      double     force_over_sliding = 0.;
      DutyErrors errors;
      for (std::size_t i = 0; i < factors.size(); ++i)
        if (run_state.shares[i] > 0.)
          {
            const Multibody::DutyCycle      &cycle = run_state.duty_cycles[i];
            const Multibody::JointDutyCycle &of_joint =
              cycle.joint(bushing.name());
            const double distance =
              n_cycles * run_state.shares[i] * of_joint.sliding_distance();
            const double weight =
              distance * of_joint.mean_normal_force() * factors[i];
            totals.sliding_distance += distance;
            force_over_sliding += weight;
            errors.add(weight,
                       estimate_duty_errors(cycle,
                                            of_joint,
                                            joint.loads_of_cases[i],
                                            reach_of(joint.contact)));
          }
      totals.force_over_sliding += force_over_sliding;
      if (force_over_sliding > 0.)
        totals.duty_errors.add(n_cycles / force_over_sliding, errors);
      const std::vector<WearingSurface> surfaces = bushing.surfaces();
      for (std::size_t i = 0; i < surfaces.size(); ++i)
        totals.surfaces[i].removed_volume +=
          surfaces[i].part_of(step.removed_areas[j]).sum() *
          bushing.bushing_parameters().axial_length;
    }



    void
    WearProcess::complete_step(const double kept_since)
    {
      solve_contacts();
      const std::vector<StepError> errors =
        jump->estimate_error(run_state, run_state.cycles - kept_since);
      // Absolute values: an oscillation must not cancel in the sum.
      for (std::size_t j = 0; j < errors.size(); ++j)
        {
          JointTotals &totals = run_state.joints[j].totals;
          totals.depth_error += errors[j].depth.cwiseAbs();
          for (std::size_t i = 0; i < errors[j].volumes.size(); ++i)
            totals.surfaces[i].volume_error += std::abs(errors[j].volumes[i]);
        }
    }



    void
    WearProcess::count_rate_evaluations(const unsigned int n)
    {
      run_state.counts.rate_evaluations += n;
      for (const JointState &joint : run_state.joints)
        run_state.counts.contact_solves += n * joint.contact.samples.size();
    }
  } // namespace Coupling
} // namespace Tribody

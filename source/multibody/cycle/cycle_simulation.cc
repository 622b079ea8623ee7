// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/base/significant_digits.h>
#include <tribody/multibody/cycle/cycle_recorder.h>
#include <tribody/multibody/cycle/cycle_simulation.h>
#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/multibody/motion/energy_account.h>
#include <tribody/multibody/motion/intermittent_motion.h>
#include <tribody/multibody/motion/slow_motion_start.h>
#include <tribody/multibody/motion/static_equilibrium.h>
#include <tribody/multibody/system/kinematics.h>

#include <algorithm>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      double
      cycle_duration(const Mechanism          &mechanism,
                     const DynamicsParameters &parameters)
      {
        if (parameters.cycle_duration > 0)
          return parameters.cycle_duration;
        // Equilibrium knows time only by what the drivers prescribe.
        if (parameters.analysis == Analysis::static_equilibrium &&
            !mechanism.has_turning_driver())
          return 1.;
        return mechanism.period();
      }
    } // namespace



    CycleSimulation::CycleSimulation(const Mechanism          &mechanism,
                                     const DynamicsParameters &parameters)
      : mechanism(mechanism)
      , parameters(parameters)
      , closed_mechanism(with_ideal_joints(mechanism.parameters()))
      , closed_equations(closed_mechanism, {})
      , period(cycle_duration(mechanism, parameters))
    {
      parameters.check();
      const EquationsOfMotion equations(mechanism,
                                        nominal_clearances(mechanism));
      const Eigen::VectorXd   q = assemble_configuration(closed_equations, 0.);
      check_redundancy(equations, q);
      if (!mechanism.has_only_ideal_joints() &&
          closed_mechanism.n_degrees_of_freedom() <= 0)
        check_redundancy(closed_equations, q);
      check_analysis();
      if (!is_kinematic() &&
          parameters.analysis != Analysis::static_equilibrium)
        check_masses(equations, q);
      if (closed_mechanism.n_degrees_of_freedom() == 0)
        check_full_cycle(closed_equations,
                         period,
                         2 * parameters.samples_per_cycle);
    }



    std::vector<ReferenceScale>
    CycleSimulation::reference_scales(const Supports &supports) const
    {
      return compute_reference_scales(mechanism,
                                      closed_equations,
                                      period,
                                      collect_supports(supports));
    }



    bool
    CycleSimulation::is_kinematic() const
    {
      return parameters.analysis == Analysis::kinematic;
    }



    void
    CycleSimulation::check_analysis() const
    {
      if (!is_kinematic() && parameters.analysis != Analysis::inverse_dynamics)
        return;
      const std::string needs = "'" + name_of(parameters.analysis) +
                                "' needs a mechanism whose motion is given by "
                                "joints and drivers, but ";
      const int n = mechanism.n_degrees_of_freedom();
      for (const JointEntry &joint : mechanism.joints())
        AssertThrow(!joint.has_gap(),
                    ExcParameter("Dynamics/Analysis",
                                 needs + "joint '" + joint.name +
                                   "' has clearance. Write 'set Model = ideal' "
                                   "there, or 'dynamic'"));
      AssertThrow(n == 0,
                  ExcParameter("Dynamics/Analysis",
                               needs + "this one has " + std::to_string(n) +
                                 (n == 1 ? " degree" : " degrees") +
                                 " of freedom left. Add as many drivers, or "
                                 "write 'dynamic' or 'static equilibrium'"));
    }



    DutyCycle
    CycleSimulation::run(const Clearances &clearances,
                         const Supports   &supports) const
    {
      const EquationsOfMotion equations(mechanism,
                                        collect_clearances(clearances),
                                        collect_supports(supports));
      if (parameters.analysis == Analysis::static_equilibrium)
        return run_statics(equations);
      // A joint with clearance that adds to a mechanism without degrees of
      // freedom is redundant, which the constructor has seen.
      const bool moves_as_given = mechanism.n_degrees_of_freedom() == 0 &&
                                  mechanism.has_only_ideal_joints();
      return moves_as_given && parameters.analysis != Analysis::dynamic
               ? run_kinematics(equations)
               : run_dynamics(equations, reference_scales(supports));
    }



    std::vector<JointClearance>
    CycleSimulation::collect_clearances(const Clearances &by_name) const
    {
      std::vector<JointClearance> clearances = nominal_clearances(mechanism);
      unsigned int                n_used     = 0;
      for (unsigned int j = 0; j < clearances.size(); ++j)
        {
          const auto found = by_name.find(mechanism.clearance_joints()[j].name);
          if (found != by_name.end())
            {
              clearances[j] = found->second;
              ++n_used;
            }
        }
      Assert(n_used == by_name.size(),
             dealii::ExcMessage("A clearance was given for a joint that does "
                                "not exist or has none."));
      (void)n_used;
      return clearances;
    }



    EquationsOfMotion::Supports
    CycleSimulation::collect_supports(const Supports &by_name) const
    {
      EquationsOfMotion::Supports supports;
      for (const ClearanceJoint &joint : mechanism.clearance_joints())
        {
          const auto found = by_name.find(joint.name);
          const bool has_support =
            found != by_name.end() && needs_support(joint.contact_law);
          supports.push_back(has_support ? found->second : nullptr);
          AssertThrow(supports.back() != nullptr ||
                        !needs_support(joint.contact_law),
                      ExcParameter("Joint " + joint.name + "/Contact force law",
                                   "'finite element' needs the elasticity of "
                                   "the joint's bushing"));
        }
      return supports;
    }



    double
    CycleSimulation::record_time(const unsigned int k) const
    {
      const double t = (k - 1.) * period / (2 * parameters.samples_per_cycle);
      const bool   repeats =
        parameters.cycle_duration == 0 && mechanism.has_turning_driver();
      return repeats ? t : std::max(0., t);
    }



    DutyCycle
    CycleSimulation::run_kinematics(const EquationsOfMotion &equations) const
    {
      const unsigned int      n = parameters.samples_per_cycle;
      CycleRecorder           recorder(equations, n, period);
      const ConstraintOffsets none(mechanism.n_constraints());
      MechanismState          state;
      state.q            = assemble_configuration(equations, 0.);
      const auto move_to = [&](const double t) -> Accelerations {
        state.time = t;
        if (is_kinematic())
          {
            const SolverReport report =
              solve_positions(equations, t, none, state.q);
            AssertThrow(report.converged,
                        ExcRun("At time " + significant_digits(t, 6) +
                               " s the mechanism has no position near the one "
                               "before: " +
                               report.message));
            state.v = compute_velocities(equations, t, none, state.q);
            return {
              compute_kinematic_accelerations(equations, t, state.q, state.v),
              Eigen::VectorXd::Zero(mechanism.n_constraints())};
          }
        const Motion motion =
          solve_motion(equations,
                       t,
                       none,
                       Eigen::VectorXd::Zero(mechanism.n_coordinates()),
                       state.q);
        state.q = motion.q;
        state.v = motion.v;
        return {motion.a, motion.multipliers};
      };
      EnergyAccount account(equations);
      const bool    keeps_account =
        parameters.energy_balance == EnergyBalance::always && !is_kinematic();
      if (keeps_account)
        recorder.set_energy_account(&account);
      for (unsigned int k = 0; k <= 2 * n; ++k)
        {
          const double   t = record_time(k);
          MechanismState middle;
          if (keeps_account && k > 0)
            {
              move_to((record_time(k - 1) + t) / 2);
              middle = state;
            }
          const Accelerations accelerations = move_to(t);
          if (keeps_account && k > 0)
            account.advance(middle, state);
          if (keeps_account && k == 0)
            account.open(state);
          recorder.record(k, state, accelerations);
        }
      DutyCycle cycle          = recorder.make_duty_cycle({});
      cycle.settling.n_cycles  = 1;
      cycle.settling.converged = true;
      return cycle;
    }



    DutyCycle
    CycleSimulation::run_statics(const EquationsOfMotion &equations) const
    {
      const unsigned int      n = parameters.samples_per_cycle;
      CycleRecorder           recorder(equations, n, period);
      const ConstraintOffsets none(mechanism.n_constraints());
      const Eigen::VectorXd   zero =
        Eigen::VectorXd::Zero(mechanism.n_coordinates());
      MechanismState state;
      state.q = assemble_configuration(closed_equations, 0.);
      state.v = zero;
      for (const ClearanceJoint &joint : mechanism.clearance_joints())
        state.approach_speeds.push_back(joint.minimum_approach_speed);
      for (unsigned int k = 0; k <= 2 * n; ++k)
        {
          state.time = record_time(k);
          const SolverReport closed =
            solve_positions(equations, state.time, none, state.q);
          AssertThrow(closed.converged,
                      ExcRun("At time " + significant_digits(state.time, 6) +
                             " s there is no position:" +
                             explain_end_of_motion(
                               equations, state.time, state.time, state.q)));
          const StaticEquilibrium equilibrium =
            solve_static_equilibrium(equations, state.time, state.q);
          AssertThrow(equilibrium.report.converged,
                      ExcRun(equilibrium.report.message));
          state.q = equilibrium.q;
          recorder.record(k, state, {zero, equilibrium.multipliers});
        }
      DutyCycle cycle          = recorder.make_duty_cycle({});
      cycle.settling.n_cycles  = 1;
      cycle.settling.converged = true;
      return cycle;
    }



    StartingState
    CycleSimulation::compute_start(const EquationsOfMotion &equations) const
    {
      StartingState start =
        compute_centred_start(equations, closed_equations, 0.);
      if (parameters.start == MotionStart::static_equilibrium)
        {
          const StaticEquilibrium equilibrium =
            solve_static_equilibrium(equations, 0., start.state.q);
          AssertThrow(equilibrium.report.converged,
                      ExcRun("For 'Dynamics/Start = static equilibrium', " +
                             equilibrium.report.message));
          start.state.q = equilibrium.q;
          start.state.v =
            compute_initial_velocities(equations, 0., start.state.q);
          return start;
        }
      if (parameters.start == MotionStart::centred ||
          mechanism.has_only_ideal_joints())
        return start;
      if (closed_mechanism.n_degrees_of_freedom() != 0)
        {
          start.report.message =
            "with free degrees of freedom there is no start in slow motion; "
            "the pins began in the middle of their bushings";
          return start;
        }
      std::string reason;
      try
        {
          StartingState slow = compute_slow_motion_start(equations,
                                                         closed_equations,
                                                         0.,
                                                         period / 360);
          if (slow.report.converged)
            return slow;
          reason = slow.report.message;
        }
      catch (const ExcRun &error)
        {
          // The ideal mechanism moves, as the constructor has seen: it is the
          // offsets of the pins that have grown too large.
          reason = message_of(error);
        }
      start.report.message =
        "no start in slow motion was found, so that the pins began in the "
        "middle of their bushings (" +
        reason + ")";
      return start;
    }



    unsigned long
    CycleSimulation::record_cycles(const double        begins,
                                   const unsigned int  n_cycles,
                                   IntermittentMotion &integrator,
                                   CycleRecorder      &recorder) const
    {
      const unsigned int  n         = parameters.samples_per_cycle;
      const unsigned long n_steps   = integrator.statistics().n_steps;
      const unsigned long n_allowed = static_cast<unsigned long>(n_cycles) *
                                      parameters.maximum_steps_per_cycle;
      unsigned long n_taken = 0;
      for (unsigned int k = 0; k <= 2 * n * n_cycles; ++k)
        {
          // The first cycle lacks the half interval before time 0.
          const double          t = std::max(0., begins + k * period / (2 * n));
          const MechanismState &state =
            integrator.advance_to(t, n_allowed, n_taken);
          recorder.record(k, state, integrator.present_equations());
          n_taken = integrator.statistics().n_steps - n_steps;
        }
      return n_taken;
    }



    SettlingReport
    CycleSimulation::settle(IntermittentMotion &integrator,
                            CycleRecorder      &recorder,
                            unsigned long      &n_steps_in_cycle) const
    {
      const double half_interval = period / (2 * parameters.samples_per_cycle);
      SettlingReport settling;
      settling.n_cycles = 1;
      if (parameters.maximum_settling_cycles == 0)
        {
          n_steps_in_cycle =
            record_cycles(-half_interval, 1, integrator, recorder);
          settling.converged = true;
          return settling;
        }
      CycleRecorder before(recorder);
      record_cycles(-half_interval, 1, integrator, before);

      while (true)
        {
          n_steps_in_cycle =
            record_cycles(settling.n_cycles * period - half_interval,
                          1,
                          integrator,
                          recorder);
          ++settling.n_cycles;
          settling.repeat_difference = recorder.difference(before);
          settling.converged =
            settling.repeat_difference < parameters.settling_tolerance;
          if (settling.converged ||
              settling.n_cycles > parameters.maximum_settling_cycles)
            break;
          before.swap_records(recorder);
        }
      return settling;
    }



    DutyCycle
    CycleSimulation::record_average(const EquationsOfMotion &equations,
                                    const EnergyAccount     *account,
                                    const unsigned int       n_cycles_before,
                                    IntermittentMotion      &integrator) const
    {
      const unsigned int n         = parameters.averaged_cycles;
      const unsigned int n_samples = parameters.samples_per_cycle;
      CycleRecorder      recorder(equations, n * n_samples, n * period);
      recorder.set_energy_account(account);
      const double begins = n_cycles_before * period - period / (2 * n_samples);
      const unsigned long n_steps =
        record_cycles(begins, n, integrator, recorder);
      DutyCycle cycle = recorder.make_duty_cycle(integrator.events());
      cycle.average_over(n);
      cycle.n_steps_in_cycle = n_steps / n;
      return cycle;
    }



    DutyCycle
    CycleSimulation::run_dynamics(
      const EquationsOfMotion           &equations,
      const std::vector<ReferenceScale> &scales) const
    {
      MotionTolerances tolerances =
        make_tolerances(mechanism, scales, parameters);
      tolerances.maximum_step = period / parameters.samples_per_cycle;
      IntermittentMotion  integrator(equations, tolerances);
      const StartingState start = compute_start(equations);
      integrator.start(start.state);

      CycleRecorder recorder(equations, parameters.samples_per_cycle, period);
      EnergyAccount account(equations);
      const bool    keeps_account =
        parameters.energy_balance == EnergyBalance::always;
      if (keeps_account)
        {
          integrator.set_energy_account(&account);
          recorder.set_energy_account(&account);
        }
      SettlingReport settling;
      DutyCycle      cycle;
      try
        {
          unsigned long n_steps_in_cycle = 0;
          settling = settle(integrator, recorder, n_steps_in_cycle);
          if (settling.converged || parameters.averaged_cycles == 1)
            {
              cycle = recorder.make_duty_cycle(integrator.events());
              cycle.n_steps_in_cycle = n_steps_in_cycle;
            }
          else
            {
              cycle                      = record_average(equations,
                                     keeps_account ? &account : nullptr,
                                     settling.n_cycles,
                                     integrator);
              settling.n_averaged_cycles = parameters.averaged_cycles;
            }
        }
      catch (const ExcRun &error)
        {
          const MechanismState &last = integrator.state();
          const std::string     reason =
            explain_end_of_motion(equations,
                                  last.time,
                                  last.time +
                                    period / parameters.samples_per_cycle,
                                  last.q);
          throw ExcRun(message_of(error) +
                       (reason.empty() ? "" : " Note that" + reason + "."));
        }
      settling.message = start.report.message;
      if (!settling.converged)
        {
          settling.message +=
            std::string(settling.message.empty() ? "" : "; ") +
            "the joint forces still changed by " +
            significant_digits(100 * settling.repeat_difference) +
            " % of the largest one from cycle to cycle after " +
            std::to_string(settling.n_cycles) + " cycles";
          if (settling.n_averaged_cycles > 1)
            settling.message += "; the results are over the " +
                                std::to_string(settling.n_averaged_cycles) +
                                " cycles after that";
        }
      settling.n_cycles +=
        settling.n_averaged_cycles > 1 ? settling.n_averaged_cycles : 0;

      cycle.settling         = settling;
      cycle.constraint_drift = integrator.constraint_drift();
      cycle.statistics       = integrator.statistics();
      for (unsigned int j = 0; j < cycle.joints.size(); ++j)
        if (mechanism.joints()[j].has_contact_law())
          cycle.joints[j].peak_force_since_start =
            integrator.peak_forces()[mechanism.joints()[j].index];
        else
          cycle.joints[j].peak_force_since_start = cycle.joints[j].peak_force();
      return cycle;
    }
  } // namespace Multibody
} // namespace Tribody

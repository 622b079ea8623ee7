// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/base/significant_digits.h>
#include <tribody/multibody/assembly/assembly_checks.h>
#include <tribody/multibody/assembly/redundancy.h>
#include <tribody/multibody/cycle/creep.h>
#include <tribody/multibody/cycle/cycle_recorder.h>
#include <tribody/multibody/cycle/cycle_simulation.h>
#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/multibody/cycle/integrated_cycle.h>
#include <tribody/multibody/cycle/integration_accuracy.h>
#include <tribody/multibody/elements/smoothness.h>
#include <tribody/multibody/following/followed_cycle.h>
#include <tribody/multibody/following/slow_motion_start.h>
#include <tribody/multibody/motion/energy_account.h>
#include <tribody/multibody/system/given_start.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/static_equilibrium.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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



      // Beyond the first limit they are told, beyond the second pins do not
      // follow their bores: shares of the forces that inertia would change.
      constexpr double noted_inertia = 0.02, largest_inertia = 0.1;

      // Share of the wear that it would change, from which on a motion is
      // integrated where that is left to the program.
      constexpr double tolerated_wear = 5e-3;
      constexpr double any_wear       = std::numeric_limits<double>::infinity();

      // Steps in a cycle, seconds of processor time, after which an integration
      // that is only the better way is given up: in worn bores a pin that
      // touches in two places may jump between them without end.
      constexpr unsigned int steps_worth_trying = 50000;

      // Set them in the joints of cycle. Throws ExcRun beyond the limits: of
      // the share, and of that of the wear.
      void
      judge_neglected_inertia(const FollowingPins                 &pins,
                              const std::vector<NeglectedInertia> &neglected,
                              const double                         largest_wear,
                              DutyCycle                           &cycle)
      {
        for (std::size_t p = 0; p < neglected.size(); ++p)
          {
            const NeglectedInertia &inertia = neglected[p];
            JointDutyCycle         &joint   = cycle.joints[pins.joints()[p]];
            joint.neglected_inertia         = inertia.share;
            joint.wear_of_neglected_inertia = inertia.of_wear;
            if (inertia.share <= noted_inertia &&
                inertia.of_wear <= largest_wear)
              continue;
            std::string text =
              "the inertia of the pin's motion in its bore, which a "
              "quasi-static joint leaves out, would change the force of joint "
              "'" +
              joint.name + "' by " +
              significant_digits(100 * inertia.share, 3) +
              " % on the average over its sliding, and its wear by " +
              significant_digits(100 * inertia.of_wear, 2) + " %";
            if (inertia.lifting_share > 0.)
              text += "; it would lift the pin off in " +
                      significant_digits(100 * inertia.lifting_share, 2) +
                      " % of the cycle, most at time " +
                      significant_digits(inertia.time, 6) + " s";
            AssertThrow(inertia.share <= largest_inertia,
                        ExcRun(text +
                               ". With more than 10 % a pin does not follow "
                               "its bore: choose 'Dynamics/Joint motion = "
                               "dynamic'"));
            AssertThrow(inertia.of_wear <= largest_wear, ExcRun(text));
            cycle.settling.message +=
              (cycle.settling.message.empty() ? "is quasi-static: " : "; ") +
              text;
          }
      }



      bool
      neglects_more_than_tolerated(const DutyCycle &cycle)
      {
        return std::any_of(cycle.joints.begin(),
                           cycle.joints.end(),
                           [](const JointDutyCycle &joint) {
                             return joint.wear_of_neglected_inertia >
                                    tolerated_wear;
                           });
      }



      // For the user, after what the start had to say. If the motion was not
      // expected to repeat, the report is that of the last one that was.
      std::string
      describe_settling(const SettlingReport &settling,
                        const bool            was_expected,
                        const std::string    &of_start)
      {
        std::string message = of_start;
        if (settling.converged)
          return message;
        const unsigned int n_settling =
          settling.n_cycles -
          (settling.n_averaged_cycles > 1 ? settling.n_averaged_cycles : 0);
        message +=
          std::string(message.empty() ? "" : "; ") +
          "joint forces, sliding or velocities still changed by " +
          significant_digits(100 * settling.repeat_difference) +
          " % of the largest one from cycle to cycle " +
          (was_expected ? "after " + std::to_string(n_settling) + " cycles"
                        : "when they were last given the time to settle");
        if (std::isfinite(settling.distance))
          message += ", at a rate that leaves " +
                     significant_digits(100 * settling.distance, 2) +
                     " % to a motion that repeats";
        if (settling.n_averaged_cycles > 1)
          message += "; the results are over the " +
                     std::to_string(settling.n_averaged_cycles) +
                     " cycles after that";
        return message;
      }



      // Gaps may allow what closed joints do not.
      MechanismParameters
      close_gaps(const Mechanism &mechanism)
      {
        return mechanism.has_only_ideal_joints()
                 ? mechanism.parameters()
                 : count_redundant_constraints(
                     with_ideal_joints(mechanism.parameters()));
      }
    } // namespace



    CycleSimulation::CycleSimulation(const Mechanism          &mechanism,
                                     const DynamicsParameters &parameters)
      : mechanism(mechanism)
      , parameters(parameters)
      , closed_mechanism(close_gaps(mechanism))
      , closed_equations(closed_mechanism, {})
      , marker_watch(closed_equations,
                     parameters.analysis == Analysis::static_equilibrium
                       ? IdealMotion::at_rest
                       : IdealMotion::prescribed)
      , period(cycle_duration(mechanism, parameters))
    {
      parameters.check();
      const EquationsOfMotion equations(mechanism,
                                        nominal_clearances(mechanism));
      const Eigen::VectorXd   q = assemble_configuration(closed_equations, 0.);
      check_redundancy(equations, q);
      premises = describe_redundancy(equations, q);
      if (const std::string change = explain_changed_start(closed_equations, q);
          !change.empty())
        premises += (premises.empty() ? "" : "; ") + ("begins where " + change);
      if (!mechanism.has_only_ideal_joints() &&
          closed_mechanism.n_degrees_of_freedom() <= 0)
        check_redundancy(closed_equations, q);
      check_analysis();
      check_drivers();
      if (!is_kinematic() &&
          parameters.analysis != Analysis::static_equilibrium)
        check_masses(equations, q);
      if (closed_mechanism.n_degrees_of_freedom() == 0)
        check_full_cycle(closed_equations,
                         period,
                         2 * parameters.samples_per_cycle);
      // Whoever says how long a cycle is may want a part of the motion.
      if (parameters.cycle_duration == 0 && mechanism.has_turning_driver())
        check_repetition();
    }



    void
    CycleSimulation::check_repetition() const
    {
      if (closed_mechanism.n_degrees_of_freedom() == 0)
        check_return(closed_equations,
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
      if (parameters.joint_motion == JointMotion::quasi_static)
        {
          const std::string reason =
            FollowingPins::explain_unsuitable(mechanism, closed_mechanism);
          AssertThrow(reason.empty(),
                      ExcParameter("Dynamics/Joint motion",
                                   "cannot be 'quasi-static', as " + reason +
                                     ". Write 'automatic' or 'dynamic'"));
        }
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



    void
    CycleSimulation::check_drivers() const
    {
      // Positions alone may jump.
      if (parameters.analysis == Analysis::static_equilibrium)
        return;
      const bool   goes_on = parameters.maximum_settling_cycles > 0;
      const double end     = (goes_on ? 2. : 1.) * period;
      for (std::size_t d = 0; d < mechanism.drivers().size(); ++d)
        {
          const DriverMotion &motion = mechanism.drivers()[d].motion;
          if (motion.amplitude == 0.)
            continue;
          const auto roughness =
            find_roughness([&](const double t) { return motion.value(t); },
                           0.,
                           end);
          AssertThrow(
            !roughness,
            ExcParameter("Driver " + mechanism.parameters().drivers[d].name +
                           "/Time function",
                         std::string("jumps at t = ") +
                           significant_digits(roughness->time, 6) + " s" +
                           (roughness->is_jump ? "" : " in its velocity") +
                           ". Bodies cannot follow that; forces need a driver "
                           "with two continuous derivatives. Round it off over "
                           "a time that the machine takes for it"));
        }
    }



    DutyCycle
    CycleSimulation::run(const Clearances &clearances,
                         const Supports   &supports,
                         const Arcs       &arcs,
                         const DutyCycle  *before) const
    {
      DutyCycle    cycle   = find_cycle(clearances, supports, arcs, before);
      std::string &message = cycle.settling.message;
      if (!premises.empty())
        message = premises + (message.empty() ? "" : "; ") + message;
      cycle.watched_paths = marker_watch.compare(cycle.time, cycle.coordinates);
      return cycle;
    }



    DutyCycle
    CycleSimulation::find_cycle(const Clearances &clearances,
                                const Supports   &supports,
                                const Arcs       &arcs,
                                const DutyCycle  *before) const
    {
      const EquationsOfMotion equations(mechanism,
                                        collect_clearances(clearances),
                                        collect_supports(supports));
      if (parameters.analysis == Analysis::static_equilibrium)
        return refine_samples(arcs, [&](const unsigned int n) {
          return run_statics(equations, n);
        });
      // A joint with clearance that adds to a mechanism without degrees of
      // freedom is redundant, which the constructor has seen.
      const bool moves_as_given = mechanism.n_degrees_of_freedom() == 0 &&
                                  mechanism.has_only_ideal_joints();
      if (moves_as_given && parameters.analysis != Analysis::dynamic)
        return refine_samples(arcs, [&](const unsigned int n) {
          return run_kinematics(equations, n);
        });
      return may_follow() ? run_joints_with_gaps(equations,
                                                 reference_scales(supports),
                                                 arcs,
                                                 before)
                          : run_dynamics(equations,
                                         reference_scales(supports),
                                         arcs,
                                         before,
                                         parameters.maximum_steps_per_cycle);
    }



    DutyCycle
    CycleSimulation::refine_samples(
      const Arcs                                         &arcs,
      const std::function<DutyCycle(const unsigned int)> &run_with) const
    {
      unsigned int n     = parameters.samples_per_cycle;
      DutyCycle    cycle = run_with(n);
      while (needs_more_samples(cycle, arcs, n))
        cycle = run_with(n *= 2);
      return cycle;
    }



    bool
    CycleSimulation::needs_more_samples(const DutyCycle   &cycle,
                                        const Arcs        &arcs,
                                        const unsigned int n) const
    {
      // Impacts that come at another time in each cycle need more cycles, not
      // samples.
      const unsigned int most = cycle.settling.n_averaged_cycles == 1 ? 16 : 4;
      if (parameters.sampling_tolerance == 0. ||
          n >= most * parameters.samples_per_cycle)
        return false;
      return std::any_of(cycle.joints.begin(),
                         cycle.joints.end(),
                         [&](const JointDutyCycle &joint) {
                           return joint.sampling_error(reach_of(joint, arcs)) >
                                  parameters.sampling_tolerance;
                         });
    }



    bool
    CycleSimulation::may_follow() const
    {
      return parameters.joint_motion != JointMotion::dynamic && can_follow();
    }



    bool
    CycleSimulation::can_follow() const
    {
      return !mechanism.has_only_ideal_joints() &&
             FollowingPins::explain_unsuitable(mechanism, closed_mechanism)
               .empty();
    }



    DutyCycle
    CycleSimulation::run_joints_with_gaps(
      const EquationsOfMotion           &equations,
      const std::vector<ReferenceScale> &scales,
      const Arcs                        &arcs,
      const DutyCycle                   *before) const
    {
      const auto follow = [&](const double largest_wear) {
        return refine_samples(arcs, [&](const unsigned int n) {
          return run_following(equations, n, largest_wear);
        });
      };
      if (parameters.joint_motion == JointMotion::quasi_static)
        return follow(any_wear);
      // A motion that is integrated goes on, and so does one that could not be.
      const bool goes_on = before != nullptr && before->end;
      const bool gave_up = before != nullptr && before->is_quasi_static &&
                           neglects_more_than_tolerated(*before);
      std::string reason;
      if (!goes_on)
        try
          {
            return follow(gave_up ? any_wear : tolerated_wear);
          }
        catch (const ExcRun &error)
          {
            reason = message_of(error);
          }
      // Following is right to what it neglects, if it is not beyond its limits.
      std::optional<DutyCycle> following;
      try
        {
          following = follow(any_wear);
        }
      catch (const ExcRun &)
        {}
      DutyCycle cycle;
      try
        {
          cycle = run_dynamics(equations,
                               scales,
                               arcs,
                               before,
                               following
                                 ? std::min(steps_worth_trying,
                                            parameters.maximum_steps_per_cycle)
                                 : parameters.maximum_steps_per_cycle);
        }
      catch (const ExcRun &error)
        {
          AssertThrow(following || reason.empty(),
                      ExcRun(message_of(error) +
                             " It was integrated, as pins do not follow their "
                             "bores (" +
                             reason + ")."));
          if (!following)
            throw;
          std::string &message = following->settling.message;
          message =
            (message.empty() ? "is quasi-static: it" : message + "; it") +
            " could not be integrated instead (" + message_of(error) + ')';
          return *following;
        }
      if (!goes_on)
        {
          std::string &message = cycle.settling.message;
          message = "was integrated, as pins do not follow their bores (" +
                    reason + ")" + (message.empty() ? "" : "; ") + message;
        }
      return cycle;
    }



    DutyCycle
    CycleSimulation::run_following(const EquationsOfMotion &equations,
                                   const unsigned int       n,
                                   const double             largest_wear) const
    {
      CycleRecorder       recorder(equations, n, period);
      const FollowingPins pins(equations, closed_equations);
      EnergyAccount       account(equations);
      const bool          keeps_account =
        parameters.energy_balance == EnergyBalance::always;
      if (keeps_account)
        recorder.set_energy_account(&account);
      // What was before time 0 is the end of the cycle before.
      // The motion of the pins needs so many instants at least.
      constexpr unsigned int least_instants = 128;
      const unsigned int  per_record = (least_instants + 2 * n - 1) / (2 * n);
      std::vector<double> times;
      for (unsigned int i = 0; i <= 2 * n * per_record; ++i)
        times.push_back((static_cast<double>(i) / per_record - 1.) * period /
                        (2 * n));
      const FollowedCycle followed =
        follow_cycle(pins, times, assemble_configuration(closed_equations, 0.));
      for (unsigned int k = 0; k <= 2 * n; ++k)
        {
          const FollowingInstant &now = followed.instants[k * per_record];
          if (keeps_account && k == 0)
            account.open(now.state);
          else if (keeps_account)
            account.advance(
              pins
                .find((followed.instants[(k - 1) * per_record].state.time +
                       now.state.time) /
                        2,
                      now.state.q,
                      followed.rates[k * per_record])
                .state,
              now.state);
          recorder.record(k, now.state, now.accelerations, now.contacts);
        }
      DutyCycle cycle          = recorder.make_duty_cycle({}, times.front());
      cycle.settling.n_cycles  = 1;
      cycle.settling.converged = true;
      cycle.is_quasi_static    = true;
      judge_neglected_inertia(pins, followed.neglected, largest_wear, cycle);
      for (JointDutyCycle &joint : cycle.joints)
        joint.peak_force_since_start = joint.peak_force();
      return cycle;
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
    CycleSimulation::record_time(const unsigned int k,
                                 const unsigned int n) const
    {
      const double t = (k - 1.) * period / (2 * n);
      const bool   repeats =
        parameters.cycle_duration == 0 && mechanism.has_turning_driver();
      return repeats ? t : std::max(0., t);
    }



    DutyCycle
    CycleSimulation::run_kinematics(const EquationsOfMotion &equations,
                                    const unsigned int       n) const
    {
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
          const double   t = record_time(k, n);
          MechanismState middle;
          if (keeps_account && k > 0)
            {
              move_to((record_time(k - 1, n) + t) / 2);
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



    Eigen::VectorXd
    CycleSimulation::guess_rest(const EquationsOfMotion &equations,
                                const double             t,
                                const Eigen::VectorXd   &q) const
    {
      const StaticEquilibrium ideal =
        solve_static_equilibrium(closed_equations, t, q);
      if (!ideal.report.converged)
        return q;
      try
        {
          return FollowingPins(equations, closed_equations)
            .place(t, ideal.q, ideal.multipliers);
        }
      catch (const ExcRun &)
        {
          // There is no such place near the one of ideal joints.
          return q;
        }
    }



    Accelerations
    CycleSimulation::balance(const EquationsOfMotion   &equations,
                             MechanismState            &state,
                             std::vector<JointContact> &contacts) const
    {
      contacts.clear();
      const Eigen::VectorXd zero =
        Eigen::VectorXd::Zero(mechanism.n_coordinates());
      if (can_follow())
        {
          const FollowingInstant rest =
            FollowingPins(equations, closed_equations)
              .find_at_rest(state.time, state.q);
          state.q  = rest.state.q;
          contacts = rest.contacts;
          return {zero, rest.accelerations.multipliers};
        }
      const StaticEquilibrium equilibrium =
        solve_static_equilibrium(equations, state.time, state.q);
      AssertThrow(equilibrium.report.converged,
                  ExcRun(equilibrium.report.message));
      state.q = equilibrium.q;
      return {zero, equilibrium.multipliers};
    }



    DutyCycle
    CycleSimulation::run_statics(const EquationsOfMotion &equations,
                                 const unsigned int       n) const
    {
      CycleRecorder           recorder(equations, n, period);
      const ConstraintOffsets none(mechanism.n_constraints());
      MechanismState          state;
      state.q = assemble_configuration(closed_equations, 0.);
      state.v = Eigen::VectorXd::Zero(mechanism.n_coordinates());
      for (const ClearanceJoint &joint : mechanism.clearance_joints())
        state.approach_speeds.push_back(joint.minimum_approach_speed);
      if (!mechanism.has_only_ideal_joints() && !can_follow())
        state.q = guess_rest(equations, record_time(0, n), state.q);
      for (unsigned int k = 0; k <= 2 * n; ++k)
        {
          state.time = record_time(k, n);
          const SolverReport closed =
            solve_positions(equations, state.time, none, state.q);
          AssertThrow(closed.converged,
                      ExcRun("At time " + significant_digits(state.time, 6) +
                             " s there is no position:" +
                             explain_end_of_motion(
                               equations, state.time, state.time, state.q)));
          std::vector<JointContact> contacts;
          const Accelerations       rest = balance(equations, state, contacts);
          if (can_follow())
            recorder.record(k, state, rest, contacts);
          else
            recorder.record(k, state, rest);
        }
      DutyCycle cycle         = recorder.make_duty_cycle({}, record_time(0, n));
      cycle.settling.n_cycles = 1;
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
          if (!mechanism.has_only_ideal_joints() && !can_follow())
            start.state.q = guess_rest(equations, 0., start.state.q);
          try
            {
              std::vector<JointContact> contacts;
              balance(equations, start.state, contacts);
            }
          catch (const ExcRun &error)
            {
              throw ExcRun("For 'Dynamics/Start = static equilibrium', " +
                           message_of(error));
            }
          start.state.v =
            compute_initial_velocities(equations, 0., start.state.q);
          return start;
        }
      if (parameters.start == MotionStart::centred ||
          mechanism.has_only_ideal_joints())
        return start;
      if (closed_mechanism.n_redundant() > mechanism.n_redundant())
        {
          start.report.message =
            "with ideal joints the mechanism is overconstrained, so that there "
            "is no start in slow motion; the pins began in the middle of their "
            "bushings";
          return start;
        }
      start = compute_slow_motion_start(equations,
                                        closed_equations,
                                        0.,
                                        period / 360);
      if (!start.report.message.empty())
        start.report.message +=
          parameters.maximum_settling_cycles > 0
            ? "; a motion that settles forgets it"
            : "; the cycle, which is recorded from the start, has the "
              "vibration that follows";
      return start;
    }



    StartingState
    CycleSimulation::continue_from(const EquationsOfMotion &equations,
                                   const MotionEnd         &end) const
    {
      try
        {
          return {continue_in_worn_bores(equations, closed_equations, end), {}};
        }
      catch (const ExcRun &)
        {
          return compute_start(equations);
        }
    }



    DutyCycle
    CycleSimulation::run_dynamics(const EquationsOfMotion           &equations,
                                  const std::vector<ReferenceScale> &scales,
                                  const Arcs                        &arcs,
                                  const DutyCycle                   *before,
                                  const unsigned int maximum_steps) const
    {
      // Whoever records the first cycle wants that of the start.
      const bool goes_on = before != nullptr && before->end &&
                           parameters.maximum_settling_cycles > 0;
      const StartingState start = goes_on
                                    ? continue_from(equations, *before->end)
                                    : compute_start(equations);
      // One that had to start anew has something to settle again.
      bool repeats = !goes_on || before->settling.converged ||
                     start.state.time != before->end->state.time;
      DynamicsParameters as_needed      = parameters;
      as_needed.maximum_steps_per_cycle = maximum_steps;
      const auto motion_from = [&](const double          with_accuracy,
                                   const MechanismState &begin,
                                   const bool            may_repeat) {
        as_needed.accuracy = with_accuracy;
        return integrate(equations, scales, arcs, as_needed, begin, may_repeat);
      };
      const auto motion_as_needed = [&]() {
        return integrate_as_needed(
          [&](const double with_accuracy, const DutyCycle *looser) {
            const bool has_begun =
              looser != nullptr && parameters.maximum_settling_cycles > 0;
            as_needed.samples_per_cycle =
              has_begun ? looser->n_samples() : parameters.samples_per_cycle;
            const MechanismState begin =
              has_begun ? continue_from(equations, *looser->end).state
                        : start.state;
            return motion_from(with_accuracy, begin, true);
          },
          arcs);
      };
      DutyCycle cycle;
      if (parameters.accuracy > 0.)
        {
          cycle = motion_from(parameters.accuracy, start.state, repeats);
          for (JointDutyCycle &joint : cycle.joints)
            joint.integration_error =
              usual_integration_error(parameters.accuracy);
        }
      else if (before == nullptr || before->accuracy == 0.)
        cycle = motion_as_needed();
      else
        try
          {
            as_needed.samples_per_cycle = before->n_samples();
            cycle = motion_from(before->accuracy, start.state, repeats);
            for (std::size_t j = 0; j < cycle.joints.size(); ++j)
              cycle.joints[j].integration_error =
                before->joints[j].integration_error;
          }
        catch (const ExcRun &)
          {
            // In bores that have worn since it may take more.
            cycle   = motion_as_needed();
            repeats = true;
          }
      if (!repeats)
        {
          cycle.settling.repeat_difference = before->settling.repeat_difference;
          cycle.settling.distance          = before->settling.distance;
          cycle.settling.decay             = before->settling.decay;
        }
      cycle.settling.message =
        describe_settling(cycle.settling, repeats, start.report.message);
      judge_creep(mechanism, closed_equations, cycle);
      return cycle;
    }



    DutyCycle
    CycleSimulation::integrate(const EquationsOfMotion           &equations,
                               const std::vector<ReferenceScale> &scales,
                               const Arcs                        &arcs,
                               const DynamicsParameters          &as_needed,
                               const MechanismState              &begin,
                               const bool                         repeats) const
    {
      MotionTolerances tolerances =
        make_tolerances(mechanism, scales, as_needed);
      tolerances.maximum_step = period / parameters.samples_per_cycle;
      IntegratedCycle motion(equations, as_needed, tolerances, period, begin);
      DutyCycle       cycle = motion.run(
        [&](const DutyCycle &recorded, const unsigned int n) {
          return needs_more_samples(recorded, arcs, n);
        },
        repeats);
      cycle.accuracy = as_needed.accuracy;
      return cycle;
    }
  } // namespace Multibody
} // namespace Tribody

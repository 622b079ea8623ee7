// SPDX-License-Identifier: LGPL-2.1-or-later

#include <Eigen/LU>

#include <tribody/base/exceptions.h>
#include <tribody/base/significant_digits.h>
#include <tribody/base/solver_report.h>
#include <tribody/multibody/motion/energy_account.h>
#include <tribody/multibody/motion/intermittent_motion.h>
#include <tribody/multibody/system/kinematics.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // A row of an element among all coordinates.
      Eigen::RowVectorXd
      scattered(const BodyPair                    &bodies,
                const Eigen::Matrix<double, 1, 6> &row,
                const unsigned int                 n)
      {
        Eigen::VectorXd result = Eigen::VectorXd::Zero(n);
        bodies.add_to(PairVector(row.transpose()), result);
        return result.transpose();
      }



      // A pin touches its bore within this part of the clearance, and neither
      // approaches nor leaves it within this part of the capture speed: far
      // above rounding, and below what integration is asked for.
      constexpr double negligible_gap   = 1e-9;
      constexpr double negligible_speed = 1e-6;
    } // namespace



    IntermittentMotion::IntermittentMotion(const EquationsOfMotion &equations,
                                           const MotionTolerances  &tolerances)
      : equations(equations)
      , tolerances(tolerances)
      , present(
          &mode(Combination(equations.mechanism().impact_joints().size())))
    {}



    IntermittentMotion::Mode &
    IntermittentMotion::mode(const Combination &combination)
    {
      const auto [entry, is_new] = modes.try_emplace(combination);
      Mode &result               = entry->second;
      if (!is_new)
        return result;
      result.equations           = &equations;
      const Mechanism &mechanism = equations.mechanism();
      if (std::find(combination.begin(), combination.end(), true) !=
          combination.end())
        {
          std::vector<JointClearance> clearances;
          EquationsOfMotion::Supports supports;
          for (unsigned int j = 0; j < mechanism.clearance_joints().size(); ++j)
            {
              clearances.push_back(equations.condition(j).surfaces.clearance());
              supports.push_back(equations.condition(j).support);
            }
          result.own_mechanism =
            std::make_unique<const Mechanism>(mechanism.parameters(),
                                              combination);
          result.own_equations =
            std::make_unique<const EquationsOfMotion>(*result.own_mechanism,
                                                      clearances,
                                                      supports);
          result.equations = result.own_equations.get();
        }
      result.integrator =
        std::make_unique<MotionIntegrator>(*result.equations, tolerances);
      return result;
    }



    bool
    IntermittentMotion::touches(const unsigned int    joint,
                                const MechanismState &state) const
    {
      const ImpactJoint &pin = equations.mechanism().impact_joints()[joint];
      return pin.compute_penetration(pin.link->bodies.gather(state.q)) >
             -negligible_gap * pin.link->length;
    }



    double
    IntermittentMotion::approach_speed(const unsigned int    joint,
                                       const MechanismState &state) const
    {
      const ImpactJoint &pin    = equations.mechanism().impact_joints()[joint];
      const BodyPair    &bodies = pin.link->bodies;
      return pin.normal_row(bodies.gather(state.q)) * bodies.gather(state.v);
    }



    double
    IntermittentMotion::approach_acceleration(const unsigned int     joint,
                                              const MechanismState  &state,
                                              const Eigen::VectorXd &a) const
    {
      const ImpactJoint &pin    = equations.mechanism().impact_joints()[joint];
      const BodyPair    &bodies = pin.link->bodies;
      const PairVector   q      = bodies.gather(state.q);
      const PairVector   v      = bodies.gather(state.v);
      return pin.normal_row(q) * bodies.gather(a) +
             v.dot(pin.link->weighted_hessian(q, Constraint::Values::UnitX()) *
                   v);
    }



    void
    IntermittentMotion::start(const MechanismState &state)
    {
      the_events.clear();
      stop_time            = state.time;
      n_stops_here         = 0;
      MechanismState begin = state;
      begin.approach_speeds.clear();
      for (const ClearanceJoint &joint :
           equations.mechanism().clearance_joints())
        begin.approach_speeds.push_back(joint.minimum_approach_speed);
      if (static_cast<unsigned int>(begin.friction_states.size()) !=
          equations.mechanism().n_friction_states())
        begin.friction_states =
          Eigen::VectorXd::Zero(equations.mechanism().n_friction_states());
      Combination combination(equations.mechanism().impact_joints().size(),
                              false);
      collide_all(combination, begin);
      add_resting(begin, combination);
      begin.is_following = without_tension(combination, begin);
      // Approach speeds and friction in contacts are for the integrator to say.
      begin.approach_speeds = state.approach_speeds;
      begin.friction_states = state.friction_states;
      present               = &mode(begin.is_following);
      present->integrator->start(begin);
      present->n_events_taken = 0;
    }



    void
    IntermittentMotion::add_resting(const MechanismState &state,
                                    Combination          &combination) const
    {
      const std::vector<ImpactJoint> &joints =
        equations.mechanism().impact_joints();
      for (unsigned int k = 0; k < combination.size(); ++k)
        if (touches(k, state) && std::abs(approach_speed(k, state)) <=
                                   negligible_speed * joints[k].capture_speed)
          combination[k] = true;
    }



    IntermittentMotion::Combination
    IntermittentMotion::without_tension(Combination           combination,
                                        const MechanismState &state)
    {
      // A pin that is let go may be pressed again by those that are let go
      // after it: of each pair of force and acceleration one is zero, and
      // neither is negative.
      Combination may_return = combination;
      while (!combination.empty())
        {
          const Mode         &in_mode  = mode(combination);
          double              smallest = std::numeric_limits<double>::max();
          int                 pulled = -1, pressed = -1;
          const Accelerations accelerations =
            compute_accelerations(*in_mode.equations, state);
          for (unsigned int k = 0; k < combination.size(); ++k)
            if (combination[k])
              {
                const double force = accelerations.multipliers(
                  in_mode.equations->mechanism().impact_joints()[k].first_row);
                if (force <= 0 && force < smallest)
                  {
                    smallest = force;
                    pulled   = k;
                  }
              }
            else if (may_return[k] &&
                     approach_acceleration(k, state, accelerations.a) > 0)
              pressed = k;
          if (pulled >= 0)
            combination[pulled] = false;
          else if (pressed >= 0)
            {
              // Once: rounding must not decide without end.
              combination[pressed] = true;
              may_return[pressed]  = false;
            }
          else
            break;
        }
      return combination;
    }



    Eigen::Vector2d
    IntermittentMotion::compute_impulse(const unsigned int     joint,
                                        const Eigen::Matrix2d &inverse_mass,
                                        const Eigen::Vector2d &change,
                                        const double           time) const
    {
      const double mu =
        equations.mechanism().impact_joints()[joint].friction_coefficient;
      if (change(0) <= 0)
        return Eigen::Vector2d::Zero();
      if (mu == 0)
        return {change(0) / inverse_mass(0, 0), 0.};
      const Eigen::Vector2d sticking = inverse_mass.fullPivLu().solve(change);
      if (std::abs(sticking(1)) <= mu * sticking(0))
        return sticking;
      // Towards sticking: the normal impulse may turn the sliding around before
      // it ends.
      const double signed_mu = std::copysign(mu, sticking(1));
      const double inverse =
        inverse_mass(0, 0) + signed_mu * inverse_mass(0, 1);
      AssertThrow(inverse > 0,
                  ExcRun("At time " + significant_digits(time, 6) +
                         " s friction jams the impact in " + joint_name(joint) +
                         ": its friction coefficient of " +
                         significant_digits(mu) +
                         " is too large for the position of the "
                         "bodies there."));
      const double normal = change(0) / inverse;
      return {normal, signed_mu * normal};
    }



    IntermittentMotion::Impulses
    IntermittentMotion::compute_impulses(const std::vector<Impact> &impacts,
                                         const EquationsOfMotion   &in_mode,
                                         const MechanismState      &state) const
    {
      const Mechanism   &mechanism = in_mode.mechanism();
      const unsigned int n         = mechanism.n_coordinates();
      const unsigned int m         = mechanism.n_constraints();
      const std::size_t  n_impacts = impacts.size();
      Eigen::MatrixXd    rows(2 * n_impacts, n);
      for (std::size_t i = 0; i < n_impacts; ++i)
        {
          const ImpactJoint &pin = mechanism.impact_joints()[impacts[i].joint];
          const BodyPair    &bodies = pin.link->bodies;
          const PairVector   q      = bodies.gather(state.q);
          rows.row(2 * i)           = scattered(bodies, pin.normal_row(q), n);
          rows.row(2 * i + 1) = scattered(bodies, pin.tangential_row(q), n);
        }
      Eigen::MatrixXd matrix    = Eigen::MatrixXd::Zero(n + m, n + m);
      matrix.diagonal().head(n) = mechanism.masses();
      in_mode.assemble_constraint_jacobian(state.q,
                                           matrix.bottomLeftCorner(m, n));
      matrix.topRightCorner(n, m) = matrix.bottomLeftCorner(m, n).transpose();
      Eigen::MatrixXd right       = Eigen::MatrixXd::Zero(n + m, 2 * n_impacts);
      right.topRows(n)            = rows.transpose();
      // Redundant constraints leave it singular, and what is asked unique.
      Eigen::MatrixXd solution;
      if (mechanism.n_redundant() > 0)
        solution = matrix.fullPivLu().solve(right);
      else
        solution = matrix.partialPivLu().solve(right);
      const Eigen::MatrixXd inverse_mass = rows * solution.topRows(n);

      // The impulse of each pin for those of the others, until they agree: one
      // alone needs no second round.
      constexpr unsigned int max_rounds = 10000;
      constexpr double       tolerance  = 1e-13;
      const Eigen::VectorXd  speeds     = rows * state.v;
      Eigen::VectorXd        impulse    = Eigen::VectorXd::Zero(2 * n_impacts);
      for (unsigned int round = 0; round < max_rounds; ++round)
        {
          const Eigen::VectorXd before = impulse;
          for (std::size_t i = 0; i < n_impacts; ++i)
            {
              const auto      own = inverse_mass.block<2, 2>(2 * i, 2 * i);
              Eigen::Vector2d change =
                speeds.segment<2>(2 * i) -
                inverse_mass.middleRows<2>(2 * i) * impulse +
                own * impulse.segment<2>(2 * i);
              change(0) += impacts[i].restitution * speeds(2 * i);
              impulse.segment<2>(2 * i) =
                compute_impulse(impacts[i].joint, own, change, state.time);
            }
          if (n_impacts == 1 || (impulse - before).lpNorm<Eigen::Infinity>() <=
                                  tolerance * impulse.lpNorm<Eigen::Infinity>())
            break;
        }

      Impulses              result;
      const Eigen::VectorXd jump = -solution * impulse;
      result.velocity_change     = jump.head(n);
      for (std::size_t i = 0; i < n_impacts; ++i)
        result.normal.push_back(impulse(2 * i));
      for (unsigned int k = 0; k < mechanism.impact_joints().size(); ++k)
        {
          const ImpactJoint &other = mechanism.impact_joints()[k];
          if (other.is_following && jump(n + other.first_row) < 0)
            result.pulled = k;
        }
      return result;
    }



    std::vector<double>
    IntermittentMotion::collide(const std::vector<unsigned int> &joints,
                                Combination                     &combination,
                                MechanismState                  &state)
    {
      std::vector<Impact> impacts;
      std::vector<double> speeds;
      for (const unsigned int joint : joints)
        {
          const ImpactJoint &pin = equations.mechanism().impact_joints()[joint];
          speeds.push_back(approach_speed(joint, state));
          impacts.push_back({joint,
                             speeds.back() < pin.capture_speed
                               ? 0.
                               : pin.restitution_coefficient});
        }
      Impulses impulses =
        compute_impulses(impacts, *mode(combination).equations, state);
      // Followers that the impacts would have to pull are left behind.
      while (impulses.pulled >= 0)
        {
          combination[impulses.pulled] = false;
          impulses =
            compute_impulses(impacts, *mode(combination).equations, state);
        }
      state.v += impulses.velocity_change;
      for (std::size_t i = 0; i < joints.size(); ++i)
        if (impulses.normal[i] > 0)
          {
            combination[joints[i]] =
              speeds[i] <
              equations.mechanism().impact_joints()[joints[i]].capture_speed;
            the_events.push_back({state.time,
                                  n_contacts() + joints[i],
                                  true,
                                  speeds[i],
                                  0.,
                                  impulses.normal[i]});
          }
      return impulses.normal;
    }



    std::vector<bool>
    IntermittentMotion::collide_all(Combination    &combination,
                                    MechanismState &state)
    {
      std::vector<bool>      has_hit(combination.size(), false);
      constexpr unsigned int max_impacts = 1000;
      for (unsigned int n_impacts = 0;; ++n_impacts)
        {
          // Every impact changes the speeds of all pins. Those that are
          // captured are held in the impacts that follow.
          std::vector<unsigned int> approaching;
          for (unsigned int k = 0; k < combination.size(); ++k)
            if (!combination[k] && touches(k, state) &&
                approach_speed(k, state) >
                  negligible_speed *
                    equations.mechanism().impact_joints()[k].capture_speed)
              approaching.push_back(k);
          if (approaching.empty())
            return has_hit;
          check_endless(n_impacts < max_impacts,
                        state.time,
                        approaching.front());
          const std::vector<double> impulses =
            collide(approaching, combination, state);
          for (std::size_t i = 0; i < impulses.size(); ++i)
            has_hit[approaching[i]] =
              has_hit[approaching[i]] || impulses[i] > 0;
        }
    }



    void
    IntermittentMotion::check_endless(const bool         ends,
                                      const double       time,
                                      const unsigned int joint) const
    {
      AssertThrow(ends,
                  ExcRun("At time " + significant_digits(time, 6) +
                         " s impacts follow each other without end in " +
                         joint_name(joint) +
                         ". A larger 'Capture speed' of that joint makes its "
                         "pin follow the bore sooner."));
    }



    void
    IntermittentMotion::close_gaps(MechanismState &state)
    {
      const Mechanism &mechanism = equations.mechanism();
      double           largest   = 0.;
      for (unsigned int k = 0; k < state.is_following.size(); ++k)
        if (state.is_following[k])
          {
            const ImpactJoint &pin = mechanism.impact_joints()[k];
            largest                = std::max(largest,
                               std::abs(pin.compute_penetration(
                                 pin.link->bodies.gather(state.q))) /
                                 pin.link->length);
          }
      if (largest <= negligible_gap)
        return;
      const EquationsOfMotion &in_mode = *mode(state.is_following).equations;
      const SolverReport       report =
        solve_positions(in_mode,
                        state.time,
                        ConstraintOffsets(in_mode.mechanism().n_constraints()),
                        state.q);
      AssertThrow(report.converged,
                  ExcRun("At time " + significant_digits(state.time, 6) +
                         " s the pins that follow their bores cannot all "
                         "touch them: " +
                         report.message + "."));
    }



    void
    IntermittentMotion::resolve_stops()
    {
      const MotionIntegrator &integrator = *present->integrator;
      MechanismState          state      = integrator.state();
      n_stops_here = (state.time == stop_time) ? n_stops_here + 1 : 0;
      stop_time    = state.time;
      constexpr unsigned int max_stops = 100;
      check_endless(n_stops_here < max_stops,
                    state.time,
                    integrator.stops().front());

      const Combination before      = state.is_following;
      Combination       combination = before;
      for (const unsigned int k : integrator.stops())
        combination[k] = false;
      const std::vector<bool> has_hit = collide_all(combination, state);
      // Pins that fly although they do not move away from the bore: those that
      // have just lost their force must not be caught again by rounding.
      Combination resting = combination;
      add_resting(state, resting);
      for (const unsigned int k : integrator.stops())
        if (before[k])
          resting[k] = combination[k];
      combination = without_tension(resting, state);

      for (unsigned int k = 0; k < combination.size(); ++k)
        if ((before[k] || has_hit[k]) && !combination[k])
          the_events.push_back({state.time,
                                n_contacts() + k,
                                false,
                                approach_speed(k, state),
                                0.,
                                0.});
      state.is_following = combination;
      close_gaps(state);
      present->integrator->set_energy_account(nullptr);
      present = &mode(combination);
      if (energy_account != nullptr)
        {
          energy_account->set_equations(*present->equations);
          present->integrator->continue_energy_account(energy_account);
        }
      present->integrator->resume(state,
                                  initial_step(*present->equations, state));
    }



    double
    IntermittentMotion::initial_step(const EquationsOfMotion &in_mode,
                                     const MechanismState    &state) const
    {
      constexpr double                part_of_flight = 0.1;
      double                          step           = 0.;
      Eigen::VectorXd                 a;
      const std::vector<ImpactJoint> &pins =
        in_mode.mechanism().impact_joints();
      for (unsigned int k = 0; k < pins.size(); ++k)
        {
          const double speed = -approach_speed(k, state);
          const double height =
            -pins[k].compute_penetration(pins[k].link->bodies.gather(state.q));
          if (pins[k].is_following || speed <= 0 ||
              height > 1e-6 * pins[k].link->length)
            continue;
          if (a.size() == 0)
            a = compute_accelerations(in_mode, state).a;
          const double back = approach_acceleration(k, state, a);
          if (back > 0)
            {
              const double flight = 2 * speed / back;
              step = step > 0 ? std::min(step, part_of_flight * flight)
                              : part_of_flight * flight;
            }
        }
      const double usual = tolerances.initial_step;
      return usual > 0 && step > usual ? usual : step;
    }



    const MechanismState &
    IntermittentMotion::advance_to(const double        t,
                                   const unsigned long maximum_steps,
                                   const unsigned long n_steps_before)
    {
      unsigned long n_steps = n_steps_before;
      while (true)
        {
          const unsigned long before =
            present->integrator->statistics().n_steps;
          const MechanismState &state =
            present->integrator->advance_to(t, maximum_steps, n_steps);
          n_steps += present->integrator->statistics().n_steps - before;
          collect_events();
          if (!present->integrator->has_stopped())
            return state;
          resolve_stops();
        }
    }



    void
    IntermittentMotion::collect_events()
    {
      const std::vector<ContactEvent> &all = present->integrator->events();
      the_events.insert(the_events.end(),
                        all.begin() + present->n_events_taken,
                        all.end());
      present->n_events_taken = all.size();
    }



    unsigned int
    IntermittentMotion::n_contacts() const
    {
      return equations.mechanism().clearance_joints().size();
    }



    std::string
    IntermittentMotion::joint_name(const unsigned int impact_joint) const
    {
      const Mechanism &mechanism = equations.mechanism();
      return "joint " +
             mechanism.joints()[mechanism.impact_joints()[impact_joint].joint]
               .name;
    }



    std::vector<double>
    IntermittentMotion::peak_forces() const
    {
      std::vector<double> peaks(n_contacts(), 0.);
      for (const auto &[combination, mode] : modes)
        for (unsigned int j = 0; j < mode.integrator->peak_forces().size(); ++j)
          peaks[j] = std::max(peaks[j], mode.integrator->peak_forces()[j]);
      return peaks;
    }



    double
    IntermittentMotion::constraint_drift() const
    {
      double drift = 0.;
      for (const auto &[combination, mode] : modes)
        drift = std::max(drift, mode.integrator->constraint_drift());
      return drift;
    }



    void
    IntermittentMotion::set_energy_account(EnergyAccount *account)
    {
      energy_account = account;
      if (account != nullptr)
        account->set_equations(*present->equations);
      present->integrator->set_energy_account(account);
    }



    Sundials::IntegratorStatistics
    IntermittentMotion::statistics() const
    {
      Sundials::IntegratorStatistics total;
      for (const auto &[combination, mode] : modes)
        total += mode.integrator->statistics();
      return total;
    }
  } // namespace Multibody
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <Eigen/LU>

#include <tribody/base/exceptions.h>
#include <tribody/base/significant_digits.h>
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



    void
    IntermittentMotion::start(const MechanismState &state)
    {
      the_events.clear();
      const std::vector<ImpactJoint> &joints =
        equations.mechanism().impact_joints();
      Combination combination(joints.size(), false);
      for (unsigned int k = 0; k < joints.size(); ++k)
        {
          const BodyPair  &bodies = joints[k].link->bodies;
          const PairVector q      = bodies.gather(state.q);
          combination[k] =
            joints[k].compute_penetration(q) > -1e-9 * joints[k].link->length &&
            std::abs(joints[k].normal_row(q) * bodies.gather(state.v)) <
              joints[k].capture_speed;
        }
      MechanismState begin = state;
      begin.approach_speeds.clear();
      for (const ClearanceJoint &joint :
           equations.mechanism().clearance_joints())
        begin.approach_speeds.push_back(joint.minimum_approach_speed);
      if (static_cast<unsigned int>(begin.friction_states.size()) !=
          equations.mechanism().n_friction_states())
        begin.friction_states =
          Eigen::VectorXd::Zero(equations.mechanism().n_friction_states());
      begin.is_following = without_tension(combination, begin);
      // Approach speeds and friction in contacts are for the integrator to say.
      begin.approach_speeds = state.approach_speeds;
      begin.friction_states = state.friction_states;
      present               = &mode(begin.is_following);
      present->integrator->start(begin);
      present->n_events_taken = 0;
    }



    IntermittentMotion::Combination
    IntermittentMotion::without_tension(Combination           combination,
                                        const MechanismState &state)
    {
      while (true)
        {
          const EquationsOfMotion &in_mode = *mode(combination).equations;
          double          smallest         = std::numeric_limits<double>::max();
          unsigned int    pulled           = 0;
          Eigen::VectorXd multipliers;
          for (unsigned int k = 0; k < combination.size(); ++k)
            if (combination[k])
              {
                if (multipliers.size() == 0)
                  multipliers =
                    compute_accelerations(in_mode, state).multipliers;
                const double force =
                  multipliers(in_mode.mechanism().impact_joints()[k].first_row);
                if (force < smallest)
                  {
                    smallest = force;
                    pulled   = k;
                  }
              }
          if (smallest > 0)
            return combination;
          combination[pulled] = false;
        }
    }



    IntermittentMotion::Impulse
    IntermittentMotion::compute_impulse(const unsigned int       joint,
                                        const double             restitution,
                                        const EquationsOfMotion &in_mode,
                                        const MechanismState    &state) const
    {
      const Mechanism   &mechanism = in_mode.mechanism();
      const unsigned int n         = mechanism.n_coordinates();
      const unsigned int m         = mechanism.n_constraints();
      const ImpactJoint &pin       = mechanism.impact_joints()[joint];
      const PairVector   q         = pin.link->bodies.gather(state.q);

      Eigen::MatrixXd rows(2, n);
      rows.row(0) = scattered(pin.link->bodies, pin.normal_row(q), n);
      rows.row(1) = scattered(pin.link->bodies, pin.tangential_row(q), n);

      Eigen::MatrixXd matrix    = Eigen::MatrixXd::Zero(n + m, n + m);
      matrix.diagonal().head(n) = mechanism.masses();
      in_mode.assemble_constraint_jacobian(state.q,
                                           matrix.bottomLeftCorner(m, n));
      matrix.topRightCorner(n, m) = matrix.bottomLeftCorner(m, n).transpose();
      Eigen::MatrixXd right       = Eigen::MatrixXd::Zero(n + m, 2);
      right.topRows(n)            = rows.transpose();
      // Redundant constraints leave it singular, and what is asked unique.
      Eigen::MatrixXd solution;
      if (mechanism.n_redundant() > 0)
        solution = matrix.fullPivLu().solve(right);
      else
        solution = matrix.partialPivLu().solve(right);
      const Eigen::Matrix2d inverse_mass = rows * solution.topRows(n);

      const Eigen::Vector2d speeds  = rows * state.v;
      const double          change  = (1 + restitution) * speeds(0);
      const double          mu      = pin.friction_coefficient;
      Eigen::Vector2d       impulse = {change / inverse_mass(0, 0), 0.};
      if (mu > 0)
        {
          const Eigen::Vector2d sticking =
            inverse_mass.fullPivLu().solve(Eigen::Vector2d(change, speeds(1)));
          impulse = sticking;
          if (!(std::abs(sticking(1)) <= mu * sticking(0)))
            {
              // Towards sticking: the normal impulse may turn the sliding
              // around before it ends.
              const double signed_mu = std::copysign(mu, sticking(1));
              const double inverse =
                inverse_mass(0, 0) + signed_mu * inverse_mass(0, 1);
              AssertThrow(
                inverse > 0,
                ExcRun("At time " + significant_digits(state.time, 6) +
                       " s friction jams the impact in " + joint_name(joint) +
                       ": its friction coefficient of " +
                       significant_digits(mu) +
                       " is too large for the position of the "
                       "bodies there."));
              impulse(0) = change / inverse;
              impulse(1) = signed_mu * impulse(0);
            }
        }

      Impulse               result = {impulse(0), impulse(1)};
      const Eigen::VectorXd jump   = -solution * impulse;
      result.velocity_change       = jump.head(n);
      for (unsigned int k = 0; k < mechanism.impact_joints().size(); ++k)
        {
          const ImpactJoint &other = mechanism.impact_joints()[k];
          if (other.is_following && jump(n + other.first_row) < 0)
            result.pulled = k;
        }
      return result;
    }



    bool
    IntermittentMotion::collide(const unsigned int joint,
                                Combination       &combination,
                                MechanismState    &state)
    {
      const ImpactJoint &pin = equations.mechanism().impact_joints()[joint];
      const PairVector   q   = pin.link->bodies.gather(state.q);
      const double       approach_speed =
        pin.normal_row(q) * pin.link->bodies.gather(state.v);
      const bool   is_captured = approach_speed < pin.capture_speed;
      const double restitution = is_captured ? 0. : pin.restitution_coefficient;
      Impulse      impulse     = compute_impulse(joint,
                                        restitution,
                                        *mode(combination).equations,
                                        state);
      // Followers that the impact would have to pull are left behind.
      while (impulse.pulled >= 0)
        {
          combination[impulse.pulled] = false;
          impulse                     = compute_impulse(joint,
                                    restitution,
                                    *mode(combination).equations,
                                    state);
        }
      state.v += impulse.velocity_change;
      the_events.push_back({state.time,
                            n_contacts() + joint,
                            true,
                            approach_speed,
                            0.,
                            impulse.normal});
      return is_captured;
    }



    void
    IntermittentMotion::resolve_stops()
    {
      const MotionIntegrator &integrator = *present->integrator;
      MechanismState          state      = integrator.state();
      n_stops_here = (state.time == stop_time) ? n_stops_here + 1 : 0;
      stop_time    = state.time;
      constexpr unsigned int max_stops = 100;
      AssertThrow(n_stops_here < max_stops,
                  ExcRun("At time " + significant_digits(state.time, 6) +
                         " s impacts follow each other without end in " +
                         joint_name(integrator.stops().front()) +
                         ". A larger 'Capture speed' of that joint makes its "
                         "pin follow the bore sooner."));

      const Combination before      = state.is_following;
      Combination       combination = before;
      std::vector<bool> has_hit(combination.size(), false);
      for (const unsigned int k : integrator.stops())
        if (combination[k])
          combination[k] = false;
      // One after the other: those that are captured are held in the impacts of
      // the next.
      for (const unsigned int k : integrator.stops())
        if (!before[k])
          {
            has_hit[k]             = true;
            const bool is_captured = collide(k, combination, state);
            combination[k]         = is_captured;
          }
      combination = without_tension(combination, state);

      for (unsigned int k = 0; k < combination.size(); ++k)
        if ((before[k] || has_hit[k]) && !combination[k])
          {
            const ImpactJoint &pin = equations.mechanism().impact_joints()[k];
            const BodyPair    &bodies = pin.link->bodies;
            const double       rate =
              pin.normal_row(bodies.gather(state.q)) * bodies.gather(state.v);
            the_events.push_back(
              {state.time, n_contacts() + k, false, rate, 0., 0.});
          }
      state.is_following = combination;
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
      constexpr double part_of_flight = 0.1;
      double           step           = 0.;
      Eigen::VectorXd  a;
      for (const ImpactJoint &pin : in_mode.mechanism().impact_joints())
        {
          const BodyPair  &bodies = pin.link->bodies;
          const PairVector q      = bodies.gather(state.q);
          const PairVector v      = bodies.gather(state.v);
          const auto       normal = pin.normal_row(q);
          const double     speed  = -normal * v;
          if (pin.is_following || speed <= 0 ||
              pin.compute_penetration(q) < -1e-6 * pin.link->length)
            continue;
          if (a.size() == 0)
            a = compute_accelerations(in_mode, state).a;
          const double back =
            normal * bodies.gather(a) +
            v.dot(pin.link->weighted_hessian(q, Constraint::Values::UnitX()) *
                  v);
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

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/base/interruption.h>
#include <tribody/base/significant_digits.h>
#include <tribody/multibody/motion/energy_account.h>
#include <tribody/multibody/motion/motion_integrator.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Tribody
{
  namespace Multibody
  {
    MotionIntegrator::MotionIntegrator(const EquationsOfMotion &equations,
                                       const MotionTolerances  &tolerances)
      : equations(equations)
      , n(equations.mechanism().n_coordinates())
      , m(equations.mechanism().n_constraints())
      , n_states(equations.mechanism().n_friction_states())
      , phi(m)
      , forces(n)
    {
      ida =
        std::make_unique<Sundials::IdaIntegrator>(make_system(),
                                                  make_settings(tolerances));
    }



    MotionIntegrator::~MotionIntegrator() = default;



    Sundials::ImplicitSystem
    MotionIntegrator::make_system()
    {
      Sundials::ImplicitSystem system;
      system.residual = [this](const double                                 t,
                               const Sundials::ImplicitSystem::ConstVector &y,
                               const Sundials::ImplicitSystem::ConstVector &y_t,
                               Sundials::ImplicitSystem::Vector &residual) {
        assemble_residual(y, y_t, t, residual);
      };
      system.jacobian =
        [this](const double                                 t,
               const double                                 c,
               const Sundials::ImplicitSystem::ConstVector &y,
               const Sundials::ImplicitSystem::ConstVector & /*y_t*/,
               MatrixEntries &entries) { assemble_jacobian(y, t, c, entries); };
      // Two for each joint, see evaluate_roots().
      system.n_roots = 2 * (equations.mechanism().clearance_joints().size() +
                            equations.mechanism().impact_joints().size());
      system.roots   = [this](const double                                 t,
                            const Sundials::ImplicitSystem::ConstVector &y,
                            double *values) { evaluate_roots(t, y, values); };
      return system;
    }



    Sundials::IdaSettings
    MotionIntegrator::make_settings(const MotionTolerances &tolerances) const
    {
      Sundials::IdaSettings settings;
      const unsigned int    size = 2 * n + 2 * m + n_states;
      settings.is_differential.resize(size);
      settings.is_differential << Eigen::VectorXd::Ones(2 * n),
        Eigen::VectorXd::Zero(2 * m), Eigen::VectorXd::Ones(n_states);
      // Multipliers follow from q and v at every instant: they must not keep
      // Newton's method from converging.
      settings.absolute_tolerances.resize(size);
      settings.absolute_tolerances << tolerances.positions,
        tolerances.velocities, Eigen::VectorXd::Constant(2 * m, 1e30),
        tolerances.friction_states;
      settings.maximum_order = tolerances.maximum_order;
      settings.maximum_step  = tolerances.maximum_step;
      settings.initial_step  = tolerances.initial_step;
      return settings;
    }



    void
    MotionIntegrator::assemble_residual(
      const Sundials::ImplicitSystem::ConstVector &y,
      const Sundials::ImplicitSystem::ConstVector &y_t,
      const double                                 t,
      Sundials::ImplicitSystem::Vector            &residual)
    {
      const auto q = y.head(n);
      const auto v = y.segment(n, n);
      const auto z = y.tail(n_states);

      equations.assemble_forces(t, q, v, current.approach_speeds, z, forces);
      residual.head(n) = y_t.head(n) - v;
      residual.segment(n, n) =
        equations.mechanism().masses().cwiseProduct(y_t.segment(n, n)) - forces;
      equations.assemble_constraint_terms(t,
                                          q,
                                          v,
                                          y.segment(2 * n, m),
                                          y.segment(2 * n + m, m),
                                          residual.segment(2 * n, m),
                                          residual.segment(2 * n + m, m),
                                          residual.segment(n, n),
                                          residual.head(n));
      if (n_states > 0)
        {
          equations.assemble_friction_state_rates(
            q, v, current.approach_speeds, z, residual.tail(n_states));
          residual.tail(n_states) =
            y_t.tail(n_states) - residual.tail(n_states);
        }
    }



    void
    MotionIntegrator::assemble_jacobian(
      const Sundials::ImplicitSystem::ConstVector &y,
      const double                                 t,
      const double                                 c,
      MatrixEntries                               &entries)
    {
      const auto             q      = y.head(n);
      const auto             v      = y.segment(n, n);
      const auto             z      = y.tail(n_states);
      const Eigen::VectorXd &masses = equations.mechanism().masses();
      for (unsigned int i = 0; i < n; ++i)
        {
          entries.add(i, i, c);
          entries.add(i, n + i, -1.);
          entries.add(n + i, n + i, c * masses(i));
        }
      equations.subtract_force_derivatives(
        t, q, v, current.approach_speeds, z, n, 0, n, entries);
      if (n_states > 0)
        {
          const Eigen::Index state = 2 * n + 2 * m;
          equations.subtract_friction_state_derivatives(
            q, v, current.approach_speeds, z, n, 0, n, state, entries);
          for (unsigned int k = 0; k < n_states; ++k)
            entries.add(state + k, state + k, c);
        }
      equations.add_constraint_derivatives(q,
                                           v,
                                           y.segment(2 * n, m),
                                           y.segment(2 * n + m, m),
                                           {0, n, 2 * n, 2 * n + m},
                                           entries);
    }



    void
    MotionIntegrator::evaluate_roots(
      const double                                 t,
      const Sundials::ImplicitSystem::ConstVector &y,
      double                                      *values)
    {
      const Mechanism   &mechanism  = equations.mechanism();
      const unsigned int n_contacts = mechanism.clearance_joints().size();
      const unsigned int n_joints =
        n_contacts + mechanism.impact_joints().size();
      // A contact that begins and ends within one step changes the sign of its
      // penetration at neither end. But the pin is farthest out in between:
      // where its rate falls through zero, the integrator looks. Not near the
      // centre of the bushing, where "outwards" is not a direction: at rest
      // there, as a motion may start, the rate is noise around zero.
      constexpr double not_flying  = -1.;
      constexpr double near_centre = 0.1;
      for (unsigned int j = 0; j < n_contacts; ++j)
        {
          values[j]            = equations.compute_penetration(j, y.head(n));
          values[n_joints + j] = not_flying;
          if (values[j] >= 0.)
            continue;
          const JointContact contact = equations.compute_contact(
            j, y.head(n), y.segment(n, n), current.approach_speeds[j], 0.);
          const double eccentricity = contact.eccentricity.norm();
          const double clearance    = eccentricity - contact.penetration;
          if (eccentricity > near_centre * clearance)
            values[n_joints + j] = contact.penetration_rate;
        }

      Eigen::VectorXd multipliers;
      for (unsigned int k = 0; k < mechanism.impact_joints().size(); ++k)
        {
          const ImpactJoint &joint  = mechanism.impact_joints()[k];
          double            &value  = values[n_contacts + k];
          double            &flight = values[n_joints + n_contacts + k];
          if (joint.is_following)
            {
              if (multipliers.size() == 0)
                multipliers =
                  compute_accelerations(equations, state_of(t, y)).multipliers;
              value  = multipliers(joint.first_row);
              flight = not_flying;
              continue;
            }
          const BodyPair &bodies = joint.link->bodies;
          value = joint.compute_penetration(bodies.gather(y.head(n)));
          flight =
            (value < 0. && value > (near_centre - 1.) * joint.link->length)
              ? joint.normal_row(bodies.gather(y.head(n)))
                  .dot(bodies.gather(y.segment(n, n)))
              : not_flying;
        }
    }



    void
    MotionIntegrator::start(const MechanismState &state)
    {
      current = state;
      const std::vector<ClearanceJoint> &joints =
        equations.mechanism().clearance_joints();
      current.approach_speeds.resize(joints.size());
      for (unsigned int j = 0; j < joints.size(); ++j)
        current.approach_speeds[j] = joints[j].minimum_approach_speed;
      if (current.friction_states.size() != n_states)
        {
          current.friction_states = Eigen::VectorXd::Zero(n_states);
          for (unsigned int j = 0; j < joints.size(); ++j)
            if (joints[j].friction_state_index >= 0)
              {
                const JointContact contact =
                  equations.compute_contact(j, current);
                if (contact.penetration > 0)
                  current.friction_states(joints[j].friction_state_index) =
                    compute_steady_friction_state(joints[j].friction_law,
                                                  contact.sliding_speed);
              }
        }
      the_events.clear();
      the_peak_forces.assign(joints.size(), 0.);
      contact_peak_forces.assign(joints.size(), 0.);
      the_drift = 0.;
      restart();
    }



    void
    MotionIntegrator::resume(const MechanismState &state,
                             const double          initial_step)
    {
      current = state;
      const unsigned int n_contacts =
        equations.mechanism().clearance_joints().size();
      the_peak_forces.resize(n_contacts);
      contact_peak_forces.resize(n_contacts);
      restart(initial_step);
    }



    void
    MotionIntegrator::restart(const double initial_step)
    {
      const Accelerations accelerations =
        compute_accelerations(equations, current);
      Eigen::VectorXd rates(n_states);
      equations.assemble_friction_state_rates(current.q,
                                              current.v,
                                              current.approach_speeds,
                                              current.friction_states,
                                              rates);
      const unsigned int size = 2 * n + 2 * m + n_states;
      Eigen::VectorXd    y(size), y_t(size);
      y << current.q, current.v, accelerations.multipliers,
        Eigen::VectorXd::Zero(m), current.friction_states;
      y_t << current.v, accelerations.a, Eigen::VectorXd::Zero(2 * m), rates;
      ida->start(current.time, y, y_t, initial_step);
      if (energy_account != nullptr)
        energy_account->restart(current);
      restart_is_pending = false;
      stop_is_pending    = false;
      the_stops.clear();
    }



    MechanismState
    MotionIntegrator::state_of(const double                             t,
                               const Eigen::Ref<const Eigen::VectorXd> &y) const
    {
      return {t,
              y.head(n),
              y.segment(n, n),
              current.approach_speeds,
              y.tail(n_states),
              current.is_following};
    }



    bool
    MotionIntegrator::goes_outside(const ImpactJoint     &joint,
                                   const Eigen::VectorXd &y) const
    {
      const BodyPair  &bodies = joint.link->bodies;
      const PairVector q      = bodies.gather(y.head(n));
      return joint.compute_penetration(q) > 0. &&
             joint.normal_row(q).dot(bodies.gather(y.segment(n, n))) > 0.;
    }



    void
    MotionIntegrator::record_step(const std::vector<int> &roots)
    {
      const Eigen::VectorXd &y         = ida->solution();
      const Mechanism       &mechanism = equations.mechanism();
      equations.assemble_constraints(ida->time(), y.head(n), phi);
      if (m > 0)
        the_drift = std::max(the_drift, phi.lpNorm<Eigen::Infinity>());
      const unsigned int n_contacts = mechanism.clearance_joints().size();
      for (unsigned int j = 0; j < n_contacts; ++j)
        {
          const int k = mechanism.clearance_joints()[j].friction_state_index;
          const JointContact contact =
            equations.compute_contact(j,
                                      y.head(n),
                                      y.segment(n, n),
                                      current.approach_speeds[j],
                                      k < 0 ? 0. : y(2 * n + 2 * m + k));
          const double force =
            std::hypot(contact.normal_force, contact.tangential_force);
          the_peak_forces[j]     = std::max(the_peak_forces[j], force);
          contact_peak_forces[j] = std::max(contact_peak_forces[j], force);
          if (roots[j] == 0)
            continue;
          the_events.push_back({ida->time(),
                                j,
                                roots[j] > 0,
                                contact.penetration_rate,
                                contact_peak_forces[j]});
          contact_peak_forces[j] = 0.;
          restart_is_pending     = restart_is_pending || roots[j] > 0;
        }
      // A flying pin hits where its penetration rises through zero, a following
      // one flies where its force falls through it. One that begins at the bore
      // may be outside by rounding already, and then nothing rises through
      // zero.
      for (unsigned int k = 0; k < mechanism.impact_joints().size(); ++k)
        {
          const ImpactJoint &joint = mechanism.impact_joints()[k];
          const int          root  = roots[n_contacts + k];
          if (joint.is_following ? root == -1
                                 : root == 1 || goes_outside(joint, y))
            the_stops.push_back(k);
        }
      stop_is_pending = !the_stops.empty();
    }



    void
    MotionIntegrator::take_stop()
    {
      current = state_of(ida->time(), ida->solution());
      for (auto e = the_events.rbegin();
           e != the_events.rend() && e->time == current.time;
           ++e)
        if (e->is_onset)
          {
            const ClearanceJoint &joint =
              equations.mechanism().clearance_joints()[e->joint];
            current.approach_speeds[e->joint] =
              std::max(e->penetration_rate, joint.minimum_approach_speed);
            if (joint.friction_state_index >= 0)
              current.friction_states(joint.friction_state_index) = 0.;
          }
    }



    std::string
    MotionIntegrator::describe_deepest_contact() const
    {
      const Eigen::VectorXd             &y = ida->solution();
      const std::vector<ClearanceJoint> &joints =
        equations.mechanism().clearance_joints();
      double      deepest = -std::numeric_limits<double>::infinity();
      std::string name;
      for (unsigned int j = 0; j < joints.size(); ++j)
        {
          const double penetration =
            equations.compute_penetration(j, y.head(n));
          if (penetration > deepest)
            {
              deepest = penetration;
              name    = joints[j].name;
            }
        }
      if (name.empty())
        return "";
      return " Of the joints with clearance, '" + name +
             "' has the largest penetration there, " +
             significant_digits(1e6 * deepest) + " um.";
    }



    const MechanismState &
    MotionIntegrator::advance_to(const double        t,
                                 const unsigned long maximum_steps,
                                 const unsigned long n_steps_before)
    {
      if (t == current.time && !stop_is_pending)
        return current;
      unsigned long n_steps = n_steps_before;
      while (ida->time() < t && !stop_is_pending)
        {
          stop_if_interrupted();
          book_energy(ida->time());
          if (restart_is_pending)
            {
              // The step behind us went past the onset with an approach speed
              // of the contact before. It is given up from there on.
              take_stop();
              restart();
            }
          AssertThrow(n_steps++ < maximum_steps,
                      ExcRun("The integration of the motion took more than " +
                             std::to_string(maximum_steps) +
                             " steps in one cycle ('Dynamics/Maximum steps "
                             "per cycle') and has only reached time " +
                             significant_digits(ida->time(), 6) +
                             " s. A larger 'Dynamics/Accuracy' takes longer "
                             "steps." +
                             describe_deepest_contact()));
          try
            {
              record_step(ida->step(t + 1.));
            }
          catch (const ExcRun &error)
            {
              throw ExcRun(message_of(error) + describe_deepest_contact());
            }
        }
      if (stop_is_pending && ida->time() <= t)
        {
          book_energy(ida->time());
          take_stop();
          return current;
        }
      book_energy(t);
      current = state_at(t);
      return current;
    }



    MechanismState
    MotionIntegrator::state_at(const double t)
    {
      ida->interpolate(t, interpolated);
      return state_of(t, interpolated);
    }



    void
    MotionIntegrator::set_energy_account(EnergyAccount *account)
    {
      energy_account = account;
      if (account != nullptr)
        account->open(current);
    }



    void
    MotionIntegrator::book_energy(const double t)
    {
      if (energy_account != nullptr && t > energy_account->time())
        energy_account->advance(state_at((energy_account->time() + t) / 2),
                                state_at(t));
    }



    Sundials::IntegratorStatistics
    MotionIntegrator::statistics() const
    {
      return ida->statistics();
    }
  } // namespace Multibody
} // namespace Tribody

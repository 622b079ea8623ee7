#include <tribody/base/exceptions.h>
#include <tribody/multibody/kinematics.h>
#include <tribody/multibody/mechanism.h>
#include <tribody/multibody/motion_integrator.h>
#include <tribody/multibody/significant_digits.h>

#include <algorithm>
#include <cmath>

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
      , phi_q(m, n)
      , phi_t(m)
      , phi_tt(m)
      , forces(n)
    {
      ida = std::make_unique<IdaIntegrator>(make_system(),
                                            make_settings(tolerances));
    }



    MotionIntegrator::~MotionIntegrator() = default;



    ImplicitSystem
    MotionIntegrator::make_system()
    {
      ImplicitSystem system;
      system.residual = [this](const double                       t,
                               const ImplicitSystem::ConstVector &y,
                               const ImplicitSystem::ConstVector &y_t,
                               ImplicitSystem::Vector            &residual) {
        assemble_residual(y, y_t, t, residual);
      };
      system.jacobian = [this](const double /*t*/,
                               const double                       c,
                               const ImplicitSystem::ConstVector &y,
                               const ImplicitSystem::ConstVector & /*y_t*/,
                               ImplicitSystem::Matrix &jacobian) {
        assemble_jacobian(y, c, jacobian);
      };
      system.n_roots = equations.mechanism().clearance_joints().size() +
                       equations.mechanism().impact_joints().size();
      system.roots = [this](const double                       t,
                            const ImplicitSystem::ConstVector &y,
                            double *values) { evaluate_roots(t, y, values); };
      return system;
    }



    IdaSettings
    MotionIntegrator::make_settings(const MotionTolerances &tolerances) const
    {
      IdaSettings        settings;
      const unsigned int size = 2 * n + 2 * m + n_states;
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
    MotionIntegrator::assemble_residual(const ImplicitSystem::ConstVector &y,
                                        const ImplicitSystem::ConstVector &y_t,
                                        const double                       t,
                                        ImplicitSystem::Vector &residual)
    {
      const auto q      = y.head(n);
      const auto v      = y.segment(n, n);
      const auto lambda = y.segment(2 * n, m);
      const auto mu     = y.segment(2 * n + m, m);
      const auto z      = y.tail(n_states);

      equations.assemble_constraint_jacobian(q, phi_q);
      equations.assemble_time_derivatives(t, phi_t, phi_tt);
      equations.assemble_forces(q, v, current.approach_speeds, z, forces);

      residual.head(n) = y_t.head(n) - v;
      residual.head(n).noalias() -= phi_q.transpose() * mu;
      residual.segment(n, n) =
        equations.mechanism().masses().cwiseProduct(y_t.segment(n, n)) - forces;
      residual.segment(n, n).noalias() += phi_q.transpose() * lambda;
      equations.assemble_constraints(t, q, residual.segment(2 * n, m));
      residual.segment(2 * n + m, m) = phi_t;
      residual.segment(2 * n + m, m).noalias() += phi_q * v;
      if (n_states > 0)
        {
          equations.assemble_friction_state_rates(
            q, v, current.approach_speeds, z, residual.tail(n_states));
          residual.tail(n_states) =
            y_t.tail(n_states) - residual.tail(n_states);
        }
    }



    void
    MotionIntegrator::assemble_jacobian(const ImplicitSystem::ConstVector &y,
                                        const double                       c,
                                        ImplicitSystem::Matrix &jacobian)
    {
      const auto q      = y.head(n);
      const auto v      = y.segment(n, n);
      const auto lambda = y.segment(2 * n, m);
      const auto mu     = y.segment(2 * n + m, m);
      const auto z      = y.tail(n_states);

      equations.assemble_constraint_jacobian(q, phi_q);

      // q' - v - Phi_q^T mu
      jacobian.block(0, 0, n, n).diagonal().setConstant(c);
      equations.add_multiplier_derivative(q,
                                          mu,
                                          -1.,
                                          jacobian.block(0, 0, n, n));
      jacobian.block(0, n, n, n).diagonal().setConstant(-1.);
      jacobian.block(0, 2 * n + m, n, m) = -phi_q.transpose();

      // M v' - Q + Phi_q^T lambda
      equations.subtract_force_derivatives(q,
                                           v,
                                           current.approach_speeds,
                                           z,
                                           jacobian.block(n, 0, n, n),
                                           jacobian.block(n, n, n, n));
      equations.add_multiplier_derivative(q,
                                          lambda,
                                          1.,
                                          jacobian.block(n, 0, n, n));
      jacobian.block(n, n, n, n).diagonal() +=
        c * equations.mechanism().masses();
      jacobian.block(n, 2 * n, n, m) = phi_q.transpose();

      // Phi and Phi_q v + Phi_t
      jacobian.block(2 * n, 0, m, n) = phi_q;
      equations.add_velocity_derivative(q,
                                        v,
                                        jacobian.block(2 * n + m, 0, m, n));
      jacobian.block(2 * n + m, n, m, n) = phi_q;

      // z' - z'(q, v, z)
      if (n_states > 0)
        {
          const unsigned int row = 2 * n + 2 * m;
          equations.subtract_friction_state_derivatives(
            q,
            v,
            current.approach_speeds,
            z,
            jacobian.block(n, row, n, n_states),
            jacobian.block(row, 0, n_states, n),
            jacobian.block(row, n, n_states, n),
            jacobian.block(row, row, n_states, n_states));
          jacobian.block(row, row, n_states, n_states).diagonal().array() += c;
        }
    }



    Eigen::VectorXd
    MotionIntegrator::exact_multipliers(const double                       t,
                                        const ImplicitSystem::ConstVector &y)
    {
      const Eigen::VectorXd q = y.head(n), v = y.segment(n, n);
      equations.assemble_forces(
        q, v, current.approach_speeds, y.tail(n_states), forces);
      return compute_accelerations(
               equations, t, ConstraintOffsets(m), q, v, forces)
        .multipliers;
    }



    void
    MotionIntegrator::evaluate_roots(const double                       t,
                                     const ImplicitSystem::ConstVector &y,
                                     double                            *values)
    {
      const Mechanism   &mechanism  = equations.mechanism();
      const unsigned int n_contacts = mechanism.clearance_joints().size();
      for (unsigned int j = 0; j < n_contacts; ++j)
        values[j] = equations.compute_penetration(j, y.head(n));

      Eigen::VectorXd multipliers;
      for (unsigned int k = 0; k < mechanism.impact_joints().size(); ++k)
        {
          const ImpactJoint &joint = mechanism.impact_joints()[k];
          if (joint.is_following && multipliers.size() == 0)
            multipliers = exact_multipliers(t, y);
          values[n_contacts + k] =
            joint.is_following
              ? multipliers(joint.first_row)
              : joint.compute_penetration(joint.link->bodies.gather(y.head(n)));
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
      the_drift = 0.;
      restart();
    }



    void
    MotionIntegrator::resume(const MechanismState &state,
                             const double          initial_step)
    {
      current = state;
      the_peak_forces.resize(equations.mechanism().clearance_joints().size());
      restart(initial_step);
    }



    void
    MotionIntegrator::restart(const double initial_step)
    {
      equations.assemble_forces(current.q,
                                current.v,
                                current.approach_speeds,
                                current.friction_states,
                                forces);
      const Accelerations accelerations =
        compute_accelerations(equations,
                              current.time,
                              ConstraintOffsets(m),
                              current.q,
                              current.v,
                              forces);
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
      restart_is_pending = false;
      stop_is_pending    = false;
      the_stops.clear();
    }



    void
    MotionIntegrator::update_current(const double t, const Eigen::VectorXd &y)
    {
      current.time            = t;
      current.q               = y.head(n);
      current.v               = y.segment(n, n);
      current.friction_states = y.tail(n_states);
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
          the_peak_forces[j] = std::max(the_peak_forces[j],
                                        std::hypot(contact.normal_force,
                                                   contact.tangential_force));
          if (roots[j] == 0)
            continue;
          the_events.push_back(
            {ida->time(), j, roots[j] > 0, contact.penetration_rate});
          restart_is_pending = restart_is_pending || roots[j] > 0;
        }
      // A flying pin hits where its penetration rises through zero, a following
      // one flies where its force falls through it.
      for (unsigned int k = 0; k < mechanism.impact_joints().size(); ++k)
        if (roots[n_contacts + k] ==
            (mechanism.impact_joints()[k].is_following ? -1 : 1))
          the_stops.push_back(k);
      stop_is_pending = !the_stops.empty();
    }



    void
    MotionIntegrator::take_stop()
    {
      update_current(ida->time(), ida->solution());
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
                             "steps."));
          record_step(ida->step(t + 1.));
        }
      if (stop_is_pending && ida->time() <= t)
        {
          take_stop();
          return current;
        }
      ida->interpolate(t, interpolated);
      update_current(t, interpolated);
      return current;
    }



    IntegratorStatistics
    MotionIntegrator::statistics() const
    {
      return ida->statistics();
    }
  } // namespace Multibody
} // namespace Tribody

#include <tribody/base/exceptions.h>
#include <tribody/multibody/energy_account.h>
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
      , phi(m)
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
      system.jacobian = [this](const double                       t,
                               const double                       c,
                               const ImplicitSystem::ConstVector &y,
                               const ImplicitSystem::ConstVector & /*y_t*/,
                               MatrixEntries &entries) {
        assemble_jacobian(y, t, c, entries);
      };
      system.n_roots = equations.mechanism().clearance_joints().size();
      system.roots =
        [this, n_roots = system.n_roots](const double /*t*/,
                                         const ImplicitSystem::ConstVector &y,
                                         double *values) {
          for (unsigned int j = 0; j < n_roots; ++j)
            values[j] = equations.compute_penetration(j, y.head(n));
        };
      return system;
    }



    IdaSettings
    MotionIntegrator::make_settings(const MotionTolerances &tolerances) const
    {
      IdaSettings settings;
      settings.is_differential.resize(2 * n + 2 * m);
      settings.is_differential << Eigen::VectorXd::Ones(2 * n),
        Eigen::VectorXd::Zero(2 * m);
      // Multipliers follow from q and v at every instant: they must not keep
      // Newton's method from converging.
      settings.absolute_tolerances.resize(2 * n + 2 * m);
      settings.absolute_tolerances << tolerances.positions,
        tolerances.velocities, Eigen::VectorXd::Constant(2 * m, 1e30);
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
      const auto q = y.head(n);
      const auto v = y.segment(n, n);

      equations.assemble_forces(t, q, v, current.approach_speeds, forces);
      residual.head(n) = y_t.head(n) - v;
      residual.segment(n, n) =
        equations.mechanism().masses().cwiseProduct(y_t.segment(n, n)) - forces;
      equations.assemble_constraint_terms(t,
                                          q,
                                          v,
                                          y.segment(2 * n, m),
                                          y.tail(m),
                                          residual.segment(2 * n, m),
                                          residual.tail(m),
                                          residual.segment(n, n),
                                          residual.head(n));
    }



    void
    MotionIntegrator::assemble_jacobian(const ImplicitSystem::ConstVector &y,
                                        const double                       t,
                                        const double                       c,
                                        MatrixEntries &entries)
    {
      const auto             q      = y.head(n);
      const auto             v      = y.segment(n, n);
      const Eigen::VectorXd &masses = equations.mechanism().masses();
      for (unsigned int i = 0; i < n; ++i)
        {
          entries.add(i, i, c);
          entries.add(i, n + i, -1.);
          entries.add(n + i, n + i, c * masses(i));
        }
      equations.subtract_force_derivatives(
        t, q, v, current.approach_speeds, n, 0, n, entries);
      equations.add_constraint_derivatives(q,
                                           v,
                                           y.segment(2 * n, m),
                                           y.tail(m),
                                           {0, n, 2 * n, 2 * n + m},
                                           entries);
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
      the_events.clear();
      the_peak_forces.assign(joints.size(), 0.);
      contact_peak_forces.assign(joints.size(), 0.);
      the_drift = 0.;
      restart();
    }



    void
    MotionIntegrator::restart()
    {
      equations.assemble_forces(
        current.time, current.q, current.v, current.approach_speeds, forces);
      const Accelerations accelerations =
        compute_accelerations(equations,
                              current.time,
                              ConstraintOffsets(m),
                              current.q,
                              current.v,
                              forces);
      Eigen::VectorXd y(2 * n + 2 * m), y_t(2 * n + 2 * m);
      y << current.q, current.v, accelerations.multipliers,
        Eigen::VectorXd::Zero(m);
      y_t << current.v, accelerations.a, Eigen::VectorXd::Zero(2 * m);
      ida->start(current.time, y, y_t);
      if (energy_account != nullptr)
        energy_account->restart(current);
      restart_is_pending = false;
    }



    void
    MotionIntegrator::record_step(const std::vector<int> &roots)
    {
      const Eigen::VectorXd &y = ida->solution();
      equations.assemble_constraints(ida->time(), y.head(n), phi);
      if (m > 0)
        the_drift = std::max(the_drift, phi.lpNorm<Eigen::Infinity>());
      for (unsigned int j = 0; j < roots.size(); ++j)
        {
          const JointContact contact = equations.compute_contact(
            j, y.head(n), y.segment(n, n), current.approach_speeds[j]);
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
    }



    const MechanismState &
    MotionIntegrator::advance_to(const double        t,
                                 const unsigned long maximum_steps,
                                 const unsigned long n_steps_before)
    {
      if (t == current.time)
        return current;
      unsigned long n_steps = n_steps_before;
      while (ida->time() < t)
        {
          book_energy(ida->time());
          if (restart_is_pending)
            {
              // The step behind us went past the onset with an approach speed
              // of the contact before. It is given up from there on.
              current.time = ida->time();
              current.q    = ida->solution().head(n);
              current.v    = ida->solution().segment(n, n);
              for (auto e = the_events.rbegin();
                   e != the_events.rend() && e->time == current.time;
                   ++e)
                if (e->is_onset)
                  current.approach_speeds[e->joint] =
                    std::max(e->penetration_rate,
                             equations.mechanism()
                               .clearance_joints()[e->joint]
                               .minimum_approach_speed);
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
      book_energy(t);
      current = state_at(t);
      return current;
    }



    MechanismState
    MotionIntegrator::state_at(const double t)
    {
      ida->interpolate(t, interpolated);
      return {t,
              interpolated.head(n),
              interpolated.segment(n, n),
              current.approach_speeds};
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



    IntegratorStatistics
    MotionIntegrator::statistics() const
    {
      return ida->statistics();
    }
  } // namespace Multibody
} // namespace Tribody

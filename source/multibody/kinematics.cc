#include <Eigen/LU>
#include <Eigen/QR>

#include <tribody/base/exceptions.h>
#include <tribody/base/solver_report.h>
#include <tribody/multibody/equations_of_motion.h>
#include <tribody/multibody/kinematics.h>
#include <tribody/multibody/mechanism.h>
#include <tribody/multibody/significant_digits.h>

#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      std::string
      degrees(const double angle)
      {
        return significant_digits(angle * 180 / M_PI) + " deg";
      }



      // Where the drivers want their bodies at time t, for messages.
      std::string
      driver_angles(const Mechanism &mechanism, const double t)
      {
        std::string result;
        for (const DriverParameters &d : mechanism.parameters().drivers)
          result += (result.empty() ? "" : ", ") + d.name + " at " +
                    degrees(d.initial_angle + d.speed * t);
        return result;
      }



      // How far the equations of a constraint are from zero, for messages: of
      // a translational joint, what is worse of its gap and its angle.
      std::string
      describe_gap(const Constraint      &constraint,
                   const Eigen::VectorXd &phi,
                   const double           size)
      {
        double length = 0., angle = 0.;
        for (unsigned int i = 0; i < constraint.n_equations; ++i)
          if (constraint.is_angle(i))
            angle = std::abs(phi(i));
          else
            length = std::hypot(length, phi(i));
        return angle * size > length
                 ? "an angle of " + degrees(angle)
                 : "a gap of " + significant_digits(1e3 * length) + " mm";
      }



      // Phi_q in units of the mechanism's size: columns of angles divided by
      // it, so that a turn counts as the way that it moves a point.
      Eigen::MatrixXd
      scaled_jacobian(const EquationsOfMotion &equations,
                      const Eigen::VectorXd   &q)
      {
        const Mechanism &mechanism = equations.mechanism();
        Eigen::MatrixXd  jacobian(mechanism.n_constraints(),
                                 mechanism.n_coordinates());
        equations.assemble_constraint_jacobian(q, jacobian);
        for (unsigned int i = 2; i < mechanism.n_coordinates(); i += 3)
          jacobian.col(i) /= mechanism.size();
        return jacobian;
      }



      // The shortest x with Phi_q x = right_hand_side, or the best one.
      Eigen::VectorXd
      solve_least_norm(const EquationsOfMotion &equations,
                       const Eigen::VectorXd   &q,
                       const Eigen::VectorXd   &right_hand_side)
      {
        const Mechanism &mechanism = equations.mechanism();
        if (mechanism.n_constraints() == 0)
          return Eigen::VectorXd::Zero(mechanism.n_coordinates());
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
        solver.setThreshold(1e-10);
        solver.compute(scaled_jacobian(equations, q));
        Eigen::VectorXd x = solver.solve(right_hand_side);
        for (unsigned int i = 2; i < mechanism.n_coordinates(); i += 3)
          x(i) /= mechanism.size();
        return x;
      }
    } // namespace



    ConstraintOffsets::ConstraintOffsets(const unsigned int n_constraints)
      : value(Eigen::VectorXd::Zero(n_constraints))
      , first_derivative(value)
      , second_derivative(value)
    {}



    SolverReport
    solve_positions(const EquationsOfMotion &equations,
                    const double             t,
                    const ConstraintOffsets &offsets,
                    Eigen::VectorXd         &q)
    {
      const Mechanism &mechanism = equations.mechanism();
      SolverReport     report;
      Eigen::VectorXd  phi(mechanism.n_constraints());
      const double     size = mechanism.size();
      // Converged where a further step no longer improves on rounding.
      for (; report.n_iterations < 100; ++report.n_iterations)
        {
          equations.assemble_constraints(t, q, phi);
          phi -= offsets.value;
          report.residual  = phi.lpNorm<Eigen::Infinity>() / size;
          report.converged = report.residual < 1e-12;
          if (report.residual < 1e-15 || phi.size() == 0)
            break;
          Eigen::VectorXd step   = -solve_least_norm(equations, q, phi);
          const double    length = step.norm();
          // Far from a solution a full step may turn a body over.
          if (length > size)
            step *= size / length;
          q += step;
          if (report.converged && length < 1e-14 * size)
            break;
          if (report.converged && report.n_iterations > 20)
            break;
        }
      if (phi.size() == 0)
        report.converged = true;
      if (!report.converged)
        report.message = "Newton's method for the positions did not converge";
      return report;
    }



    Eigen::VectorXd
    compute_velocities(const EquationsOfMotion &equations,
                       const double             t,
                       const ConstraintOffsets &offsets,
                       const Eigen::VectorXd   &q)
    {
      const unsigned int m = equations.mechanism().n_constraints();
      Eigen::VectorXd    phi_t(m), phi_tt(m);
      equations.assemble_time_derivatives(t, phi_t, phi_tt);
      return solve_least_norm(equations, q, offsets.first_derivative - phi_t);
    }



    Accelerations
    compute_accelerations(const EquationsOfMotion &equations,
                          const double             t,
                          const ConstraintOffsets &offsets,
                          const Eigen::VectorXd   &q,
                          const Eigen::VectorXd   &v,
                          const Eigen::VectorXd   &forces)
    {
      const Mechanism   &mechanism = equations.mechanism();
      const unsigned int n         = mechanism.n_coordinates();
      const unsigned int m         = mechanism.n_constraints();

      Eigen::MatrixXd matrix    = Eigen::MatrixXd::Zero(n + m, n + m);
      matrix.diagonal().head(n) = mechanism.masses();
      equations.assemble_constraint_jacobian(q, matrix.bottomLeftCorner(m, n));
      matrix.topRightCorner(n, m) = matrix.bottomLeftCorner(m, n).transpose();

      Eigen::VectorXd phi_t(m), phi_tt(m), quadratic(m), right_hand_side(n + m);
      equations.assemble_time_derivatives(t, phi_t, phi_tt);
      equations.assemble_quadratic_terms(q, v, quadratic);
      right_hand_side << forces, offsets.second_derivative - quadratic - phi_tt;

      const Eigen::VectorXd x = matrix.partialPivLu().solve(right_hand_side);
      return {x.head(n), x.tail(m)};
    }



    Motion
    solve_motion(const EquationsOfMotion &equations,
                 const double             t,
                 const ConstraintOffsets &offsets,
                 const Eigen::VectorXd   &extra_forces,
                 const Eigen::VectorXd   &q_guess)
    {
      Motion motion;
      motion.q = q_guess;
      const SolverReport report =
        solve_positions(equations, t, offsets, motion.q);
      AssertThrow(report.converged,
                  ExcRun("At time " + significant_digits(t, 6) +
                         " s the mechanism has no position near the one "
                         "before: " +
                         report.message));
      motion.v = compute_velocities(equations, t, offsets, motion.q);
      Eigen::VectorXd forces(motion.q.size());
      equations.assemble_forces(motion.q, motion.v, {}, forces);
      forces += extra_forces;
      const Accelerations result = compute_accelerations(
        equations, t, offsets, motion.q, motion.v, forces);
      motion.a           = result.a;
      motion.multipliers = result.multipliers;
      return motion;
    }



    Eigen::VectorXd
    assemble_configuration(const EquationsOfMotion &equations, const double t)
    {
      const Mechanism        &mechanism = equations.mechanism();
      const ConstraintOffsets none(mechanism.n_constraints());
      Eigen::VectorXd         q      = mechanism.initial_coordinates();
      const SolverReport      report = solve_positions(equations, t, none, q);
      if (report.converged)
        return q;

      Eigen::VectorXd phi(mechanism.n_constraints());
      equations.assemble_constraints(t, q, phi);
      const NumberedConstraint *worst     = nullptr;
      double                    worst_gap = -1.;
      for (const NumberedConstraint &c : mechanism.constraints())
        {
          const double gap =
            phi.segment(c.first_row, c.constraint->n_equations).norm();
          if (gap > worst_gap)
            {
              worst     = &c;
              worst_gap = gap;
            }
        }
      const Constraint &constraint = *worst->constraint;
      std::string       hint;
      if (!mechanism.parameters().drivers.empty())
        hint = ", and can the driven bodies be where the drivers want them (" +
               driver_angles(mechanism, t) + ")";
      AssertThrow(
        false,
        ExcParameter(constraint.description,
                     "cannot be closed: " +
                       describe_gap(constraint,
                                    phi.segment(worst->first_row,
                                                constraint.n_equations),
                                    mechanism.size()) +
                       " remains. Are the markers right, are the bodies' "
                       "initial positions and angles near a configuration "
                       "that exists" +
                       hint + "?"));
      return q;
    }



    void
    check_full_cycle(const EquationsOfMotion &equations,
                     const unsigned int       n_steps)
    {
      const Mechanism        &mechanism = equations.mechanism();
      const DriverParameters &driver = mechanism.parameters().drivers.front();
      const ConstraintOffsets none(mechanism.n_constraints());
      const double            step     = mechanism.period() / n_steps;
      const auto              angle_at = [&](const unsigned int k) {
        return degrees(driver.initial_angle + driver.speed * k * step);
      };
      Eigen::VectorXd q = assemble_configuration(equations, 0.);
      for (unsigned int k = 1; k <= n_steps; ++k)
        AssertThrow(
          solve_positions(equations, k * step, none, q).converged,
          ExcParameter("Drivers",
                       "must be able to make a full turn with ideal joints, "
                       "but the mechanism locks between the angles " +
                         angle_at(k - 1) + " and " + angle_at(k) +
                         " of driver '" + driver.name +
                         "'. Are the links' lengths right?"));
    }



    void
    check_redundancy(const EquationsOfMotion &equations,
                     const Eigen::VectorXd   &q)
    {
      const Mechanism   &mechanism = equations.mechanism();
      const unsigned int m         = mechanism.n_constraints();
      if (m == 0)
        return;
      Eigen::MatrixXd jacobian = scaled_jacobian(equations, q);
      for (unsigned int i = 0; i < m; ++i)
        jacobian.row(i).normalize();
      Eigen::FullPivLU<Eigen::MatrixXd> decomposition(jacobian.transpose());
      decomposition.setThreshold(1e-9);
      if (decomposition.rank() == m)
        return;

      // Every combination of rows that vanishes shows up in the null space of
      // the transpose; the joints with entries there depend on each other.
      const Eigen::MatrixXd kernel = decomposition.kernel();
      std::string           names;
      for (const auto &[constraint, row] : mechanism.constraints())
        if (kernel.middleRows(row, constraint->n_equations)
              .lpNorm<Eigen::Infinity>() >
            1e-6 * kernel.lpNorm<Eigen::Infinity>())
          names += (names.empty() ? "" : ", ") + constraint->description;
      const unsigned int surplus = m - decomposition.rank();
      AssertThrow(false,
                  ExcParameter("Joints",
                               std::to_string(surplus) +
                                 " constraint(s) follow from the others or "
                                 "contradict them in the initial "
                                 "configuration. Those that depend on each "
                                 "other belong to: " +
                                 names + ". Remove one of them"));
    }
  } // namespace Multibody
} // namespace Tribody

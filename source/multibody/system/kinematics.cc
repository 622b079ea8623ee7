// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SparseLU>

#include <tribody/base/exceptions.h>
#include <tribody/base/significant_digits.h>
#include <tribody/base/solver_report.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>

#include <algorithm>
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
        return significant_digits(angle * 180 / dealii::numbers::PI) + " deg";
      }



      std::string
      millimetres(const double length)
      {
        return significant_digits(1e3 * length) + " mm";
      }



      // Where the drivers want their bodies at time t, for messages.
      std::string
      driver_positions(const Mechanism &mechanism, const double t)
      {
        std::string result;
        for (unsigned int i = 0; i < mechanism.drivers().size(); ++i)
          {
            const DriverParameters &driver = mechanism.parameters().drivers[i];
            const double position = mechanism.drivers()[i].motion.value(t);
            result +=
              (result.empty() ? "" : ", ") + driver.name + " at " +
              (driver.is_angle() ? degrees(position) : millimetres(position));
          }
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
        return angle * size > length ? "an angle of " + degrees(angle)
                                     : "a gap of " + millimetres(length);
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



      // The configuration near q in which the squares of all gaps (angles times
      // the mechanism's size) have the least sum, by the method of Levenberg
      // and Marquardt: what can be closed is closed, and what cannot is told by
      // how much. Unlike Newton's method it ends at the same place on any
      // machine.
      Eigen::VectorXd
      find_smallest_gaps(const EquationsOfMotion &equations,
                         const double             t,
                         const Eigen::VectorXd   &q_guess,
                         const Constraint        *open = nullptr)
      {
        const Mechanism   &mechanism = equations.mechanism();
        const unsigned int n         = mechanism.n_coordinates();
        const double       size      = mechanism.size();
        Eigen::VectorXd    weights(mechanism.n_constraints());
        constexpr double   heavy = 1e3;
        for (unsigned int c = 0; c < mechanism.constraints().size(); ++c)
          {
            const auto &[constraint, row] = mechanism.constraints()[c];
            const bool is_light = open == nullptr ? !mechanism.is_driver(c)
                                                  : constraint.get() == open;
            for (unsigned int i = 0; i < constraint->n_equations; ++i)
              weights(row + i) =
                (is_light ? 1. : heavy) * (constraint->is_angle(i) ? size : 1.);
          }
        const auto gaps = [&](const Eigen::VectorXd &q) {
          Eigen::VectorXd phi(weights.size());
          equations.assemble_constraints(t, q, phi);
          return Eigen::VectorXd(weights.cwiseProduct(phi));
        };

        Eigen::VectorXd q = q_guess, r = gaps(q);
        double          damping = 1e-3;
        for (unsigned int k = 0; k < 500 && damping < 1e12; ++k)
          {
            const Eigen::MatrixXd jacobian =
              weights.asDiagonal() * scaled_jacobian(equations, q);
            const Eigen::MatrixXd matrix =
              jacobian.transpose() * jacobian +
              damping * Eigen::MatrixXd::Identity(n, n);
            Eigen::VectorXd step =
              -matrix.ldlt().solve(jacobian.transpose() * r);
            const double length = step.norm();
            if (length < 1e-9 * size)
              break;
            step *= std::min(1., size / length);
            for (unsigned int i = 2; i < n; i += 3)
              step(i) /= size;
            const Eigen::VectorXd r_new = gaps(q + step);
            if (r_new.norm() < r.norm())
              {
                q += step;
                r = r_new;
                damping /= 4;
              }
            else
              damping *= 8;
          }
        return q;
      }



      // What keeps a mechanism from being closed, for messages.
      struct OpenConstraint
      {
        // The joint or driver, as in the parameter file.
        std::string description;
        // "cannot be closed: a gap of 3 mm remains"
        std::string problem;
      };

      // The constraint that can be opened so that all others close: of joints
      // in a loop the one with the largest share of the gap, or the first.
      OpenConstraint
      find_open_constraint(const EquationsOfMotion &equations,
                           const double             t,
                           const Eigen::VectorXd   &q_guess)
      {
        const Mechanism &mechanism                 = equations.mechanism();
        const std::vector<NumberedConstraint> &all = mechanism.constraints();
        Eigen::VectorXd                        phi(mechanism.n_constraints());
        const auto gap_of = [&](const NumberedConstraint &c) {
          return phi.segment(c.first_row, c.constraint->n_equations).norm();
        };

        const Eigen::VectorXd shared =
          find_smallest_gaps(equations, t, q_guess);
        equations.assemble_constraints(t, shared, phi);
        unsigned int worst = 0;
        for (unsigned int c = 1; c < all.size(); ++c)
          if (gap_of(all[c]) > 1.01 * gap_of(all[worst]))
            worst = c;
        const double              worst_gap  = gap_of(all[worst]);
        std::vector<unsigned int> candidates = {worst};
        for (unsigned int c = all.size(); c > 0; --c)
          candidates.push_back(c - 1);
        const Eigen::VectorXd shared_phi = phi;
        for (const unsigned int c : candidates)
          {
            equations.assemble_constraints(
              t,
              find_smallest_gaps(equations, t, shared, all[c].constraint.get()),
              phi);
            double others = 0.;
            for (unsigned int d = 0; d < all.size(); ++d)
              if (d != c)
                others = std::max(others, gap_of(all[d]));
            if (others < 1e-3 * worst_gap)
              {
                worst = c;
                break;
              }
            if (c == 0)
              phi = shared_phi;
          }
        const Constraint &constraint = *all[worst].constraint;
        return {constraint.description,
                (mechanism.is_driver(worst) ? "cannot be obeyed: "
                                            : "cannot be closed: ") +
                  describe_gap(constraint,
                               phi.segment(all[worst].first_row,
                                           constraint.n_equations),
                               mechanism.size()) +
                  " remains"};
      }



      // Newton's method ends up to 1e-6 of the size away from a singular
      // position, and the rows of Phi_q are dependent to that only.
      constexpr double singular_threshold = 1e-5;



      // Constraints that depend on each other at q, and how many are too many.
      struct DependentConstraints
      {
        unsigned int surplus = 0;
        std::string  names;
      };

      DependentConstraints
      find_dependent_constraints(const EquationsOfMotion &equations,
                                 const Eigen::VectorXd   &q,
                                 const double             threshold)
      {
        const Mechanism   &mechanism = equations.mechanism();
        const unsigned int m         = mechanism.n_constraints();
        if (m == 0)
          return {};
        Eigen::MatrixXd jacobian = scaled_jacobian(equations, q);
        // A row of zeros, of markers that coincide, stays one.
        for (unsigned int i = 0; i < m; ++i)
          jacobian.row(i).normalize();
        Eigen::FullPivLU<Eigen::MatrixXd> decomposition(jacobian.transpose());
        decomposition.setThreshold(threshold);
        if (decomposition.rank() == m)
          return {};

        // Every combination of rows that vanishes shows up in the null space of
        // the transpose; the joints with entries there depend on each other.
        const Eigen::MatrixXd kernel = decomposition.kernel();
        DependentConstraints  result;
        result.surplus = m - decomposition.rank();
        for (const auto &[constraint, row] : mechanism.constraints())
          if (kernel.middleRows(row, constraint->n_equations)
                .lpNorm<Eigen::Infinity>() >
              1e-6 * kernel.lpNorm<Eigen::Infinity>())
            result.names +=
              (result.names.empty() ? "" : ", ") + constraint->description;
        return result;
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
      // Systems of more unknowns than this are sparse; see doc/decisions.md,
      // "Linear solver of the dynamics".
      constexpr Eigen::Index largest_dense_system = 64;



      // The entries of a sparse matrix.
      class Triplets : public MatrixEntries
      {
      public:
        void
        add(const Eigen::Index row,
            const Eigen::Index column,
            const double       value) override
        {
          entries.emplace_back(row, column, value);
        }

        Eigen::SparseMatrix<double>
        matrix(const Eigen::Index size) const
        {
          Eigen::SparseMatrix<double> result(size, size);
          result.setFromTriplets(entries.begin(), entries.end());
          return result;
        }

      private:
        std::vector<Eigen::Triplet<double>> entries;
      };



      // x in (M, Phi_q^T; Phi_q, 0) x = right_hand_side.
      Eigen::VectorXd
      solve_saddle_point(const EquationsOfMotion &equations,
                         const Eigen::VectorXd   &q,
                         const Eigen::VectorXd   &right_hand_side)
      {
        const Eigen::Index     size   = right_hand_side.size();
        const Eigen::VectorXd &masses = equations.mechanism().masses();
        const auto             add_to = [&](MatrixEntries &entries) {
          for (Eigen::Index i = 0; i < masses.size(); ++i)
            entries.add(i, i, masses(i));
          equations.add_constraint_jacobian(q, masses.size(), entries);
        };
        if (size <= largest_dense_system)
          {
            Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
            DenseEntries    entries(matrix);
            add_to(entries);
            return matrix.partialPivLu().solve(right_hand_side);
          }
        Triplets entries;
        add_to(entries);
        const Eigen::SparseLU<Eigen::SparseMatrix<double>> decomposition(
          entries.matrix(size));
        return decomposition.solve(right_hand_side);
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



    Eigen::VectorXd
    compute_initial_velocities(const EquationsOfMotion &equations,
                               const double             t,
                               const Eigen::VectorXd   &q)
    {
      const Mechanism   &mechanism = equations.mechanism();
      const unsigned int m         = mechanism.n_constraints();
      Eigen::VectorXd    phi_t(m), phi_tt(m);
      equations.assemble_time_derivatives(t, phi_t, phi_tt);
      Eigen::MatrixXd phi_q(m, mechanism.n_coordinates());
      equations.assemble_constraint_jacobian(q, phi_q);
      const Eigen::VectorXd &v = mechanism.initial_velocities();
      return v + solve_least_norm(equations, q, -phi_t - phi_q * v);
    }



    Eigen::VectorXd
    compute_kinematic_accelerations(const EquationsOfMotion &equations,
                                    const double             t,
                                    const Eigen::VectorXd   &q,
                                    const Eigen::VectorXd   &v)
    {
      const unsigned int m = equations.mechanism().n_constraints();
      Eigen::VectorXd    phi_t(m), phi_tt(m), quadratic(m);
      equations.assemble_time_derivatives(t, phi_t, phi_tt);
      equations.assemble_quadratic_terms(q, v, quadratic);
      return solve_least_norm(equations, q, -quadratic - phi_tt);
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

      Eigen::VectorXd phi_t(m), phi_tt(m), quadratic(m), right_hand_side(n + m);
      equations.assemble_time_derivatives(t, phi_t, phi_tt);
      equations.assemble_quadratic_terms(q, v, quadratic);
      right_hand_side << forces, offsets.second_derivative - quadratic - phi_tt;

      const Eigen::VectorXd x =
        solve_saddle_point(equations, q, right_hand_side);
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
      if (!report.converged)
        {
          const OpenConstraint worst =
            find_open_constraint(equations, t, q_guess);
          throw ExcRun("At time " + significant_digits(t, 6) +
                       " s the mechanism has no position near the one "
                       "before: " +
                       worst.description + " " + worst.problem);
        }
      motion.v = compute_velocities(equations, t, offsets, motion.q);
      Eigen::VectorXd forces(motion.q.size());
      equations.assemble_forces(t, motion.q, motion.v, {}, forces);
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
      q = find_smallest_gaps(equations, t, mechanism.initial_coordinates());
      if (solve_positions(equations, t, none, q).converged)
        return q;

      const OpenConstraint worst =
        find_open_constraint(equations, t, mechanism.initial_coordinates());
      std::string hint;
      if (!mechanism.drivers().empty())
        hint = ", and can the driven bodies be where the drivers want them (" +
               driver_positions(mechanism, t) + ")";
      throw ExcParameter(worst.description,
                         worst.problem +
                           ". Are the markers right, are the bodies' "
                           "initial positions and angles near a configuration "
                           "that exists" +
                           hint + "?");
    }



    void
    check_full_cycle(const EquationsOfMotion &equations,
                     const double             period,
                     const unsigned int       n_steps)
    {
      const Mechanism        &mechanism = equations.mechanism();
      const ConstraintOffsets none(mechanism.n_constraints());
      const double            step = period / n_steps;
      Eigen::VectorXd         q    = assemble_configuration(equations, 0.);
      for (unsigned int k = 1; k <= n_steps; ++k)
        {
          const Eigen::VectorXd before = q;
          if (!solve_positions(equations, k * step, none, q).converged)
            {
              const OpenConstraint worst =
                find_open_constraint(equations, k * step, before);
              throw ExcParameter(
                "Drivers",
                "must be able to go through a full cycle with ideal joints, "
                "but the mechanism locks between " +
                  driver_positions(mechanism, (k - 1) * step) + " and " +
                  driver_positions(mechanism, k * step) + ", where " +
                  worst.description + " " + worst.problem +
                  ". Are the links' lengths right?");
            }
          const DependentConstraints dependent =
            find_dependent_constraints(equations, q, singular_threshold);
          AssertThrow(
            dependent.surplus == 0,
            ExcParameter("Drivers",
                         "lead through a singular position, with " +
                           driver_positions(mechanism, k * step) +
                           ": the constraints of " + dependent.names +
                           " depend on each other there, so that reactions "
                           "and the way on are not determined"));
        }
    }



    void
    check_redundancy(const EquationsOfMotion &equations,
                     const Eigen::VectorXd   &q)
    {
      const DependentConstraints dependent =
        find_dependent_constraints(equations, q, singular_threshold);
      AssertThrow(
        dependent.surplus == 0,
        ExcParameter("Joints",
                     std::to_string(dependent.surplus) +
                       " constraint(s) follow from the others or contradict "
                       "them in the initial configuration. Those that depend "
                       "on each other belong to: " +
                       dependent.names +
                       ". Remove one of them; or if the mechanism is only just "
                       "passing a singular position, start from another one"));
    }



    void
    check_masses(const EquationsOfMotion &equations, const Eigen::VectorXd &q)
    {
      const Mechanism   &mechanism = equations.mechanism();
      const unsigned int n         = mechanism.n_coordinates();
      Eigen::VectorXd    masses    = mechanism.masses();
      if (masses.minCoeff() > 0)
        return;
      for (unsigned int i = 2; i < n; i += 3)
        masses(i) /= mechanism.size() * mechanism.size();

      // Directions that the constraints leave free.
      Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(
        scaled_jacobian(equations, q).transpose());
      decomposition.setThreshold(1e-9);
      const Eigen::MatrixXd basis = decomposition.householderQ();
      const Eigen::MatrixXd free  = basis.rightCols(n - decomposition.rank());
      if (free.cols() == 0)
        return;
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
        free.transpose() * masses.asDiagonal() * free);
      // Rounding leaves 1e-16 of the largest mass.
      if (eigen.eigenvalues()(0) > 1e-13 * masses.maxCoeff())
        return;
      const Eigen::VectorXd motion = free * eigen.eigenvectors().col(0);
      Eigen::Index          worst;
      motion.cwiseAbs().maxCoeff(&worst);
      throw ExcParameter(
        "Body " + mechanism.parameters().bodies[worst / 3].name +
          (worst % 3 == 2 ? "/Moment of inertia" : "/Mass"),
        "is zero, and the joints do not tie this motion of the body to one "
        "with mass: its acceleration is not determined. Give the body a mass "
        "and a moment of inertia");
    }



    std::string
    explain_end_of_motion(const EquationsOfMotion &equations,
                          const double             t,
                          const double             t_next,
                          const Eigen::VectorXd   &q)
    {
      const Mechanism        &mechanism = equations.mechanism();
      const ConstraintOffsets none(mechanism.n_constraints());
      Eigen::VectorXd         q_next = q;
      if (!solve_positions(equations, t_next, none, q_next).converged)
        {
          const OpenConstraint worst =
            find_open_constraint(equations, t_next, q);
          return " shortly after the time " + significant_digits(t, 6) +
                 " s there is no position any more: " + worst.description +
                 " " + worst.problem;
        }
      // Looser than for redundancy: the motion ends near the singular position.
      const DependentConstraints dependent =
        find_dependent_constraints(equations, q_next, 1e-3);
      if (dependent.surplus > 0)
        return " near the time " + significant_digits(t, 6) +
               " s the mechanism is close to a singular position, in which the "
               "constraints of " +
               dependent.names + " depend on each other";
      return "";
    }
  } // namespace Multibody
} // namespace Tribody

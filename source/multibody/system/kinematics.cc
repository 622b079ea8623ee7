// SPDX-License-Identifier: LGPL-2.1-or-later

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SparseLU>

#include <tribody/algebra/sparse_rows.h>
#include <tribody/base/exceptions.h>
#include <tribody/base/interruption.h>
#include <tribody/base/significant_digits.h>
#include <tribody/base/solver_report.h>
#include <tribody/multibody/system/constraint_gaps.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/given_start.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>
#include <tribody/multibody/system/mechanism_state.h>
#include <tribody/multibody/system/sparse_jacobian.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // The same as solve_least_norm() for large mechanisms whose constraints
      // are independent; returns whether this is one.
      bool
      solve_least_norm_sparsely(const EquationsOfMotion &equations,
                                const Eigen::VectorXd   &q,
                                const Eigen::VectorXd   &right_hand_side,
                                Eigen::VectorXd         &x)
      {
        if (right_hand_side.size() <= largest_dense_jacobian)
          return false;
        Eigen::VectorXd scales = Eigen::VectorXd::Ones(q.size());
        for (Eigen::Index i = 2; i < q.size(); i += 3)
          scales(i) = 1. / equations.mechanism().size();
        const Eigen::SparseMatrix<double> scaled =
          compute_sparse_jacobian(equations, q) * scales.asDiagonal();
        if (!solve_least_norm(scaled, right_hand_side, x))
          return false;
        x = scales.cwiseProduct(x);
        return true;
      }



      // Metres per unit of each coordinate.
      Eigen::VectorXd
      compute_coordinate_scales(const Mechanism &mechanism)
      {
        Eigen::VectorXd scales =
          Eigen::VectorXd::Ones(mechanism.n_coordinates());
        for (unsigned int i = 2; i < mechanism.n_coordinates(); i += 3)
          scales(i) = mechanism.size();
        return scales;
      }



      // The shortest x with A x = b, or the best one.
      Eigen::VectorXd
      solve_least_norm(const Eigen::MatrixXd &a,
                       const Eigen::VectorXd &b,
                       const double           threshold = 1e-10)
      {
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
        solver.setThreshold(threshold);
        solver.compute(a);
        return solver.solve(b);
      }



      // The shortest x with Phi_q x = right_hand_side, or the best one, where a
      // coordinate of small mobility counts as far as it moves all the same.
      Eigen::VectorXd
      solve_least_norm(const EquationsOfMotion &equations,
                       const Eigen::VectorXd   &q,
                       const Eigen::VectorXd   &right_hand_side,
                       const Eigen::VectorXd   &mobility = {})
      {
        const Mechanism &mechanism = equations.mechanism();
        if (mechanism.n_constraints() == 0)
          return Eigen::VectorXd::Zero(mechanism.n_coordinates());
        Eigen::VectorXd x;
        if (mobility.size() == 0 &&
            solve_least_norm_sparsely(equations, q, right_hand_side, x))
          return x;
        Eigen::MatrixXd jacobian = compute_scaled_jacobian(equations, q);
        if (mobility.size() > 0)
          jacobian *= mobility.asDiagonal();
        x = solve_least_norm(jacobian,
                             compute_constraint_scales(mechanism).cwiseProduct(
                               right_hand_side));
        if (mobility.size() > 0)
          x = mobility.cwiseProduct(x);
        return x.cwiseQuotient(compute_coordinate_scales(mechanism));
      }



      // What rounding of the coordinates leaves of Phi, in lengths.
      double
      compute_rounding(const Mechanism &mechanism, const Eigen::VectorXd &q)
      {
        const double largest =
          std::max(mechanism.size(),
                   q.cwiseProduct(compute_coordinate_scales(mechanism))
                     .lpNorm<Eigen::Infinity>());
        return 100. * std::numeric_limits<double>::epsilon() * largest;
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



      // Each multiplied by the scales of its row and its column.
      class ScaledEntries : public MatrixEntries
      {
      public:
        ScaledEntries(MatrixEntries &entries, const Eigen::VectorXd &scales)
          : entries(entries)
          , scales(scales)
        {}

        void
        add(const Eigen::Index row,
            const Eigen::Index column,
            const double       value) override
        {
          entries.add(row, column, scales(row) * scales(column) * value);
        }

      private:
        MatrixEntries         &entries;
        const Eigen::VectorXd &scales;
      };



      // Scales that make masses and constraints of a mechanism of any size
      // numbers near one.
      Eigen::VectorXd
      compute_saddle_point_scales(const Mechanism &mechanism)
      {
        const Eigen::VectorXd lengths = compute_coordinate_scales(mechanism);
        const double          mass =
          mechanism.masses().cwiseQuotient(lengths.cwiseAbs2()).maxCoeff();
        const double    root = mass > 0. ? std::sqrt(mass) : 1.;
        Eigen::VectorXd scales(mechanism.n_coordinates() +
                               mechanism.n_constraints());
        scales << (root * lengths).cwiseInverse(),
          root * compute_constraint_scales(mechanism);
        return scales;
      }



      // x in (M, Phi_q^T; Phi_q, 0) x = right_hand_side. Multipliers that are
      // not unique, of redundant constraints, are those of least norm.
      Eigen::VectorXd
      solve_saddle_point(const EquationsOfMotion &equations,
                         const Eigen::VectorXd   &q,
                         const Eigen::VectorXd   &right_hand_side)
      {
        const Mechanism       &mechanism = equations.mechanism();
        const Eigen::Index     size      = right_hand_side.size();
        const Eigen::VectorXd &masses    = mechanism.masses();
        const Eigen::VectorXd  scales = compute_saddle_point_scales(mechanism);
        const auto             add_to = [&](MatrixEntries &entries) {
          ScaledEntries scaled(entries, scales);
          for (Eigen::Index i = 0; i < masses.size(); ++i)
            scaled.add(i, i, masses(i));
          equations.add_constraint_jacobian(q, masses.size(), scaled);
        };
        const Eigen::VectorXd right = scales.cwiseProduct(right_hand_side);
        const bool            is_singular = mechanism.n_redundant() > 0;
        if (size <= largest_dense_system || is_singular)
          {
            Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
            DenseEntries    entries(matrix);
            add_to(entries);
            if (is_singular)
              // Light bodies are no redundancy.
              return scales.cwiseProduct(
                solve_least_norm(matrix, right, 1e-14));
            return scales.cwiseProduct(matrix.partialPivLu().solve(right));
          }
        Triplets entries;
        add_to(entries);
        const Eigen::SparseLU<Eigen::SparseMatrix<double>> decomposition(
          entries.matrix(size));
        return scales.cwiseProduct(decomposition.solve(right));
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
                    Eigen::VectorXd         &q,
                    const Eigen::VectorXd   &mobility)
    {
      // Every search for a position goes through here.
      stop_if_interrupted();
      const Mechanism &mechanism = equations.mechanism();
      SolverReport     report;
      Eigen::VectorXd  phi(mechanism.n_constraints());
      report.converged              = phi.size() == 0;
      const double          size    = mechanism.size();
      const Eigen::VectorXd scales  = compute_constraint_scales(mechanism);
      const Eigen::VectorXd lengths = compute_coordinate_scales(mechanism);
      // Ends where a further step no longer improves on rounding.
      double before = std::numeric_limits<double>::max();
      for (; phi.size() > 0 && report.n_iterations < 100; ++report.n_iterations)
        {
          equations.assemble_constraints(t, q, phi);
          phi -= offsets.value;
          const double gap = phi.cwiseProduct(scales).lpNorm<Eigen::Infinity>();
          report.residual  = gap / size;
          report.converged =
            gap < std::max(1e-12 * size, compute_rounding(mechanism, q));
          if (report.residual < 1e-15 || (report.converged && gap > before / 2))
            break;
          before               = gap;
          Eigen::VectorXd step = -solve_least_norm(equations, q, phi, mobility);
          const double    length = step.cwiseProduct(lengths).norm();
          // Far from a solution a full step may turn a body over.
          if (length > size)
            step *= size / length;
          q += step;
        }
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
    compute_nearest_velocities(const EquationsOfMotion &equations,
                               const double             t,
                               const Eigen::VectorXd   &q,
                               const Eigen::VectorXd   &v)
    {
      const Mechanism   &mechanism = equations.mechanism();
      const unsigned int m         = mechanism.n_constraints();
      Eigen::VectorXd    phi_t(m), phi_tt(m);
      equations.assemble_time_derivatives(t, phi_t, phi_tt);
      const Eigen::SparseMatrix<double> phi_q =
        compute_sparse_jacobian(equations, q);
      return v + solve_least_norm(equations, q, -phi_t - phi_q * v);
    }



    Eigen::VectorXd
    compute_initial_velocities(const EquationsOfMotion &equations,
                               const double             t,
                               const Eigen::VectorXd   &q)
    {
      return compute_nearest_velocities(
        equations, t, q, equations.mechanism().initial_velocities());
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



    Accelerations
    compute_accelerations(const EquationsOfMotion &equations,
                          const MechanismState    &state)
    {
      Eigen::VectorXd forces(state.q.size());
      equations.assemble_forces(state.time,
                                state.q,
                                state.v,
                                state.approach_speeds,
                                state.friction_states,
                                forces);
      return compute_accelerations(equations,
                                   state.time,
                                   ConstraintOffsets(
                                     equations.mechanism().n_constraints()),
                                   state.q,
                                   state.v,
                                   forces);
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
      if (equations.mechanism().n_degrees_of_freedom() <= 0)
        motion.v = compute_velocities(equations, t, offsets, motion.q);
      else
        // The offsets' own, and the rest as it is wished for.
        motion.v =
          compute_initial_velocities(equations, t, motion.q) +
          solve_least_norm(equations, motion.q, offsets.first_derivative);
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
      Eigen::VectorXd         given = mechanism.initial_coordinates();
      turn_to_drivers(mechanism, t, given);
      Eigen::VectorXd    q      = given;
      const SolverReport report = solve_positions(equations, t, none, q);
      if (report.converged)
        return hold_given_coordinates(equations, t, given, q);
      q = find_smallest_gaps(equations, t, given);
      if (solve_positions(equations, t, none, q).converged)
        return hold_given_coordinates(equations, t, given, q);

      const OpenConstraint worst = find_open_constraint(equations, t, given);
      std::string          hint;
      if (!mechanism.drivers().empty())
        hint = ", and can the driven bodies be where the drivers want them (" +
               describe_drivers(mechanism, t) + ")";
      throw ExcParameter(worst.description,
                         worst.problem +
                           ". Are the markers right, are the bodies' "
                           "initial positions and angles near a configuration "
                           "that exists" +
                           hint + "?");
    }
  } // namespace Multibody
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SparseLU>

#include <tribody/base/exceptions.h>
#include <tribody/base/significant_digits.h>
#include <tribody/base/solver_report.h>
#include <tribody/multibody/system/constraint_gaps.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>
#include <tribody/multibody/system/mechanism_state.h>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
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
        solver.compute(compute_scaled_jacobian(equations, q));
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
    compute_nearest_velocities(const EquationsOfMotion &equations,
                               const double             t,
                               const Eigen::VectorXd   &q,
                               const Eigen::VectorXd   &v)
    {
      const Mechanism   &mechanism = equations.mechanism();
      const unsigned int m         = mechanism.n_constraints();
      Eigen::VectorXd    phi_t(m), phi_tt(m);
      equations.assemble_time_derivatives(t, phi_t, phi_tt);
      Eigen::MatrixXd phi_q(m, mechanism.n_coordinates());
      equations.assemble_constraint_jacobian(q, phi_q);
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

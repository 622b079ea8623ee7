// SPDX-License-Identifier: LGPL-2.1-or-later

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include <tribody/base/exceptions.h>
#include <tribody/base/significant_digits.h>
#include <tribody/base/solver_report.h>
#include <tribody/multibody/system/assembly_checks.h>
#include <tribody/multibody/system/constraint_gaps.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>
#include <tribody/multibody/system/redundancy.h>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
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
        Eigen::MatrixXd jacobian = compute_scaled_jacobian(equations, q);
        // A row of zeros, of markers that coincide, stays one.
        for (unsigned int i = 0; i < m; ++i)
          jacobian.row(i).normalize();
        Eigen::FullPivLU<Eigen::MatrixXd> decomposition(jacobian.transpose());
        decomposition.setThreshold(threshold);
        if (decomposition.rank() + mechanism.n_left_out() == m)
          return {};

        // Every combination of rows that vanishes shows up in the null space of
        // the transpose; the joints with entries there depend on each other.
        // The shortest combination says most.
        const Eigen::MatrixXd kernel = decomposition.kernel();
        DependentConstraints  result;
        std::size_t           n_named = mechanism.constraints().size() + 1;
        result.surplus = m - mechanism.n_left_out() - decomposition.rank();
        for (Eigen::Index k = 0; k < kernel.cols(); ++k)
          {
            const double limit = 1e-6 * kernel.col(k).lpNorm<Eigen::Infinity>();
            std::string  names;
            std::size_t  n      = 0;
            bool         is_new = false;
            for (const auto &[constraint, row] : mechanism.constraints())
              {
                const auto part =
                  kernel.col(k).segment(row, constraint->n_equations);
                if (part.lpNorm<Eigen::Infinity>() <= limit)
                  continue;
                names += (names.empty() ? "" : ", ") + constraint->description;
                ++n;
                for (unsigned int i = 0; i < constraint->n_equations; ++i)
                  is_new = is_new || (std::abs(part(i)) > limit &&
                                      !constraint->is_left_out(i));
              }
            if (is_new && n < n_named)
              {
                n_named      = n;
                result.names = names;
              }
          }
        return result;
      }
    } // namespace



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
                  describe_drivers(mechanism, (k - 1) * step) + " and " +
                  describe_drivers(mechanism, k * step) + ", where " +
                  worst.description + " " + worst.problem +
                  ". Are the links' lengths right?");
            }
          const DependentConstraints dependent =
            find_dependent_constraints(equations, q, singular_threshold);
          AssertThrow(
            dependent.surplus == 0,
            ExcParameter("Drivers",
                         "lead through a singular position, with " +
                           describe_drivers(mechanism, k * step) +
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
        compute_scaled_jacobian(equations, q).transpose());
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

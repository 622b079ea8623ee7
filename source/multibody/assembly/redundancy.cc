// SPDX-License-Identifier: LGPL-2.1-or-later

#include <Eigen/LU>
#include <Eigen/QR>

#include <tribody/algebra/sparse_rows.h>
#include <tribody/base/solver_report.h>
#include <tribody/multibody/assembly/redundancy.h>
#include <tribody/multibody/system/constraint_gaps.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>
#include <tribody/multibody/system/sparse_jacobian.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // Without a dense matrix. False may be wrong.
      bool
      are_independent(const EquationsOfMotion &equations,
                      const Eigen::VectorXd   &q,
                      const double             threshold)
      {
        const Mechanism &mechanism = equations.mechanism();
        if (mechanism.n_constraints() <= largest_dense_jacobian)
          return false;
        Eigen::VectorXd columns = Eigen::VectorXd::Ones(q.size());
        for (Eigen::Index i = 2; i < q.size(); i += 3)
          columns(i) = 1. / mechanism.size();
        const Eigen::SparseMatrix<double> jacobian =
          compute_sparse_jacobian(equations, q) * columns.asDiagonal();
        const Eigen::VectorXd lengths =
          (jacobian.cwiseProduct(jacobian) * Eigen::VectorXd::Ones(q.size()))
            .cwiseSqrt();
        if (lengths.minCoeff() == 0.)
          return false;
        return rows_are_independent(lengths.cwiseInverse().asDiagonal() *
                                      jacobian,
                                    threshold);
      }



      // A configuration beside q that the constraints allow, as far as the
      // length away. Any direction will do that is no special one.
      bool
      move_aside(const EquationsOfMotion &equations,
                 const double             length,
                 Eigen::VectorXd         &q)
      {
        const Mechanism &mechanism = equations.mechanism();
        Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(
          compute_scaled_jacobian(equations, q).transpose());
        decomposition.setThreshold(singular_threshold);
        const Eigen::MatrixXd basis = decomposition.householderQ();
        const Eigen::MatrixXd free =
          basis.rightCols(q.size() - decomposition.rank());
        if (free.cols() == 0)
          return true;
        Eigen::VectorXd mixed(free.cols());
        for (Eigen::Index i = 0; i < mixed.size(); ++i)
          mixed(i) = std::cos(1. + 2.3 * i);
        Eigen::VectorXd step = length / mixed.norm() * (free * mixed);
        for (Eigen::Index i = 2; i < step.size(); i += 3)
          step(i) /= mechanism.size();
        q += step;
        return solve_positions(equations,
                               0.,
                               ConstraintOffsets(mechanism.n_constraints()),
                               q)
          .converged;
      }



      // At q and beside it, whichever are less.
      unsigned int
      count_lasting(const EquationsOfMotion &equations,
                    const Eigen::VectorXd   &q)
      {
        const double       size = equations.mechanism().size();
        const unsigned int here = find_dependent_constraints(equations, q).n;
        for (double length = 0.1 * size; length > 1e-3 * size; length /= 4)
          {
            Eigen::VectorXd aside = q;
            if (move_aside(equations, length, aside))
              return std::min(here,
                              find_dependent_constraints(equations, aside).n);
          }
        return 0;
      }
    } // namespace



    DependentConstraints
    find_dependent_constraints(const EquationsOfMotion &equations,
                               const Eigen::VectorXd   &q,
                               const double             threshold)
    {
      const Mechanism     &mechanism = equations.mechanism();
      const unsigned int   m         = mechanism.n_constraints();
      DependentConstraints result;
      if (m == 0 || are_independent(equations, q, threshold))
        return result;
      Eigen::MatrixXd jacobian = compute_scaled_jacobian(equations, q);
      // A row of zeros, of markers that coincide, stays one.
      for (unsigned int i = 0; i < m; ++i)
        jacobian.row(i).normalize();
      Eigen::FullPivLU<Eigen::MatrixXd> decomposition(jacobian.transpose());
      decomposition.setThreshold(threshold);
      result.n = m - decomposition.rank();
      if (result.n == 0)
        return result;

      // Every combination of rows that vanishes shows up in the null space of
      // the transpose; the joints with entries there depend on each other. The
      // shortest combination says most.
      const Eigen::MatrixXd kernel  = decomposition.kernel();
      std::size_t           n_named = mechanism.constraints().size() + 1;
      for (Eigen::Index k = 0; k < kernel.cols(); ++k)
        {
          const double limit = 1e-6 * kernel.col(k).lpNorm<Eigen::Infinity>();
          std::string  names;
          std::size_t  n = 0;
          for (const auto &[constraint, row] : mechanism.constraints())
            if (kernel.col(k)
                  .segment(row, constraint->n_equations)
                  .lpNorm<Eigen::Infinity>() > limit)
              {
                names += (names.empty() ? "" : ", ") + constraint->description;
                ++n;
              }
          if (n < n_named)
            {
              n_named      = n;
              result.names = names;
            }
        }
      return result;
    }



    MechanismParameters
    count_redundant_constraints(const MechanismParameters &parameters)
    {
      MechanismParameters result = parameters;
      result.n_redundant         = 0;
      const Mechanism         mechanism(result);
      const EquationsOfMotion equations(mechanism,
                                        nominal_clearances(mechanism));
      const Mechanism         closed(with_ideal_joints(result));
      const Eigen::VectorXd   q =
        assemble_configuration(EquationsOfMotion(closed, {}), 0.);
      if (find_dependent_constraints(equations, q).n == 0)
        return result;
      MechanismParameters joints_only = result;
      joints_only.drivers.clear();
      const Mechanism         moving(joints_only);
      const EquationsOfMotion equations_of_joints(moving,
                                                  nominal_clearances(moving));
      result.n_redundant = count_lasting(equations_of_joints, q);
      return result;
    }



    std::string
    describe_redundancy(const EquationsOfMotion &equations,
                        const Eigen::VectorXd   &q)
    {
      const unsigned int n = equations.mechanism().n_redundant();
      if (n == 0)
        return "";
      return "has " + std::to_string(n) +
             (n == 1 ? " constraint that follows"
                     : " constraints that follow") +
             " from others, among them those of " +
             find_dependent_constraints(equations, q).names +
             ": the motion is the same without, but how joints share such a "
             "force is not determined; the smallest forces are given";
    }
  } // namespace Multibody
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_system_sparse_jacobian_h
#define tribody_multibody_system_sparse_jacobian_h

#include <Eigen/SparseCore>

namespace Tribody
{
  namespace Multibody
  {
    class EquationsOfMotion;

    /// Mechanisms of more constraints than this are set up with sparse
    /// matrices: the cost of dense ones grows with the third power.
    constexpr Eigen::Index largest_dense_jacobian = 64;

    /// Phi_q at @p q.
    Eigen::SparseMatrix<double>
    compute_sparse_jacobian(const EquationsOfMotion &equations,
                            const Eigen::VectorXd   &q);

    /**
     * Whether no row of @p matrix, whose rows have length one, comes closer
     * than
     * @p threshold to a combination of others. False may be wrong, if
     * a dense decomposition with complete pivoting would find better pivots.
     */
    bool
    rows_are_independent(const Eigen::SparseMatrix<double> &matrix,
                         const double                       threshold);

    /**
     * The shortest x with @p matrix x = @p right_hand_side, in linear time for
     * chains and trees, from (1, A^T; A, 0).
     * @return whether there is one; not if rows of the matrix depend on each
     *   other.
     */
    bool
    solve_least_norm(const Eigen::SparseMatrix<double> &matrix,
                     const Eigen::VectorXd             &right_hand_side,
                     Eigen::VectorXd                   &x);
  } // namespace Multibody
} // namespace Tribody

#endif

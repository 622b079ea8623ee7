// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_algebra_sparse_rows_h
#define tribody_algebra_sparse_rows_h

#include <Eigen/SparseCore>

namespace Tribody
{
  /**
   * Whether no row of @p matrix, whose rows have length one, comes closer than
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
} // namespace Tribody

#endif

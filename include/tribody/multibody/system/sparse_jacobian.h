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
  } // namespace Multibody
} // namespace Tribody

#endif

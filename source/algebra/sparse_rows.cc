// SPDX-License-Identifier: LGPL-2.1-or-later

#include <Eigen/OrderingMethods>
#include <Eigen/SparseLU>
#include <Eigen/SparseQR>

#include <tribody/algebra/sparse_rows.h>

#include <vector>

namespace Tribody
{
  bool
  rows_are_independent(const Eigen::SparseMatrix<double> &matrix,
                       const double                       threshold)
  {
    if (matrix.rows() > matrix.cols())
      return false;
    Eigen::SparseMatrix<double> columns = matrix.transpose();
    columns.makeCompressed();
    Eigen::SparseQR<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>>
      decomposition;
    decomposition.setPivotThreshold(threshold);
    decomposition.compute(columns);
    return decomposition.info() == Eigen::Success &&
           decomposition.rank() == matrix.rows();
  }



  bool
  solve_least_norm(const Eigen::SparseMatrix<double> &matrix,
                   const Eigen::VectorXd             &right_hand_side,
                   Eigen::VectorXd                   &x)
  {
    // What rounding may leave of the equations, relative to their terms.
    constexpr double accuracy = 1e-10;

    const Eigen::Index                  n = matrix.cols(), m = matrix.rows();
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < n; ++i)
      entries.emplace_back(i, i, 1.);
    for (Eigen::Index j = 0; j < n; ++j)
      for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, j); it; ++it)
        {
          entries.emplace_back(n + it.row(), j, it.value());
          entries.emplace_back(j, n + it.row(), it.value());
        }
    Eigen::SparseMatrix<double> system(n + m, n + m);
    system.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseLU<Eigen::SparseMatrix<double>> decomposition(system);
    if (decomposition.info() != Eigen::Success)
      return false;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n + m);
    right.tail(m)         = right_hand_side;
    x                     = Eigen::VectorXd(decomposition.solve(right)).head(n);
    // Rows that are dependent but for rounding ask for large multiples.
    return x.allFinite() &&
           (matrix * x - right_hand_side).lpNorm<Eigen::Infinity>() <=
             accuracy * right_hand_side.lpNorm<Eigen::Infinity>() &&
           accuracy * x.lpNorm<Eigen::Infinity>() <=
             right_hand_side.lpNorm<Eigen::Infinity>();
  }
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

// Sparse sets of rows, as of the constraints of a large mechanism. Known: the
// shortest solution and whether rows are independent from Eigen's dense
// decompositions; a row that is the sum of two others, one of zeros, and more
// rows than columns are dependent; rows that are only almost so are not, down
// to the threshold.

#include <Eigen/QR>

#include <tribody/algebra/sparse_rows.h>

#include <cmath>
#include <fstream>
#include <string>

using namespace Tribody;

// A chain: each pair of rows ties three numbers to the next three.
Eigen::MatrixXd
chain(const Eigen::Index n_links)
{
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(2 * n_links, 3 * n_links);
  for (Eigen::Index i = 0; i < n_links; ++i)
    {
      A.block<2, 2>(2 * i, 3 * i).setIdentity();
      A(2 * i, 3 * i + 2)     = std::sin(i);
      A(2 * i + 1, 3 * i + 2) = std::cos(i);
      if (i == 0)
        continue;
      A.block<2, 2>(2 * i, 3 * i - 3) = -Eigen::Matrix2d::Identity();
      A(2 * i, 3 * i - 1)             = std::cos(3. * i);
      A(2 * i + 1, 3 * i - 1)         = std::sin(2. * i);
    }
  A.rowwise().normalize();
  return A;
}

void
judge(const std::string &name, const Eigen::MatrixXd &A, std::ostream &output)
{
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(A.rows(), -1., 2.);
  const Eigen::SparseMatrix<double> sparse = A.sparseView();
  output << name << ": rows "
         << (rows_are_independent(sparse, 1e-5) ? "independent" : "dependent");
  Eigen::VectorXd x;
  if (solve_least_norm(sparse, b, x))
    {
      const Eigen::VectorXd y = A.completeOrthogonalDecomposition().solve(b);
      output << ", shortest solution "
             << ((x - y).norm() < 1e-6 * y.norm() ? "agrees" : "is wrong");
    }
  else
    output << ", no solution";
  output << std::endl;
}

int
main()
{
  std::ofstream   output("output");
  const auto      A = chain(100);
  Eigen::MatrixXd B(A.rows() + 1, A.cols());
  judge("chain", A, output);
  B << A, (A.row(17) + A.row(150)).normalized();
  judge("sum of two", B, output);
  B.bottomRows(1).setZero();
  judge("zeros", B, output);
  B.bottomRows(1) = A.row(17);
  B(200, 200) += 1e-3;
  B.bottomRows(1).normalize();
  judge("almost a copy", B, output);
  B.bottomRows(1) = A.row(17);
  B(200, 200) += 1e-7;
  judge("a copy up to the threshold", B, output);
  judge("more rows than columns", A.transpose(), output);
}

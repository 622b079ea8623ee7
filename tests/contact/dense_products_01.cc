// SPDX-License-Identifier: LGPL-2.1-or-later

// Products for following the active set. Known:
// - They equal Eigen's in all shapes: few columns or few terms, more rows
//   than a strip or fewer, blocks of a larger matrix. Sums of up to 100 terms
//   of size one in another order agree to 100 roundings.
// - What is around the block of the result is left alone.
// - C_A^-1 is found whether it was factorised or followed from other nodes,
//   some of which leave, or others enter, or both, to
//   the rounding times the condition of 1e3.

#include <tribody/algebra/dense_products.h>
#include <tribody/contact/active_compliance.h>

#include <algorithm>
#include <iostream>
#include <random>
#include <utility>
#include <vector>

using namespace Tribody;
using namespace Tribody::Contact;

Eigen::MatrixXd
random_matrix(const Eigen::Index n_rows, const Eigen::Index n_columns)
{
  static std::mt19937                    generator(1);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  return Eigen::MatrixXd::NullaryExpr(n_rows, n_columns, [&]() {
    return uniform(generator);
  });
}

void
test_products()
{
  double largest = 0., outside = 0.;
  for (const Eigen::Index m : {1, 3, 7, 8, 31, 32, 33, 50, 100})
    for (const Eigen::Index n : {1, 2, 3, 4, 5, 7, 40})
      for (const Eigen::Index k : {1, 2, 3, 4, 6, 8, 9, 33, 100})
        {
          const Eigen::MatrixXd a      = random_matrix(m + 5, k);
          const Eigen::MatrixXd b      = random_matrix(k + 1, n);
          const Eigen::MatrixXd before = random_matrix(m + 4, n + 2);
          Eigen::MatrixXd       after  = before;
          DenseProducts::add_product(a.middleRows(2, m),
                                     b.topRows(k),
                                     after.block(1, 1, m, n));
          Eigen::MatrixXd change = after - before;
          change.block(1, 1, m, n) -= a.middleRows(2, m) * b.topRows(k);
          largest =
            std::max(largest,
                     change.block(1, 1, m, n).lpNorm<Eigen::Infinity>());
          change.block(1, 1, m, n).setZero();
          outside = std::max(outside, change.lpNorm<Eigen::Infinity>());
        }
  std::cout << "products: error below 1e-13: " << (largest < 1e-13)
            << ", rows and columns around left alone: " << (outside == 0.)
            << '\n';
}

void
test_inverse()
{
  const Eigen::Index    n = 60;
  const Eigen::MatrixXd B = random_matrix(n, n);
  const Eigen::MatrixXd C =
    B * B.transpose() / n + 0.01 * Eigen::MatrixXd::Identity(n, n);
  ActiveCompliance active(C, ActiveCompliance::Use::inverse);
  double           largest = 0.;
  const std::vector<std::pair<Eigen::Index, Eigen::Index>> ranges{
    {0, 35}, {3, 38}, {3, 41}, {5, 41}, {4, 39}, {1, 36}, {20, 55}};
  for (const auto &[begin, end] : ranges)
    {
      ActiveSet nodes;
      for (Eigen::Index i = begin; i < end; ++i)
        nodes.push_back(i);
      active.update(nodes, /*small changes = */ true);
      const Eigen::MatrixXd error =
        active.compute_inverse() * C(nodes, nodes) -
        Eigen::MatrixXd::Identity(end - begin, end - begin);
      largest = std::max(largest, error.lpNorm<Eigen::Infinity>());
    }
  std::cout << "inverse: error below 1e-11: " << (largest < 1e-11) << '\n';
}

int
main()
{
  test_products();
  test_inverse();
}

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_algebra_dense_products_h
#define tribody_algebra_dense_products_h

#include <Eigen/Core>

namespace Tribody
{
  namespace DenseProducts
  {
    /// A matrix, or a block of one, whose columns are stored one after the
    /// other.
    using ConstBlock =
      Eigen::Ref<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
    using Block = Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

    /**
     * @p sum += @p a times @p b, of which @p b has few columns or few rows.
     *
     * This is what following the active set spends its time with. Eigen would
     * do it with the instructions that the whole program is compiled for
     * (SSE2), column by column or after copying the matrix. This is compiled
     * for processors with AVX2 as well, and chosen when the program is loaded.
     * The order of the sums does not depend on where the matrices lie in
     * memory.
     */
    void
    add_product(const ConstBlock &a, const ConstBlock &b, Block sum);

    /// @p a times @p b in the same way.
    Eigen::MatrixXd
    multiply(const ConstBlock &a, const ConstBlock &b);
  } // namespace DenseProducts
} // namespace Tribody

#endif

#ifndef tribody_contact_dense_products_h
#define tribody_contact_dense_products_h

#include <Eigen/Core>

namespace Tribody
{
  namespace Contact
  {
    /// A matrix, or a block of one, whose columns are stored one after the
    /// other.
    using ConstBlock =
      Eigen::Ref<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
    using Block = Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

    /**
     * @p sum += @p matrix times @p few, which has few columns: reads the matrix
     * once for four of them.
     *
     * This and add_outer_product() are what following the active set spends its
     * time with. Eigen would do them with the instructions that the whole
     * program is compiled for (SSE2), column by column or after copying the
     * matrix. These are compiled for processors with AVX2 as well, and chosen
     * when the program is loaded. The order of the sums does not depend on
     * where the matrix lies in memory.
     */
    void
    add_product(const ConstBlock &matrix, const ConstBlock &few, Block sum);

    /// @p sum += @p tall times @p flat, with few columns and few rows.
    void
    add_outer_product(const ConstBlock &tall,
                      const ConstBlock &flat,
                      Block             sum);
  } // namespace Contact
} // namespace Tribody

#endif

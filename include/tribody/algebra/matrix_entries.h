// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_algebra_matrix_entries_h
#define tribody_algebra_matrix_entries_h

#include <Eigen/Core>

namespace Tribody
{
  /**
   * Takes the entries of a square matrix as the elements of a mechanism add
   * them up, whatever way the matrix is stored. An element adds the same
   * places at every call, zeros included: the first call tells a sparse
   * matrix its pattern.
   */
  class MatrixEntries
  {
  public:
    virtual ~MatrixEntries() = default;

    /// Add @p value to the entry (@p row, @p column).
    virtual void
    add(const Eigen::Index row,
        const Eigen::Index column,
        const double       value) = 0;

    /// Add a small dense @p block whose upper left entry is at (@p row,
    /// @p column).
    template <typename Derived>
    void
    add_block(const Eigen::Index                row,
              const Eigen::Index                column,
              const Eigen::MatrixBase<Derived> &block)
    {
      for (Eigen::Index j = 0; j < block.cols(); ++j)
        for (Eigen::Index i = 0; i < block.rows(); ++i)
          add(row + i, column + j, block(i, j));
    }
  };

  /// Entries of a dense matrix, which must outlive this object.
  class DenseEntries : public MatrixEntries
  {
  public:
    /// Adds to what @p matrix holds already.
    explicit DenseEntries(
      Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<>> matrix)
      : matrix(matrix)
    {}

    void
    add(const Eigen::Index row,
        const Eigen::Index column,
        const double       value) override
    {
      matrix(row, column) += value;
    }

  private:
    Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<>> matrix;
  };
} // namespace Tribody

#endif

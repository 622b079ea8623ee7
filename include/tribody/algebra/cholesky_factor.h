// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_algebra_cholesky_factor_h
#define tribody_algebra_cholesky_factor_h

#include <deal.II/base/mpi.h>

#include <Eigen/SparseCore>

#include <memory>
#include <vector>

namespace dealii
{
  namespace TrilinosWrappers
  {
    class SparseMatrix;
  }
} // namespace dealii

namespace Tribody
{
  /// A copy of @p matrix, which must live on one rank (MPI_COMM_SELF).
  Eigen::SparseMatrix<double>
  to_eigen(const dealii::TrilinosWrappers::SparseMatrix &matrix);

  /**
   * The Cholesky factor of a sparse, symmetric and positive definite matrix,
   * made by CHOLMOD, for a block of its inverse.
   *
   * The unknowns of the block are eliminated last. What the others leave of the
   * matrix by then is their Schur complement, and its inverse is the block:
   * @f[ A = L L^T, \qquad (A^{-1})_{bb} = (L_{bb} L_{bb}^T)^{-1}. @f]
   * So the factor of the sparse matrix is computed once, and the rest, some
   * @f$2n_b^3/3@f$ operations, is dense. Solving for the columns of the block
   * would go through the whole factor twice for each.
   */
  class CholeskyFactor
  {
  public:
    /**
     * @param matrix of which the lower triangle is read.
     * @param block the unknowns of the block, each once.
     * @throws ExcRun if the matrix is not positive definite.
     */
    CholeskyFactor(const Eigen::SparseMatrix<double> &matrix,
                   const std::vector<int>            &block);

    ~CholeskyFactor();

    CholeskyFactor(const CholeskyFactor &) = delete;
    CholeskyFactor &
    operator=(const CholeskyFactor &) = delete;

    /**
     * @f$ (A^{-1})_{bb} @f$, in the order in which the block was given, exactly
     * symmetric. The ranks of @p communicator, which all must hold the same
     * factor, share the work; the result does not depend on their number.
     */
    Eigen::MatrixXd
    compute_inverse_block(const MPI_Comm &communicator = MPI_COMM_SELF) const;

  private:
    /// @f$ L_{bb} @f$, lower triangular.
    Eigen::MatrixXd
    trailing_block() const;

    struct Cholmod;
    std::unique_ptr<Cholmod> cholmod;
    Eigen::Index             n_block;
  };
} // namespace Tribody

#endif

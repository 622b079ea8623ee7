// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <tribody/algebra/cholesky_factor.h>
#include <tribody/base/exceptions.h>

#include <algorithm>
#include <cholmod.h>
#include <numeric>
#include <omp.h>

namespace Tribody
{
  namespace
  {
    /// Columns of the inverse that are computed at a time: enough for products
    /// of matrices, few enough to share them evenly.
    constexpr Eigen::Index block_width = 64;



    /// CHOLMOD would start four threads for loops too short to gain by them.
    class SingleThread
    {
    public:
      SingleThread()
        : before(omp_get_max_active_levels())
      {
        omp_set_max_active_levels(0);
      }

      ~SingleThread()
      {
        omp_set_max_active_levels(before);
      }

      SingleThread(const SingleThread &) = delete;
      SingleThread &
      operator=(const SingleThread &) = delete;

    private:
      int before;
    };



    /// The lower triangle of @p matrix as CHOLMOD sees it.
    cholmod_sparse
    view(const Eigen::SparseMatrix<double> &matrix)
    {
      cholmod_sparse result = {};
      result.nrow           = matrix.rows();
      result.ncol           = matrix.cols();
      result.nzmax          = matrix.nonZeros();
      // CHOLMOD wants mutable arrays but only reads them.
      result.p      = const_cast<int *>(matrix.outerIndexPtr());
      result.i      = const_cast<int *>(matrix.innerIndexPtr());
      result.x      = const_cast<double *>(matrix.valuePtr());
      result.stype  = -1;
      result.itype  = CHOLMOD_INT;
      result.xtype  = CHOLMOD_REAL;
      result.dtype  = CHOLMOD_DOUBLE;
      result.sorted = 1;
      result.packed = 1;
      return result;
    }
  } // namespace



  Eigen::SparseMatrix<double>
  to_eigen(const dealii::TrilinosWrappers::SparseMatrix &matrix)
  {
    const Epetra_CrsMatrix                      &crs = matrix.trilinos_matrix();
    Eigen::SparseMatrix<double, Eigen::RowMajor> by_rows(matrix.m(),
                                                         matrix.n());
    by_rows.resizeNonZeros(matrix.n_nonzero_elements());
    int n = 0;
    for (int i = 0; i < by_rows.rows(); ++i)
      {
        int     n_entries;
        double *values;
        int    *columns;
        crs.ExtractMyRowView(i, n_entries, values, columns);
        for (int k = 0; k < n_entries; ++k, ++n)
          {
            by_rows.innerIndexPtr()[n] = crs.GCID(columns[k]);
            by_rows.valuePtr()[n]      = values[k];
          }
        by_rows.outerIndexPtr()[i + 1] = n;
      }
    return by_rows;
  }



  struct CholeskyFactor::Cholmod
  {
    Cholmod()
    {
      cholmod_start(&common);
      // Errors are thrown here, not printed there.
      common.print = 0;
    }

    ~Cholmod()
    {
      cholmod_free_factor(&factor, &common);
      cholmod_finish(&common);
    }

    Cholmod(const Cholmod &) = delete;
    Cholmod &
    operator=(const Cholmod &) = delete;

    cholmod_common  common;
    cholmod_factor *factor = nullptr;
  };



  CholeskyFactor::CholeskyFactor(const Eigen::SparseMatrix<double> &matrix,
                                 const std::vector<int>            &block)
    : cholmod(std::make_unique<Cholmod>())
    , n_block(block.size())
  {
    AssertDimension(matrix.rows(), matrix.cols());
    Assert(matrix.isCompressed(), dealii::ExcInternalError());
    const SingleThread single_thread;
    cholmod_common    &common         = cholmod->common;
    cholmod_sparse     view_of_matrix = view(matrix);

    // Minimum degree among the others, then the block in the order given.
    std::vector<int> is_in_block(matrix.rows(), 0), order(matrix.rows());
    for (const int i : block)
      is_in_block[i] = 1;
    cholmod_camd(
      &view_of_matrix, nullptr, 0, is_in_block.data(), order.data(), &common);
    std::copy(block.begin(), block.end(), order.end() - n_block);

    common.nmethods           = 1;
    common.method[0].ordering = CHOLMOD_GIVEN;
    common.postorder          = 0;
    common.supernodal         = CHOLMOD_SUPERNODAL;
    cholmod->factor =
      cholmod_analyze_p(&view_of_matrix, order.data(), nullptr, 0, &common);
    const bool factorised =
      cholmod->factor != nullptr &&
      cholmod_factorize(&view_of_matrix, cholmod->factor, &common) != 0 &&
      common.status == CHOLMOD_OK;
    AssertThrow(factorised,
                ExcRun("A matrix with " + std::to_string(matrix.rows()) +
                       " rows could not be factorised: " +
                       (common.status == CHOLMOD_NOT_POSDEF
                          ? "it is not positive definite."
                          : "CHOLMOD failed with status " +
                              std::to_string(common.status) + ".")));
  }



  CholeskyFactor::~CholeskyFactor() = default;



  Eigen::MatrixXd
  CholeskyFactor::trailing_block() const
  {
    const cholmod_factor &L        = *cholmod->factor;
    const auto           *super    = static_cast<const int *>(L.super);
    const auto           *row      = static_cast<const int *>(L.s);
    const auto           *row_at   = static_cast<const int *>(L.pi);
    const auto           *value    = static_cast<const double *>(L.x);
    const auto           *value_at = static_cast<const int *>(L.px);
    const int             first    = static_cast<int>(L.n - n_block);

    Eigen::MatrixXd block = Eigen::MatrixXd::Zero(n_block, n_block);
    for (int k = static_cast<int>(L.nsuper) - 1; k >= 0 && super[k + 1] > first;
         --k)
      {
        // Dense columns, all with the rows of the first one.
        const int n_rows = row_at[k + 1] - row_at[k];
        for (int column = std::max(super[k], first); column < super[k + 1];
             ++column)
          {
            const int     c      = column - super[k];
            const double *values = value + value_at[k] + c * n_rows;
            for (int r = c; r < n_rows; ++r)
              block(row[row_at[k] + r] - first, column - first) = values[r];
          }
      }
    return block;
  }



  Eigen::MatrixXd
  CholeskyFactor::compute_inverse_block(const MPI_Comm &communicator) const
  {
    const Eigen::MatrixXd L = trailing_block();
    const unsigned int    n_ranks =
      dealii::Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int rank =
      dealii::Utilities::MPI::this_mpi_process(communicator);

    // Column j of the inverse from the diagonal downwards needs L from there
    // downwards only.
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(n_block, n_block);
    unsigned int    turn    = 0;
    for (Eigen::Index first = 0; first < n_block; first += block_width, ++turn)
      if (turn % n_ranks == rank)
        {
          const Eigen::Index width = std::min(block_width, n_block - first);
          const Eigen::Index rest  = n_block - first;
          const auto         trailing =
            L.bottomRightCorner(rest, rest).triangularView<Eigen::Lower>();
          Eigen::MatrixXd columns = Eigen::MatrixXd::Identity(rest, width);
          trailing.solveInPlace(columns);
          trailing.transpose().solveInPlace(columns);
          inverse.block(first, first, rest, width) = columns;
        }
    if (n_ranks > 1)
      dealii::Utilities::MPI::sum(
        dealii::ArrayView<const double>(inverse.data(), inverse.size()),
        communicator,
        dealii::ArrayView<double>(inverse.data(), inverse.size()));
    inverse.triangularView<Eigen::StrictlyUpper>() = inverse.transpose();
    return inverse;
  }
} // namespace Tribody

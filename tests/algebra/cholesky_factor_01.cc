// SPDX-License-Identifier: LGPL-2.1-or-later

// A block of the inverse of a sparse matrix. Known in closed form: for the
// second difference (-1, 2, -1) of n points the inverse has the entries
// min(i, j) (n + 1 - max(i, j)) / (n + 1), counted from one. The block is every
// third unknown, backwards. Two ranks must give what one gives, to the bit.

#include <deal.II/base/mpi.h>

#include <tribody/algebra/cholesky_factor.h>
#include <tribody/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace Tribody;

namespace
{
  Eigen::SparseMatrix<double>
  second_difference(const int n, const double diagonal)
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i)
      {
        entries.emplace_back(i, i, diagonal);
        if (i > 0)
          entries.emplace_back(i, i - 1, -1.);
      }
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::ofstream                                  output;
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    output.open("output");

  const int        n = 1000;
  std::vector<int> block;
  for (int i = n - 1; i >= 0; i -= 3)
    block.push_back(i);

  const CholeskyFactor  factor(second_difference(n, 2.), block);
  const Eigen::MatrixXd shared = factor.compute_inverse_block(MPI_COMM_WORLD);
  const Eigen::MatrixXd alone  = factor.compute_inverse_block();
  double                error  = 0.;
  for (std::size_t a = 0; a < block.size(); ++a)
    for (std::size_t b = 0; b < block.size(); ++b)
      {
        const double i = block[a] + 1, j = block[b] + 1;
        const double exact =
          std::min(i, j) * (n + 1 - std::max(i, j)) / (n + 1);
        error = std::max(error, std::abs(shared(a, b) - exact));
      }
  // The condition number is 4e5 and the largest entry 250.
  output << "block of " << shared.rows()
         << ", error below 1e-9: " << (error < 1e-9 ? "yes" : "no") << '\n'
         << "symmetric: " << (shared == shared.transpose() ? "yes" : "no")
         << '\n'
         << "ranks agree to the bit: " << (shared == alone ? "yes" : "no")
         << '\n';

  try
    {
      // Its eigenvalues reach down to 1.9 - 2.
      const CholeskyFactor indefinite(second_difference(n, 1.9), block);
    }
  catch (const ExcRun &exception)
    {
      output << message_of(exception) << '\n';
    }
}

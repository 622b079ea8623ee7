// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/mechanism.h>
#include <tribody/multibody/system/sparse_jacobian.h>

#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // Takes of (., Phi_q^T; Phi_q, .) what is below.
      class LowerLeftEntries : public MatrixEntries
      {
      public:
        explicit LowerLeftEntries(const Eigen::Index first_row)
          : first_row(first_row)
        {}

        void
        add(const Eigen::Index row,
            const Eigen::Index column,
            const double       value) override
        {
          if (row >= first_row)
            entries.emplace_back(row - first_row, column, value);
        }

        std::vector<Eigen::Triplet<double>> entries;

      private:
        Eigen::Index first_row;
      };
    } // namespace



    Eigen::SparseMatrix<double>
    compute_sparse_jacobian(const EquationsOfMotion &equations,
                            const Eigen::VectorXd   &q)
    {
      LowerLeftEntries below(q.size());
      equations.add_constraint_jacobian(q, q.size(), below);
      Eigen::SparseMatrix<double> jacobian(
        equations.mechanism().n_constraints(), q.size());
      jacobian.setFromTriplets(below.entries.begin(), below.entries.end());
      return jacobian;
    }
  } // namespace Multibody
} // namespace Tribody

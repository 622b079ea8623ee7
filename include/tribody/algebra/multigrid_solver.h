// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_algebra_multigrid_solver_h
#define tribody_algebra_multigrid_solver_h

#include <tribody/algebra/linear_solver.h>

namespace dealii
{
  namespace TrilinosWrappers
  {
    class PreconditionAMG;
  }
} // namespace dealii

namespace Tribody
{
  /**
   * A symmetric and positive definite matrix whose rows ranks share, solved by
   * conjugate gradients (Trilinos' Belos) with algebraic multigrid (ML,
   * smoothed aggregation) as preconditioner. The columns of a block are
   * iterated side by side, each with its own search directions, so that
   * products with the matrix read it once for all of them.
   *
   * Columns are solved until the residual is @ref tolerance times the
   * right-hand side. The displacement in a column u_j of the inverse is then
   * wrong by less than tolerance times the length |u_i| of the column of the
   * place where one looks. That is a sum over the mesh: it grows with the root
   * of the number of equations.
   */
  class MultigridSolver : public LinearSolver
  {
  public:
    /// Of the residual, as a fraction of the right-hand side [-]: it leaves
    /// two digits for what a compliance loses by the length of |u_i| on some
    /// 10 000 equations, if 1e-10 is asked of it.
    static constexpr double tolerance = 1e-12;

    /// Set up the levels. @param dof_handler of the unknowns, with an element
    /// FESystem<2>(FE_Q<2>(p), 2).
    MultigridSolver(const dealii::TrilinosWrappers::SparseMatrix &matrix,
                    const dealii::DoFHandler<2, 2>               &dof_handler,
                    const SlowModes                               slow_modes);

    ~MultigridSolver() override;

    /// @throws ExcRun on all ranks if the iteration does not converge.
    Eigen::MatrixXd
    solve(
      const Eigen::Ref<const Eigen::MatrixXd> &right_hand_sides) const override;

  private:
    const dealii::TrilinosWrappers::SparseMatrix              &matrix;
    std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG> preconditioner;
  };
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_algebra_direct_solver_h
#define tribody_algebra_direct_solver_h

#include <tribody/algebra/linear_solver.h>

class Amesos_BaseSolver;
class Epetra_LinearProblem;

namespace dealii
{
  template <typename Number>
  class Vector;
} // namespace dealii

namespace Tribody
{
  /**
   * A sparse matrix, factorised once by Trilinos (Amesos, KLU), and solved for
   * blocks of right-hand sides at a time.
   *
   * deal.II's TrilinosWrappers::SolverDirect takes one vector at a time; KLU
   * needs per vector little more than a third of that when it gets many. The
   * matrix must live on one rank (MPI_COMM_SELF) and outlive this object.
   */
  class DirectSolver : public LinearSolver
  {
  public:
    /// Factorise @p matrix. @throws ExcRun if it is singular.
    explicit DirectSolver(const dealii::TrilinosWrappers::SparseMatrix &matrix);

    ~DirectSolver() override;

    DirectSolver(const DirectSolver &) = delete;
    DirectSolver &
    operator=(const DirectSolver &) = delete;

    Eigen::MatrixXd
    solve(
      const Eigen::Ref<const Eigen::MatrixXd> &right_hand_sides) const override;

    /// The solution for one right-hand side.
    dealii::Vector<double>
    solve(const dealii::Vector<double> &right_hand_side) const;

  private:
    const dealii::TrilinosWrappers::SparseMatrix &matrix;
    std::unique_ptr<Epetra_LinearProblem>         problem;
    std::unique_ptr<Amesos_BaseSolver>            solver;
  };
} // namespace Tribody

#endif

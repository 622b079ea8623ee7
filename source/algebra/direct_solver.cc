// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <tribody/algebra/direct_solver.h>
#include <tribody/base/exceptions.h>

#include <Amesos.h>
#include <Epetra_LinearProblem.h>
#include <Epetra_MultiVector.h>

namespace Tribody
{
  DirectSolver::DirectSolver(
    const dealii::TrilinosWrappers::SparseMatrix &matrix)
    : matrix(matrix)
    , problem(std::make_unique<Epetra_LinearProblem>())
  {
    // Amesos wants a mutable matrix but only reads it.
    problem->SetOperator(
      const_cast<Epetra_CrsMatrix *>(&matrix.trilinos_matrix()));
    solver.reset(Amesos().Create("Amesos_Klu", *problem));
    AssertThrow(solver != nullptr,
                ExcRun("This Trilinos was built without Amesos_Klu."));
    const bool factorised = solver->SymbolicFactorization() == 0 &&
                            solver->NumericFactorization() == 0;
    AssertThrow(factorised,
                ExcRun("The direct solver could not factorise a matrix with " +
                       std::to_string(matrix.m()) + " rows: it is singular."));
  }



  DirectSolver::~DirectSolver() = default;



  Eigen::MatrixXd
  DirectSolver::solve(
    const Eigen::Ref<const Eigen::MatrixXd> &right_hand_sides) const
  {
    AssertDimension(right_hand_sides.rows(),
                    static_cast<Eigen::Index>(matrix.m()));
    Eigen::MatrixXd solutions(right_hand_sides.rows(), right_hand_sides.cols());
    if (right_hand_sides.cols() == 0)
      return solutions;

    const Epetra_Map  &map = matrix.trilinos_matrix().RowMap();
    Epetra_MultiVector b(View,
                         map,
                         const_cast<double *>(right_hand_sides.data()),
                         right_hand_sides.outerStride(),
                         right_hand_sides.cols());
    Epetra_MultiVector x(
      View, map, solutions.data(), solutions.rows(), solutions.cols());
    problem->SetRHS(&b);
    problem->SetLHS(&x);
    const int error = solver->Solve();
    AssertThrow(error == 0,
                ExcRun("The direct solver failed with error " +
                       std::to_string(error) + "."));
    return solutions;
  }



  dealii::Vector<double>
  DirectSolver::solve(const dealii::Vector<double> &right_hand_side) const
  {
    const Eigen::MatrixXd x =
      solve(Eigen::Map<const Eigen::VectorXd>(right_hand_side.begin(),
                                              right_hand_side.size()));
    return dealii::Vector<double>(x.data(), x.data() + x.size());
  }
} // namespace Tribody

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/multigrid_solver.h>

#include <BelosEpetraAdapter.hpp>
#include <BelosLinearProblem.hpp>
#include <BelosPseudoBlockCGSolMgr.hpp>
#include <Epetra_MultiVector.h>
#include <string>

namespace Tribody
{
  MultigridSolver::MultigridSolver(
    const dealii::TrilinosWrappers::SparseMatrix &matrix,
    const dealii::DoFHandler<2, 2>               &dof_handler)
    : matrix(matrix)
    , preconditioner(
        std::make_unique<dealii::TrilinosWrappers::PreconditionAMG>())
  {
    dealii::TrilinosWrappers::PreconditionAMG::AdditionalData data;
    data.elliptic              = true;
    data.higher_order_elements = dof_handler.get_fe().degree > 1;
    data.aggregation_threshold = 0.02;
    dealii::DoFTools::extract_constant_modes(
      dof_handler,
      dealii::ComponentMask(dof_handler.get_fe().n_components(), true),
      data.constant_modes);
    preconditioner->initialize(matrix, data);
  }



  MultigridSolver::~MultigridSolver() = default;



  Eigen::MatrixXd
  MultigridSolver::solve(
    const Eigen::Ref<const Eigen::MatrixXd> &right_hand_sides) const
  {
    using Problem =
      Belos::LinearProblem<double, Epetra_MultiVector, Epetra_Operator>;
    using Solver =
      Belos::PseudoBlockCGSolMgr<double, Epetra_MultiVector, Epetra_Operator>;
    // Far more than a preconditioner that works needs, whatever the mesh.
    constexpr int max_iterations = 1000;

    Eigen::MatrixXd solutions =
      Eigen::MatrixXd::Zero(right_hand_sides.rows(), right_hand_sides.cols());
    const Epetra_Map  &map = matrix.trilinos_matrix().RowMap();
    Epetra_MultiVector b(View,
                         map,
                         const_cast<double *>(right_hand_sides.data()),
                         right_hand_sides.outerStride(),
                         right_hand_sides.cols());
    Epetra_MultiVector x(
      View, map, solutions.data(), solutions.rows(), solutions.cols());

    // Belos wants mutable operators but only applies them.
    const auto problem = Teuchos::rcp(
      new Problem(Teuchos::rcpFromRef<Epetra_Operator>(
                    const_cast<Epetra_CrsMatrix &>(matrix.trilinos_matrix())),
                  Teuchos::rcpFromRef(x),
                  Teuchos::rcpFromRef<const Epetra_MultiVector>(b)));
    problem->setLeftPrec(Teuchos::rcp(new Belos::EpetraPrecOp(
      Teuchos::rcpFromRef(preconditioner->trilinos_operator()))));
    problem->setProblem();

    const auto options = Teuchos::parameterList();
    options->set("Convergence Tolerance", tolerance);
    options->set("Maximum Iterations", max_iterations);
    Solver     solver(problem, options);
    const bool converged = solver.solve() == Belos::Converged;
    iterations           = solver.getNumIters();
    AssertThrow(converged,
                ExcRun("Conjugate gradients with multigrid did not solve a "
                       "system of " +
                       std::to_string(matrix.m()) + " equations in " +
                       std::to_string(iterations) +
                       " iterations: is it close to singular?"));
    return solutions;
  }
} // namespace Tribody

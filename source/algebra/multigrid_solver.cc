// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/filtered_iterator.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <tribody/algebra/multigrid_solver.h>
#include <tribody/base/exceptions.h>

#include <BelosEpetraAdapter.hpp>
#include <BelosLinearProblem.hpp>
#include <BelosPseudoBlockCGSolMgr.hpp>
#include <Epetra_MultiVector.h>
#include <string>

namespace Tribody
{
  namespace
  {
    /// In the mesh as manufactured: the rotation about the origin, by an angle
    /// that makes it as large as the constants at the outermost node.
    std::vector<double>
    rotation(const dealii::DoFHandler<2> &dof_handler)
    {
      const auto               &fe    = dof_handler.get_fe();
      const auto               &owned = dof_handler.locally_owned_dofs();
      const dealii::MappingQ<2> as_manufactured(fe.degree);
      dealii::FEValues<2>       fe_values(as_manufactured,
                                    fe,
                                    dealii::Quadrature<2>(
                                      fe.get_unit_support_points()),
                                    dealii::update_quadrature_points);
      std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
      std::vector<double>                          result(owned.n_elements());
      double                                       outermost = 0.;
      for (const auto &cell : dof_handler.active_cell_iterators() |
                                dealii::IteratorFilters::LocallyOwnedCell())
        {
          fe_values.reinit(cell);
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            if (owned.is_element(dofs[i]))
              {
                const dealii::Point<2> x = fe_values.quadrature_point(i);
                result[owned.index_within_set(dofs[i])] =
                  fe.system_to_component_index(i).first == 0 ? -x[1] : x[0];
                outermost = std::max(outermost, x.norm());
              }
        }
      outermost =
        dealii::Utilities::MPI::max(outermost, dof_handler.get_communicator());
      for (double &value : result)
        value /= outermost;
      return result;
    }
  } // namespace



  MultigridSolver::MultigridSolver(
    const dealii::TrilinosWrappers::SparseMatrix &matrix,
    const dealii::DoFHandler<2, 2>               &dof_handler,
    const SlowModes                               slow_modes)
    : matrix(matrix)
    , preconditioner(
        std::make_unique<dealii::TrilinosWrappers::PreconditionAMG>())
  {
    dealii::TrilinosWrappers::PreconditionAMG::AdditionalData data;
    data.elliptic              = true;
    data.higher_order_elements = dof_handler.get_fe().degree > 1;
    dealii::DoFTools::extract_constant_modes(
      dof_handler,
      dealii::ComponentMask(dof_handler.get_fe().n_components(), true),
      data.constant_modes);

    Teuchos::ParameterList              options;
    std::unique_ptr<Epetra_MultiVector> constants;
    data.set_parameters(options, constants, matrix);
    // ML copies the vectors.
    std::vector<double> modes;
    if (slow_modes == SlowModes::rigid_motions)
      {
        modes = rotation(dof_handler);
        modes.insert(modes.begin(),
                     constants->Values(),
                     constants->Values() +
                       constants->NumVectors() * constants->Stride());
        options.set("null space: dimension", constants->NumVectors() + 1);
        options.set("null space: vectors", modes.data());
      }
    preconditioner->initialize(matrix, options);
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
    Solver solver(problem, options);
    // Belos throws where the preconditioned matrix is not positive definite.
    bool converged = false;
    try
      {
        converged = solver.solve() == Belos::Converged;
      }
    catch (const Belos::BelosError &)
      {}
    AssertThrow(converged,
                ExcRun("Conjugate gradients with multigrid did not solve a "
                       "system of " +
                       std::to_string(matrix.m()) + " equations in " +
                       std::to_string(solver.getNumIters()) +
                       " iterations: is it close to singular? 'Stiffness "
                       "solver = direct' takes any mesh that fits the "
                       "memory."));
    return solutions;
  }
} // namespace Tribody

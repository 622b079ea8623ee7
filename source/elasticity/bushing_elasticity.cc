#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <tribody/base/direct_solver.h>
#include <tribody/base/exceptions.h>
#include <tribody/elasticity/bushing_elasticity.h>
#include <tribody/surface/boundary_ids.h>

#include <algorithm>

namespace Tribody
{
  namespace Elasticity
  {
    namespace
    {
      /// Right-hand sides that are solved for at a time: enough for KLU to
      /// reuse its factors, few enough to stay in the cache.
      constexpr Eigen::Index block_size = 16;

      /// The stiffness of one cell; the element's basis is scalar times unit
      /// vector, so that every strain has one row of the gradient only.
      void
      compute_cell_matrix(const dealii::FEValues<2>  &fe_values,
                          const PlaneHooke           &law,
                          dealii::FullMatrix<double> &cell_matrix)
      {
        const auto        &fe = fe_values.get_fe();
        const unsigned int n  = fe.n_dofs_per_cell();
        cell_matrix           = 0.;
        for (const unsigned int q : fe_values.quadrature_point_indices())
          for (unsigned int i = 0; i < n; ++i)
            {
              const unsigned int c = fe.system_to_component_index(i).first;
              const auto grad_i = fe_values.shape_grad(i, q) * fe_values.JxW(q);
              for (unsigned int j = 0; j <= i; ++j)
                {
                  const unsigned int d = fe.system_to_component_index(j).first;
                  const auto        &grad_j = fe_values.shape_grad(j, q);
                  cell_matrix(i, j) += law.lambda * grad_i[c] * grad_j[d] +
                                       law.mu * grad_i[d] * grad_j[c];
                  if (c == d)
                    cell_matrix(i, j) += law.mu * (grad_i * grad_j);
                }
            }
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < i; ++j)
            cell_matrix(j, i) = cell_matrix(i, j);
      }
    } // namespace



    BushingElasticity::BushingElasticity(
      const dealii::Triangulation<2, 2> &triangulation,
      const unsigned int                 degree,
      const Material                    &material,
      const PlaneState                   plane_state)
      : law(material, plane_state)
      , fe(dealii::FE_Q<2>(degree), 2)
      , dof_handler(triangulation)
    {
      dof_handler.distribute_dofs(fe);
      nodes = make_bore_nodes(dof_handler);

      dealii::DoFTools::make_hanging_node_constraints(dof_handler, constraints);
      dealii::DoFTools::make_zero_boundary_constraints(dof_handler,
                                                       BoundaryIds::rim,
                                                       constraints);
      constraints.close();

      dealii::DynamicSparsityPattern sparsity(dof_handler.n_dofs());
      dealii::DoFTools::make_sparsity_pattern(
        dof_handler,
        sparsity,
        constraints,
        /*keep_constrained_dofs = */ false);
      stiffness.reinit(dof_handler.locally_owned_dofs(),
                       sparsity,
                       MPI_COMM_SELF);
    }



    BushingElasticity::~BushingElasticity() = default;



    void
    BushingElasticity::reinit(const dealii::Mapping<2, 2> &mapping)
    {
      solver.reset();
      assemble(mapping);
      solver = std::make_unique<DirectSolver>(stiffness);
    }



    void
    BushingElasticity::assemble(const dealii::Mapping<2, 2> &mapping)
    {
      stiffness = 0.;
      // One order more than affine cells need: the cells at the bore are
      // curved.
      const dealii::QGauss<2>    quadrature(fe.degree + 1);
      dealii::FEValues<2>        fe_values(mapping,
                                    fe,
                                    quadrature,
                                    dealii::update_gradients |
                                      dealii::update_JxW_values);
      dealii::FullMatrix<double> cell_matrix(fe.n_dofs_per_cell(),
                                             fe.n_dofs_per_cell());
      std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
      for (const auto &cell : dof_handler.active_cell_iterators())
        {
          fe_values.reinit(cell);
          compute_cell_matrix(fe_values, law, cell_matrix);
          cell->get_dof_indices(dofs);
          constraints.distribute_local_to_global(cell_matrix, dofs, stiffness);
        }
      stiffness.compress(dealii::VectorOperation::add);
    }



    Eigen::MatrixXd
    BushingElasticity::normal_compliance(const Eigen::Matrix2Xd &normals) const
    {
      Assert(solver != nullptr, dealii::ExcNotInitialized());
      const Eigen::Index n = nodes.n_nodes();
      AssertDimension(normals.cols(), n);

      Eigen::MatrixXd compliance(n, n);
      for (Eigen::Index first = 0; first < n; first += block_size)
        {
          const Eigen::Index n_columns = std::min(block_size, n - first);
          Eigen::MatrixXd    forces =
            Eigen::MatrixXd::Zero(dof_handler.n_dofs(), n_columns);
          for (Eigen::Index j = 0; j < n_columns; ++j)
            {
              forces(nodes.x_dofs[first + j], j) = normals(0, first + j);
              forces(nodes.y_dofs[first + j], j) = normals(1, first + j);
            }
          // Hanging nodes never carry a bore node's weight, and what they
          // are themselves is not asked for here.
          const Eigen::MatrixXd displacements = solver->solve(forces);
          for (Eigen::Index i = 0; i < n; ++i)
            compliance.block(i, first, 1, n_columns) =
              normals(0, i) * displacements.row(nodes.x_dofs[i]) +
              normals(1, i) * displacements.row(nodes.y_dofs[i]);
        }

      const double asymmetry =
        (compliance - compliance.transpose()).cwiseAbs().maxCoeff() /
        compliance.cwiseAbs().maxCoeff();
      AssertThrow(asymmetry < 1e-10,
                  ExcRun(
                    "The compliance of a bushing came out unsymmetric by " +
                    std::to_string(asymmetry) +
                    " of its largest entry: its stiffness is close to "
                    "singular. Check the mesh and Poisson's ratio."));
      return 0.5 * (compliance + compliance.transpose());
    }



    dealii::Vector<double>
    BushingElasticity::solve(const Eigen::Matrix2Xd &nodal_forces) const
    {
      Assert(solver != nullptr, dealii::ExcNotInitialized());
      AssertDimension(nodal_forces.cols(), nodes.n_nodes());
      dealii::Vector<double> forces(dof_handler.n_dofs());
      for (Eigen::Index i = 0; i < nodes.n_nodes(); ++i)
        {
          forces[nodes.x_dofs[i]] = nodal_forces(0, i);
          forces[nodes.y_dofs[i]] = nodal_forces(1, i);
        }
      dealii::Vector<double> displacement = solver->solve(forces);
      constraints.distribute(displacement);
      return displacement;
    }
  } // namespace Elasticity
} // namespace Tribody

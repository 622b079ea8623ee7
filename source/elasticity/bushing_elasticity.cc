#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/vector.h>

#include <tribody/base/direct_solver.h>
#include <tribody/elasticity/bushing_elasticity.h>
#include <tribody/elasticity/stiffness.h>
#include <tribody/elasticity/surface_compliance.h>
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
    } // namespace



    BushingElasticity::BushingElasticity(
      const dealii::Triangulation<2, 2> &triangulation,
      const unsigned int                 degree,
      const Material                    &material,
      const PlaneState                   plane_state,
      const RimSupport                  &support)
      : law(material, plane_state)
      , support(support)
      , fe(dealii::FE_Q<2>(degree), 2)
      , dof_handler(triangulation)
    {
      dof_handler.distribute_dofs(fe);
      nodes = make_bore_nodes(dof_handler);

      dealii::DoFTools::make_hanging_node_constraints(dof_handler, constraints);
      if (support.is_clamped())
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
      assemble_stiffness(mapping, dof_handler, constraints, law, stiffness);
      if (!support.is_clamped())
        assemble_foundation(
          mapping, dof_handler, constraints, support, stiffness);
      solver = std::make_unique<DirectSolver>(stiffness);
    }



    Eigen::MatrixXd
    BushingElasticity::normal_compliance(const Eigen::Matrix2Xd &normals,
                                         const RingSymmetry      symmetry) const
    {
      Assert(solver != nullptr, dealii::ExcNotInitialized());
      const Eigen::Index n = nodes.n_nodes();
      AssertDimension(normals.cols(), n);
      const bool   cells_alike = (symmetry == RingSymmetry::cells_alike);
      Eigen::Index n_columns   = cells_alike ? nodes.degree : n;

      Eigen::MatrixXd compliance(n, n_columns);
      for (Eigen::Index first = 0; first < n_columns; first += block_size)
        {
          const Eigen::Index n_block = std::min(block_size, n_columns - first);
          Eigen::MatrixXd    forces =
            Eigen::MatrixXd::Zero(dof_handler.n_dofs(), n_block);
          for (Eigen::Index j = 0; j < n_block; ++j)
            {
              forces(nodes.x_dofs[first + j], j) = normals(0, first + j);
              forces(nodes.y_dofs[first + j], j) = normals(1, first + j);
            }
          // Hanging nodes never carry a bore node's weight, and what they
          // are themselves is not asked for here.
          const Eigen::MatrixXd displacements = solver->solve(forces);
          for (Eigen::Index i = 0; i < n; ++i)
            compliance.block(i, first, 1, n_block) =
              normals(0, i) * displacements.row(nodes.x_dofs[i]) +
              normals(1, i) * displacements.row(nodes.y_dofs[i]);
        }
      return symmetric_part(cells_alike ? repeat_around(compliance)
                                        : compliance,
                            "bushing");
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

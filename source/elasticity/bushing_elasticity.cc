#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/vector.h>

#include <tribody/base/cholesky_factor.h>
#include <tribody/base/direct_solver.h>
#include <tribody/elasticity/bushing_elasticity.h>
#include <tribody/elasticity/stiffness.h>
#include <tribody/elasticity/surface_compliance.h>
#include <tribody/surface/boundary_ids.h>

#include <vector>

namespace Tribody
{
  namespace Elasticity
  {
    namespace
    {
      /// @p stiffness with the normal and the tangential displacement of each
      /// bore node in the places of x and y.
      Eigen::SparseMatrix<double>
      turn_to_normals(const dealii::TrilinosWrappers::SparseMatrix &stiffness,
                      const BoreNodes                              &nodes,
                      const Eigen::Matrix2Xd                       &normals)
      {
        std::vector<Eigen::Triplet<double>> entries;
        std::vector<bool>                   turned(stiffness.m(), false);
        for (Eigen::Index i = 0; i < nodes.n_nodes(); ++i)
          {
            const int x = nodes.x_dofs[i], y = nodes.y_dofs[i];
            entries.emplace_back(x, x, normals(0, i));
            entries.emplace_back(y, x, normals(1, i));
            entries.emplace_back(x, y, -normals(1, i));
            entries.emplace_back(y, y, normals(0, i));
            turned[x] = turned[y] = true;
          }
        for (unsigned int i = 0; i < turned.size(); ++i)
          if (!turned[i])
            entries.emplace_back(i, i, 1.);
        Eigen::SparseMatrix<double> turn(stiffness.m(), stiffness.m());
        turn.setFromTriplets(entries.begin(), entries.end());

        const Eigen::SparseMatrix<double> turned_columns =
          to_eigen(stiffness) * turn;
        return turn.transpose() * turned_columns;
      }
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
      is_assembled = true;
    }



    const DirectSolver &
    BushingElasticity::direct_solver() const
    {
      Assert(is_assembled, dealii::ExcNotInitialized());
      if (solver == nullptr)
        solver = std::make_unique<DirectSolver>(stiffness);
      return *solver;
    }



    Eigen::MatrixXd
    BushingElasticity::normal_compliance(const Eigen::Matrix2Xd &normals,
                                         const RingSymmetry      symmetry,
                                         const MPI_Comm &communicator) const
    {
      Assert(is_assembled, dealii::ExcNotInitialized());
      AssertDimension(normals.cols(), nodes.n_nodes());
      if (symmetry == RingSymmetry::cells_alike)
        return symmetric_part(
          repeat_around(first_columns(normals, nodes.degree)), "bushing");

      // The normal displacement of a bore node takes the place of x. Hanging
      // nodes are never bore nodes.
      const CholeskyFactor factor(turn_to_normals(stiffness, nodes, normals),
                                  {nodes.x_dofs.begin(), nodes.x_dofs.end()});
      return factor.compute_inverse_block(communicator);
    }



    Eigen::MatrixXd
    BushingElasticity::first_columns(const Eigen::Matrix2Xd &normals,
                                     const Eigen::Index      n_columns) const
    {
      const Eigen::Index n = nodes.n_nodes();
      Eigen::MatrixXd    forces =
        Eigen::MatrixXd::Zero(dof_handler.n_dofs(), n_columns);
      for (Eigen::Index j = 0; j < n_columns; ++j)
        {
          forces(nodes.x_dofs[j], j) = normals(0, j);
          forces(nodes.y_dofs[j], j) = normals(1, j);
        }
      const Eigen::MatrixXd displacements = direct_solver().solve(forces);
      Eigen::MatrixXd       columns(n, n_columns);
      for (Eigen::Index i = 0; i < n; ++i)
        columns.row(i) = normals(0, i) * displacements.row(nodes.x_dofs[i]) +
                         normals(1, i) * displacements.row(nodes.y_dofs[i]);
      return columns;
    }



    dealii::Vector<double>
    BushingElasticity::solve(const Eigen::Matrix2Xd &nodal_forces) const
    {
      AssertDimension(nodal_forces.cols(), nodes.n_nodes());
      dealii::Vector<double> forces(dof_handler.n_dofs());
      for (Eigen::Index i = 0; i < nodes.n_nodes(); ++i)
        {
          forces[nodes.x_dofs[i]] = nodal_forces(0, i);
          forces[nodes.y_dofs[i]] = nodal_forces(1, i);
        }
      dealii::Vector<double> displacement = direct_solver().solve(forces);
      constraints.distribute(displacement);
      return displacement;
    }
  } // namespace Elasticity
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/vector.h>

#include <Eigen/LU>

#include <tribody/algebra/direct_solver.h>
#include <tribody/elasticity/pin_elasticity.h>
#include <tribody/elasticity/stiffness.h>
#include <tribody/surface/boundary_ids.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace Elasticity
  {
    namespace
    {
      /// Right-hand sides that are solved for at a time.
      constexpr Eigen::Index block_size = 16;

      /// Three degrees of freedom by which a body neither moves nor turns: one
      /// node entirely, and the one farthest from it across the line between
      /// them.
      std::array<dealii::types::global_dof_index, 3>
      find_held_dofs(const BoreNodes &nodes)
      {
        const Eigen::Vector2d first = nodes.positions.col(0);
        Eigen::Index          far;
        (nodes.positions.colwise() - first)
          .colwise()
          .squaredNorm()
          .maxCoeff(&far);
        const Eigen::Vector2d line = nodes.positions.col(far) - first;
        const bool is_along_x      = std::abs(line[0]) > std::abs(line[1]);
        return {{nodes.x_dofs[0],
                 nodes.y_dofs[0],
                 is_along_x ? nodes.y_dofs[far] : nodes.x_dofs[far]}};
      }
    } // namespace



    PinElasticity::PinElasticity(
      const dealii::Triangulation<2, 2> &triangulation,
      const unsigned int                 degree,
      const Material                    &material,
      const PlaneState                   plane_state)
      : law(material, plane_state)
      , fe(dealii::FE_Q<2>(degree), 2)
      , dof_handler(triangulation)
    {
      dof_handler.distribute_dofs(fe);
      nodes = make_bore_nodes(dof_handler, BoundaryIds::pin_surface);

      dealii::DoFTools::make_hanging_node_constraints(dof_handler, constraints);
      held_dofs = find_held_dofs(nodes);
      for (const auto dof : held_dofs)
        constraints.add_line(dof);
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



    PinElasticity::~PinElasticity() = default;



    void
    PinElasticity::reinit(const dealii::Mapping<2, 2> &mapping)
    {
      solver.reset();
      assemble_stiffness(mapping, dof_handler, constraints, law, stiffness);
      solver = std::make_unique<DirectSolver>(stiffness);
      integrate_rigid_fields(mapping);
    }



    void
    PinElasticity::integrate_rigid_fields(const dealii::Mapping<2, 2> &mapping)
    {
      const dealii::QGauss<2>     quadrature(fe.degree + 1);
      const dealii::Quadrature<2> nodes_of_cell(
        fe.base_element(0).get_unit_support_points());
      dealii::FEValues<2> fe_values(mapping,
                                    fe,
                                    quadrature,
                                    dealii::update_values |
                                      dealii::update_quadrature_points |
                                      dealii::update_JxW_values);
      dealii::FEValues<2> at_nodes(mapping,
                                   fe,
                                   nodes_of_cell,
                                   dealii::update_quadrature_points);
      const auto          field = [](const dealii::Point<2> &x,
                            const unsigned int      component) {
        return component == 0 ? Eigen::RowVector3d(1., 0., -x[1])
                                       : Eigen::RowVector3d(0., 1., x[0]);
      };

      rigid_fields.setZero(dof_handler.n_dofs(), 3);
      rigid_integrals.setZero(dof_handler.n_dofs(), 3);
      std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
      for (const auto &cell : dof_handler.active_cell_iterators())
        {
          fe_values.reinit(cell);
          at_nodes.reinit(cell);
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            {
              const auto [component, node] = fe.system_to_component_index(i);
              rigid_fields.row(dofs[i]) =
                field(at_nodes.quadrature_point(node), component);
              for (const unsigned int q : fe_values.quadrature_point_indices())
                rigid_integrals.row(dofs[i]) +=
                  fe_values.shape_value(i, q) * fe_values.JxW(q) *
                  field(fe_values.quadrature_point(q), component);
            }
        }
      // What acts on a hanging node acts on the nodes that carry it; the fields
      // are linear, so those of the hanging nodes need no change.
      dealii::AffineConstraints<double> hanging_nodes;
      dealii::DoFTools::make_hanging_node_constraints(dof_handler,
                                                      hanging_nodes);
      hanging_nodes.close();
      for (unsigned int r = 0; r < 3; ++r)
        {
          dealii::Vector<double> integrals(rigid_integrals.col(r).data(),
                                           rigid_integrals.col(r).data() +
                                             dof_handler.n_dofs());
          hanging_nodes.condense(integrals);
          std::copy(integrals.begin(),
                    integrals.end(),
                    rigid_integrals.col(r).data());
        }
    }



    Eigen::MatrixXd
    PinElasticity::normal_compliance(const Eigen::Matrix2Xd &normals,
                                     const RingSymmetry      symmetry) const
    {
      Assert(solver != nullptr, dealii::ExcNotInitialized());
      const Eigen::Index n = nodes.n_nodes();
      AssertDimension(normals.cols(), n);
      const bool         cells_alike = (symmetry == RingSymmetry::cells_alike);
      const Eigen::Index n_columns   = cells_alike ? nodes.degree : n;
      const Eigen::Matrix3d inverse_of_gram =
        (rigid_integrals.transpose() * rigid_fields).inverse();

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
          // In balance the three held degrees of freedom carry nothing, so
          // the forces on them are needed for the balance only.
          forces -= rigid_integrals *
                    (inverse_of_gram * (rigid_fields.transpose() * forces));
          for (const auto dof : held_dofs)
            forces.row(dof).setZero();
          Eigen::MatrixXd displacements = solver->solve(forces);
          displacements -=
            rigid_fields *
            (inverse_of_gram * (rigid_integrals.transpose() * displacements));
          for (Eigen::Index i = 0; i < n; ++i)
            compliance.block(i, first, 1, n_block) =
              normals(0, i) * displacements.row(nodes.x_dofs[i]) +
              normals(1, i) * displacements.row(nodes.y_dofs[i]);
        }
      return symmetric_part(cells_alike ? repeat_around(compliance)
                                        : compliance,
                            "pin");
    }
  } // namespace Elasticity
} // namespace Tribody

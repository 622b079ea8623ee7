// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/filtered_iterator.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/numerics/vector_tools_interpolate.h>

#include <tribody/algebra/linear_solver.h>
#include <tribody/base/inverted_mesh.h>
#include <tribody/base/ranks.h>
#include <tribody/geometry/worn_configuration.h>
#include <tribody/surface/boundary_ids.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <sstream>

namespace Tribody
{
  namespace Geometry
  {
    namespace
    {
      /// The points of two rules; the weights are of no use.
      dealii::Quadrature<2>
      join_points(const dealii::Quadrature<2> &a,
                  const dealii::Quadrature<2> &b)
      {
        auto points = a.get_points();
        points.insert(points.end(),
                      b.get_points().begin(),
                      b.get_points().end());
        return dealii::Quadrature<2>(points);
      }
    } // namespace



    WornConfiguration::WornConfiguration(
      const dealii::Triangulation<2, 2> &triangulation,
      const unsigned int                 degree,
      const std::string                 &bushing_name)
      : name(bushing_name)
      , fe(dealii::FE_Q<2>(degree), 2)
      , dof_handler(triangulation)
    {
      dof_handler.distribute_dofs(fe);
      nodes = make_bore_nodes(dof_handler);

      hanging_nodes.reinit(relevant_dofs(dof_handler));
      dealii::DoFTools::make_hanging_node_constraints(dof_handler,
                                                      hanging_nodes);
      hanging_nodes.close();

      wear                = make_mesh_vector(dof_handler);
      curvature           = make_mesh_vector(dof_handler);
      MeshVector straight = make_mesh_vector(dof_handler);
      dealii::VectorTools::get_position_vector(dealii::MappingQ<2>(degree),
                                               dof_handler,
                                               curvature);
      dealii::VectorTools::get_position_vector(dealii::MappingQ<2>(1),
                                               dof_handler,
                                               straight);
      // Where a fine cell meets a coarse one, its nodes belong on the coarse
      // cell's curved edge.
      hanging_nodes.distribute(curvature);
      curvature -= straight;
      curvature.update_ghost_values();

      wear.update_ghost_values();
      mesh_displacement = curvature;
      worn_mapping = std::make_unique<dealii::MappingQEulerian<2, MeshVector>>(
        degree, dof_handler, mesh_displacement);
      unworn_area_elements = area_elements();
      setup_extension();
    }



    WornConfiguration::~WornConfiguration() = default;



    void
    WornConfiguration::setup_extension()
    {
      // Part of the diffusion that goes in all directions. It is there for
      // meshes with holes, where a ray may end at the rim no more; its square
      // root, in parts of the wall, is how far it spreads what it should not.
      constexpr double sideways = 1e-6;

      fixed_boundary.reinit(relevant_dofs(dof_handler));
      fixed_boundary.merge(hanging_nodes);
      for (const auto id : {BoundaryIds::bore, BoundaryIds::rim})
        dealii::DoFTools::make_zero_boundary_constraints(dof_handler,
                                                         id,
                                                         fixed_boundary);
      fixed_boundary.close();

      for (auto *matrix : {&extension, &constrained_extension})
        reinit_matrix(dof_handler,
                      hanging_nodes,
                      /*keep_constrained_dofs = */ true,
                      *matrix);

      const dealii::MappingQ<2>                    as_manufactured(fe.degree);
      const unsigned int                           n = fe.n_dofs_per_cell();
      dealii::FEValues<2>                          fe_values(as_manufactured,
                                    fe,
                                    dealii::QGauss<2>(fe.degree + 1),
                                    dealii::update_gradients |
                                      dealii::update_quadrature_points |
                                      dealii::update_JxW_values);
      dealii::FullMatrix<double>                   cell_matrix(n, n);
      std::vector<dealii::types::global_dof_index> cell_dofs(n);
      for (const auto &cell : dof_handler.active_cell_iterators() |
                                dealii::IteratorFilters::LocallyOwnedCell())
        {
          fe_values.reinit(cell);
          cell_matrix = 0.;
          for (const unsigned int q : fe_values.quadrature_point_indices())
            {
              const dealii::Tensor<1, 2> x = fe_values.quadrature_point(q);
              const double               r = x.norm();
              const dealii::Tensor<2, 2> K =
                (outer_product(x, x) / (r * r) +
                 sideways * dealii::unit_symmetric_tensor<2>()) /
                r;
              for (unsigned int i = 0; i < n; ++i)
                {
                  const dealii::Tensor<1, 2> flux =
                    K * fe_values.shape_grad(i, q);
                  for (unsigned int j = 0; j < n; ++j)
                    if (fe.system_to_component_index(i).first ==
                        fe.system_to_component_index(j).first)
                      cell_matrix(i, j) +=
                        flux * fe_values.shape_grad(j, q) * fe_values.JxW(q);
                }
            }
          cell->get_dof_indices(cell_dofs);
          hanging_nodes.distribute_local_to_global(cell_matrix,
                                                   cell_dofs,
                                                   extension);
          fixed_boundary.distribute_local_to_global(cell_matrix,
                                                    cell_dofs,
                                                    constrained_extension);
        }
      extension.compress(dealii::VectorOperation::add);
      constrained_extension.compress(dealii::VectorOperation::add);
      solver = make_linear_solver(constrained_extension,
                                  dof_handler,
                                  SlowModes::constants);
    }



    void
    WornConfiguration::update(const Eigen::VectorXd &wear_depth)
    {
      AssertDimension(wear_depth.size(), nodes.n_nodes());
      const MeshVector new_wear         = compute_extension(wear_depth);
      MeshVector       new_displacement = new_wear;
      new_displacement += curvature;
      check_cells(new_displacement, wear_depth.maxCoeff());

      wear = new_wear;
      // The mapping points to this vector.
      mesh_displacement = new_displacement;
      lost_area         = compute_removed_area();
    }



    MeshVector
    WornConfiguration::compute_extension(
      const Eigen::VectorXd &wear_depth) const
    {
      const Eigen::Matrix2Xd moved =
        nodes.radial_directions() * wear_depth.asDiagonal();
      MeshVector at_bore = make_mesh_vector(dof_handler);
      for (Eigen::Index i = 0; i < nodes.n_nodes(); ++i)
        if (at_bore.in_local_range(nodes.x_dofs[i]))
          {
            at_bore[nodes.x_dofs[i]] = moved(0, i);
            at_bore[nodes.y_dofs[i]] = moved(1, i);
          }

      // The bore's share is moved to the right-hand side; hanging nodes have
      // no equation of their own.
      MeshVector right_hand_side = make_mesh_vector(dof_handler);
      extension.vmult(right_hand_side, at_bore);
      right_hand_side *= -1.;
      fixed_boundary.set_zero(right_hand_side);

      const Eigen::VectorXd solution =
        solver->solve(Eigen::Map<const Eigen::VectorXd>(
          right_hand_side.begin(), right_hand_side.locally_owned_size()));
      MeshVector extended = make_mesh_vector(dof_handler);
      std::copy(solution.begin(), solution.end(), extended.begin());
      fixed_boundary.set_zero(extended);
      extended += at_bore;
      hanging_nodes.distribute(extended);
      extended.update_ghost_values();
      return extended;
    }



    WornConfiguration::JacobianRatio
    WornConfiguration::smallest_ratio(const MeshVector &displacement) const
    {
      const JacobianRatio own   = smallest_own_ratio(displacement);
      const MPI_Comm      ranks = dof_handler.get_communicator();
      JacobianRatio       smallest;
      for (const auto &of_rank : dealii::Utilities::MPI::all_gather(
             ranks, std::make_pair(own.value, own.cell_centre)))
        if (std::isnan(of_rank.first))
          return {of_rank.first, of_rank.second};
        else if (of_rank.first < smallest.value)
          smallest = {of_rank.first, of_rank.second};
      return smallest;
    }



    WornConfiguration::JacobianRatio
    WornConfiguration::smallest_own_ratio(const MeshVector &displacement) const
    {
      // The Jacobian of the mapping is that of the straight-sided cell times
      // det(I + grad w), so no mapping has to be inverted to know its sign.
      const dealii::MappingQ<2>   straight_sided(1);
      const dealii::Quadrature<2> points =
        join_points(dealii::QGauss<2>(fe.degree + 1),
                    dealii::QGaussLobatto<2>(fe.degree + 2));
      dealii::FEValues<2>                      fe_values(straight_sided,
                                    fe,
                                    points,
                                    dealii::update_gradients);
      const dealii::FEValuesExtractors::Vector moved(0);
      std::vector<dealii::Tensor<2, 2>>        gradients(points.size());
      const auto    identity = dealii::unit_symmetric_tensor<2>();
      JacobianRatio smallest;
      for (const auto &cell : dof_handler.active_cell_iterators() |
                                dealii::IteratorFilters::LocallyOwnedCell())
        {
          fe_values.reinit(cell);
          fe_values[moved].get_function_gradients(displacement, gradients);
          for (const auto &gradient : gradients)
            {
              const double ratio = dealii::determinant(gradient + identity);
              if (std::isnan(ratio))
                return {ratio, cell->center()};
              if (ratio < smallest.value)
                smallest = {ratio, cell->center()};
            }
        }
      return smallest;
    }



    void
    WornConfiguration::check_cells(const MeshVector &displacement,
                                   const double      max_wear_depth) const
    {
      const JacobianRatio smallest = smallest_ratio(displacement);
      if (smallest.value > 0.)
        return;
      std::ostringstream message;
      message << "Bushing " << name << ": with a wear depth of up to "
              << 1e3 * max_wear_depth
              << " mm the mesh turns inside out in the cell around ("
              << 1e3 * smallest.cell_centre
              << ") mm. Is the bushing worn through?";
      AssertThrow(false, ExcInvertedMesh(message.str()));
    }



    Eigen::Matrix2Xd
    WornConfiguration::worn_positions() const
    {
      Eigen::MatrixXd positions = Eigen::MatrixXd::Zero(2, nodes.n_nodes());
      for (Eigen::Index i = 0; i < nodes.n_nodes(); ++i)
        if (wear.in_local_range(nodes.x_dofs[i]))
          {
            positions(0, i) = nodes.positions(0, i) + wear[nodes.x_dofs[i]];
            positions(1, i) = nodes.positions(1, i) + wear[nodes.y_dofs[i]];
          }
      Ranks::sum(positions, dof_handler.get_communicator());
      return positions;
    }



    std::vector<double>
    WornConfiguration::area_elements() const
    {
      dealii::FEValues<2> fe_values(*worn_mapping,
                                    fe,
                                    dealii::QGauss<2>(fe.degree + 1),
                                    dealii::update_JxW_values);
      std::vector<double> elements;
      for (const auto &cell : dof_handler.active_cell_iterators() |
                                dealii::IteratorFilters::LocallyOwnedCell())
        {
          fe_values.reinit(cell);
          elements.insert(elements.end(),
                          fe_values.get_JxW_values().begin(),
                          fe_values.get_JxW_values().end());
        }
      return elements;
    }



    double
    WornConfiguration::area() const
    {
      const std::vector<double> elements = area_elements();
      return dealii::Utilities::MPI::sum(std::accumulate(elements.begin(),
                                                         elements.end(),
                                                         0.),
                                         dof_handler.get_communicator());
    }



    double
    WornConfiguration::compute_removed_area() const
    {
      return dealii::Utilities::MPI::sum(
        std::inner_product(unworn_area_elements.begin(),
                           unworn_area_elements.end(),
                           area_elements().begin(),
                           0.,
                           std::plus<>(),
                           std::minus<>()),
        dof_handler.get_communicator());
    }
  } // namespace Geometry
} // namespace Tribody

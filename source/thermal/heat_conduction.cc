// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/function.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/numerics/matrix_creator.h>
#include <deal.II/numerics/vector_tools_rhs.h>

#include <tribody/surface/bore_nodes.h>
#include <tribody/surface/boundary_ids.h>
#include <tribody/thermal/heat_conduction.h>

#include <cmath>
#include <map>

namespace Tribody
{
  namespace Thermal
  {
    using dealii::types::global_dof_index;

    namespace
    {
      // Of a scalar field, in the order of BoreNodes, which know the degrees of
      // freedom of a vector-valued one on the same cells.
      std::vector<global_dof_index>
      find_bore_dofs(const dealii::DoFHandler<2> &scalar)
      {
        const dealii::FESystem<2> vector_fe(scalar.get_fe(), 2);
        dealii::DoFHandler<2>     vectors(scalar.get_triangulation());
        vectors.distribute_dofs(vector_fe);
        const BoreNodes nodes = make_bore_nodes(vectors);

        std::map<global_dof_index, global_dof_index> scalar_of_x;
        std::vector<global_dof_index> dofs(scalar.get_fe().n_dofs_per_cell());
        std::vector<global_dof_index> vector_dofs(vector_fe.n_dofs_per_cell());
        for (const auto &cell : vectors.active_cell_iterators())
          {
            cell->get_dof_indices(vector_dofs);
            const dealii::DoFHandler<2>::active_cell_iterator same_cell(
              &scalar.get_triangulation(),
              cell->level(),
              cell->index(),
              &scalar);
            same_cell->get_dof_indices(dofs);
            for (unsigned int k = 0; k < vector_dofs.size(); ++k)
              {
                const auto [component, node] =
                  vector_fe.system_to_component_index(k);
                if (component == 0)
                  scalar_of_x[vector_dofs[k]] = dofs[node];
              }
          }
        std::vector<global_dof_index> bore_dofs;
        for (const global_dof_index x : nodes.x_dofs)
          bore_dofs.push_back(scalar_of_x.at(x));
        return bore_dofs;
      }



      // The part of the rim, per coefficient.
      void
      add_rim(const dealii::Mapping<2>                &mapping,
              const dealii::DoFHandler<2>             &dof_handler,
              const dealii::AffineConstraints<double> &constraints,
              const double                             coefficient,
              dealii::SparseMatrix<double>            &matrix)
      {
        const auto                   &fe = dof_handler.get_fe();
        const unsigned int            n  = fe.n_dofs_per_cell();
        dealii::FEFaceValues<2>       fe_values(mapping,
                                          fe,
                                          dealii::QGauss<1>(fe.degree + 1),
                                          dealii::update_values |
                                            dealii::update_JxW_values);
        dealii::FullMatrix<double>    cell_matrix(n, n);
        std::vector<global_dof_index> dofs(n);
        for (const auto &cell : dof_handler.active_cell_iterators())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && face->boundary_id() == BoundaryIds::rim)
              {
                fe_values.reinit(cell, face);
                cell_matrix = 0.;
                for (const unsigned int q :
                     fe_values.quadrature_point_indices())
                  for (unsigned int i = 0; i < n; ++i)
                    for (unsigned int j = 0; j < n; ++j)
                      cell_matrix(i, j) +=
                        coefficient * fe_values.shape_value(i, q) *
                        fe_values.shape_value(j, q) * fe_values.JxW(q);
                cell->get_dof_indices(dofs);
                constraints.distribute_local_to_global(cell_matrix,
                                                       dofs,
                                                       matrix);
              }
      }
    } // namespace



    double
    rim_length(const dealii::Triangulation<2> &triangulation,
               const unsigned int              degree)
    {
      const dealii::MappingQ<2> mapping(degree);
      const dealii::FE_Q<2>     fe(degree);
      dealii::FEFaceValues<2>   fe_values(mapping,
                                        fe,
                                        dealii::QGauss<1>(degree + 1),
                                        dealii::update_JxW_values);
      double                    length = 0.;
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == BoundaryIds::rim)
            {
              fe_values.reinit(cell, face);
              for (const unsigned int q : fe_values.quadrature_point_indices())
                length += fe_values.JxW(q);
            }
      return length;
    }



    HeatConduction::HeatConduction(
      const dealii::Triangulation<2> &triangulation,
      const unsigned int              degree,
      const double                    conductivity,
      const double                    heat_transfer_coefficient)
      : fe(degree)
      , dof_handler(triangulation)
      , conductivity(conductivity)
      , heat_transfer_coefficient(heat_transfer_coefficient)
    {
      dof_handler.distribute_dofs(fe);
      bore_dofs = find_bore_dofs(dof_handler);
      dealii::DoFTools::make_hanging_node_constraints(dof_handler, constraints);
      if (std::isinf(heat_transfer_coefficient))
        dealii::DoFTools::make_zero_boundary_constraints(dof_handler,
                                                         BoundaryIds::rim,
                                                         constraints);
      constraints.close();
      dealii::DynamicSparsityPattern entries(dof_handler.n_dofs());
      dealii::DoFTools::make_sparsity_pattern(dof_handler,
                                              entries,
                                              constraints,
                                              /*keep_constrained_dofs = */
                                              false);
      sparsity.copy_from(entries);
    }



    void
    HeatConduction::reinit(const dealii::Mapping<2> &mapping)
    {
      const dealii::QGauss<2>                      quadrature(fe.degree + 1);
      const dealii::Functions::ConstantFunction<2> lambda(conductivity);
      matrix.reinit(sparsity);
      dealii::MatrixCreator::create_laplace_matrix(
        mapping, dof_handler, quadrature, matrix, &lambda, constraints);
      if (std::isfinite(heat_transfer_coefficient))
        add_rim(
          mapping, dof_handler, constraints, heat_transfer_coefficient, matrix);
      solver.initialize(matrix);

      averages.reinit(dof_handler.n_dofs());
      dealii::VectorTools::create_right_hand_side(
        mapping,
        dof_handler,
        quadrature,
        dealii::Functions::ConstantFunction<2>(1.),
        averages);
      averages /= averages.mean_value() * averages.size();
    }



    TemperatureRise
    HeatConduction::solve(const Eigen::VectorXd &nodal_heat) const
    {
      AssertDimension(static_cast<std::size_t>(nodal_heat.size()),
                      bore_dofs.size());
      // Hanging nodes are never bore nodes.
      TemperatureRise rise;
      rise.field.reinit(dof_handler.n_dofs());
      for (Eigen::Index i = 0; i < nodal_heat.size(); ++i)
        rise.field[bore_dofs[i]] = nodal_heat[i];
      solver.solve(rise.field);
      constraints.distribute(rise.field);

      rise.at_bore.resize(nodal_heat.size());
      for (Eigen::Index i = 0; i < nodal_heat.size(); ++i)
        rise.at_bore[i] = rise.field[bore_dofs[i]];
      rise.mean = averages * rise.field;
      return rise;
    }



    TemperatureRise
    HeatConduction::uniform(const double rise) const
    {
      TemperatureRise result;
      result.field.reinit(dof_handler.n_dofs());
      result.field = rise;
      result.at_bore =
        Eigen::VectorXd::Constant(static_cast<Eigen::Index>(bore_dofs.size()),
                                  rise);
      result.mean = rise;
      return result;
    }
  } // namespace Thermal
} // namespace Tribody

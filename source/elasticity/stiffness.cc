// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_dgp.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/grid/filtered_iterator.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <tribody/elasticity/stiffness.h>

namespace Tribody
{
  namespace Elasticity
  {
    namespace
    {
      /// Add the part of the change of volume: its projection on the
      /// polynomials of @p pressures.
      void
      add_volumetric_part(const dealii::FEValues<2>  &fe_values,
                          const dealii::FE_DGP<2>    &pressures,
                          const double                lambda,
                          dealii::FullMatrix<double> &cell_matrix)
      {
        const auto        &fe = fe_values.get_fe();
        const unsigned int n  = fe.n_dofs_per_cell();
        const unsigned int m  = pressures.n_dofs_per_cell();

        dealii::FullMatrix<double> mass(m, m), divergence(m, n);
        for (const unsigned int q : fe_values.quadrature_point_indices())
          {
            const auto &point = fe_values.get_quadrature().point(q);
            for (unsigned int a = 0; a < m; ++a)
              {
                const double weighted =
                  pressures.shape_value(a, point) * fe_values.JxW(q);
                for (unsigned int b = 0; b < m; ++b)
                  mass(a, b) += weighted * pressures.shape_value(b, point);
                for (unsigned int i = 0; i < n; ++i)
                  divergence(a, i) +=
                    weighted * fe_values.shape_grad(
                                 i, q)[fe.system_to_component_index(i).first];
              }
          }
        mass.gauss_jordan();
        cell_matrix.triple_product(
          mass, divergence, divergence, true, false, lambda);
      }



      /// The stiffness of one cell; the element's basis is scalar times unit
      /// vector, so that every strain has one row of the gradient only.
      void
      compute_cell_matrix(const dealii::FEValues<2>  &fe_values,
                          const dealii::FE_DGP<2>    &pressures,
                          const PlaneHooke           &law,
                          dealii::FullMatrix<double> &cell_matrix)
      {
        // In plane strain above a Poisson's ratio of 0.49. Below, elements with
        // the whole change of volume are as exact as these or more.
        const bool         locks = law.lambda > 49. * law.mu;
        const auto        &fe    = fe_values.get_fe();
        const unsigned int n     = fe.n_dofs_per_cell();
        cell_matrix              = 0.;
        for (const unsigned int q : fe_values.quadrature_point_indices())
          for (unsigned int i = 0; i < n; ++i)
            {
              const unsigned int c = fe.system_to_component_index(i).first;
              const auto grad_i = fe_values.shape_grad(i, q) * fe_values.JxW(q);
              for (unsigned int j = 0; j <= i; ++j)
                {
                  const unsigned int d = fe.system_to_component_index(j).first;
                  const auto        &grad_j = fe_values.shape_grad(j, q);
                  cell_matrix(i, j) +=
                    (locks ? 0. : law.lambda) * grad_i[c] * grad_j[d] +
                    law.mu * grad_i[d] * grad_j[c];
                  if (c == d)
                    cell_matrix(i, j) += law.mu * (grad_i * grad_j);
                }
            }
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < i; ++j)
            cell_matrix(j, i) = cell_matrix(i, j);
        if (locks)
          add_volumetric_part(fe_values, pressures, law.lambda, cell_matrix);
      }



      /// The values at the quadrature points of the polynomial of the element
      /// @p polynomials that is nearest to @p values there.
      std::vector<double>
      project(const dealii::FEValues<2> &fe_values,
              const dealii::FE_DGP<2>   &polynomials,
              const std::vector<double> &values)
      {
        const unsigned int         m = polynomials.n_dofs_per_cell();
        dealii::FullMatrix<double> mass(m, m);
        dealii::Vector<double>     moments(m), coefficients(m);
        for (const unsigned int q : fe_values.quadrature_point_indices())
          {
            const auto &point = fe_values.get_quadrature().point(q);
            for (unsigned int a = 0; a < m; ++a)
              {
                const double weighted =
                  polynomials.shape_value(a, point) * fe_values.JxW(q);
                moments(a) += weighted * values[q];
                for (unsigned int b = 0; b < m; ++b)
                  mass(a, b) += weighted * polynomials.shape_value(b, point);
              }
          }
        mass.gauss_jordan();
        mass.vmult(coefficients, moments);
        std::vector<double> projected(values.size(), 0.);
        for (const unsigned int q : fe_values.quadrature_point_indices())
          for (unsigned int a = 0; a < m; ++a)
            projected[q] +=
              coefficients(a) *
              polynomials.shape_value(a, fe_values.get_quadrature().point(q));
        return projected;
      }
    } // namespace



    void
    assemble_stiffness(const dealii::Mapping<2, 2>             &mapping,
                       const dealii::DoFHandler<2, 2>          &dof_handler,
                       const dealii::AffineConstraints<double> &constraints,
                       const PlaneHooke                        &law,
                       dealii::TrilinosWrappers::SparseMatrix  &matrix)
    {
      matrix         = 0.;
      const auto &fe = dof_handler.get_fe();
      // One order more than affine cells need: the cells at the bore are
      // curved.
      const dealii::QGauss<2>    quadrature(fe.degree + 1);
      const dealii::FE_DGP<2>    pressures(fe.degree - 1);
      dealii::FEValues<2>        fe_values(mapping,
                                    fe,
                                    quadrature,
                                    dealii::update_gradients |
                                      dealii::update_JxW_values);
      dealii::FullMatrix<double> cell_matrix(fe.n_dofs_per_cell(),
                                             fe.n_dofs_per_cell());
      std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
      for (const auto &cell : dof_handler.active_cell_iterators() |
                                dealii::IteratorFilters::LocallyOwnedCell())
        {
          fe_values.reinit(cell);
          compute_cell_matrix(fe_values, pressures, law, cell_matrix);
          cell->get_dof_indices(dofs);
          constraints.distribute_local_to_global(cell_matrix, dofs, matrix);
        }
      matrix.compress(dealii::VectorOperation::add);
    }



    dealii::Vector<double>
    compute_thermal_forces(const dealii::Mapping<2, 2>             &mapping,
                           const dealii::DoFHandler<2, 2>          &dof_handler,
                           const dealii::AffineConstraints<double> &constraints,
                           const PlaneHooke                        &law,
                           const dealii::DoFHandler<2, 2> &temperatures,
                           const dealii::Vector<double>   &rise,
                           const double                    expansion)
    {
      const double stress_per_strain =
        2. * (law.lambda + law.mu) * (1. + law.axial_ratio);

      const auto             &fe = dof_handler.get_fe();
      const dealii::QGauss<2> quadrature(fe.degree + 1);
      const dealii::FE_DGP<2> polynomials(fe.degree - 1);
      dealii::FEValues<2>     fe_values(mapping,
                                    fe,
                                    quadrature,
                                    dealii::update_gradients |
                                      dealii::update_JxW_values);
      dealii::FEValues<2>     temperature_values(mapping,
                                             temperatures.get_fe(),
                                             quadrature,
                                             dealii::update_values);
      std::vector<double>     rise_in_cell(quadrature.size());
      dealii::Vector<double>  forces(dof_handler.n_dofs());
      dealii::Vector<double>  cell_forces(fe.n_dofs_per_cell());
      std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
      for (const auto &cell : dof_handler.active_cell_iterators())
        {
          fe_values.reinit(cell);
          const dealii::DoFHandler<2>::active_cell_iterator same_cell(
            &temperatures.get_triangulation(),
            cell->level(),
            cell->index(),
            &temperatures);
          temperature_values.reinit(same_cell);
          temperature_values.get_function_values(rise, rise_in_cell);
          const std::vector<double> projected =
            project(fe_values, polynomials, rise_in_cell);
          cell_forces = 0.;
          for (const unsigned int q : fe_values.quadrature_point_indices())
            for (unsigned int i = 0; i < cell_forces.size(); ++i)
              cell_forces(i) +=
                stress_per_strain * expansion * projected[q] *
                fe_values.shape_grad(i,
                                     q)[fe.system_to_component_index(i).first] *
                fe_values.JxW(q);
          cell->get_dof_indices(dofs);
          constraints.distribute_local_to_global(cell_forces, dofs, forces);
        }
      return forces;
    }
  } // namespace Elasticity
} // namespace Tribody

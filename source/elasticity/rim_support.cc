// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/grid/filtered_iterator.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/elasticity/rim_support.h>
#include <tribody/surface/bore_nodes.h>
#include <tribody/surface/boundary_ids.h>

#include <cmath>

namespace Tribody
{
  namespace Elasticity
  {
    void
    RimSupport::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_choice(
        prm,
        "Outer support",
        kind,
        "What holds the bushing at its rim. clamped: a rigid seat that it is "
        "bonded to; elastic foundation: springs spread over the rim, for a "
        "soft seat; housing: a free ring that lies in a rigid, round and "
        "smooth bore, with a gap, and presses on it where it touches. Keys "
        "that carry no radial force keep the ring from turning; it has no "
        "inertia of its own.");
      Parameters::add_quantity(
        prm,
        "Foundation normal stiffness",
        normal_stiffness,
        "N/m^3",
        "k_n of 'elastic foundation': pressure on the rim over its "
        "displacement, positive. A layer of thickness h that is bonded to the "
        "rim has E (1-nu)/((1+nu)(1-2 nu) h).");
      Parameters::add_quantity(
        prm,
        "Foundation tangential stiffness",
        tangential_stiffness,
        "N/m^3",
        "k_t of 'elastic foundation': shear stress on the rim over its "
        "displacement along the rim; 0 takes that of the normal. A layer of "
        "thickness h has E/(2 (1+nu) h).");
      Parameters::add_quantity(
        prm,
        "Housing gap",
        housing_gap,
        "m",
        "g of 'housing': its radius less that of the rim, not negative. The "
        "dynamics sees a clearance that is wider by as much.",
        "um");
    }



    void
    RimSupport::check(const std::string &path) const
    {
      AssertThrow(
        kind != Kind::elastic_foundation || normal_stiffness > 0.,
        ExcParameter(path + "/Foundation normal stiffness",
                     Units::to_string(normal_stiffness, "N/m^3", "N/m^3") +
                       " must be positive if 'Outer support' is "
                       "'elastic foundation'"));
      AssertThrow(
        tangential_stiffness >= 0.,
        ExcParameter(path + "/Foundation tangential stiffness",
                     Units::to_string(tangential_stiffness, "N/m^3", "N/m^3") +
                       " must be positive, or 0 for that of the "
                       "normal"));
      AssertThrow(housing_gap >= 0.,
                  ExcParameter(path + "/Housing gap",
                               Units::to_string(housing_gap, "m", "um") +
                                 " must not be negative; 0 is a ring that fits "
                                 "its housing"));
      AssertThrow(
        is_housing() || housing_gap == 0.,
        ExcParameter(path + "/Housing gap",
                     Units::to_string(housing_gap, "m", "um") +
                       " has a meaning with 'Outer support = housing' "
                       "only, but that is '" +
                       name_of(kind) + "'"));
    }



    void
    assemble_foundation(const dealii::Mapping<2, 2>             &mapping,
                        const dealii::DoFHandler<2, 2>          &dof_handler,
                        const dealii::AffineConstraints<double> &constraints,
                        const RimSupport                        &support,
                        dealii::TrilinosWrappers::SparseMatrix  &matrix)
    {
      const double k_n = support.normal_stiffness;
      const double k_t =
        support.tangential_stiffness > 0. ? support.tangential_stiffness : k_n;

      const auto                                  &fe = dof_handler.get_fe();
      const unsigned int                           n  = fe.n_dofs_per_cell();
      dealii::FEFaceValues<2>                      fe_values(mapping,
                                        fe,
                                        dealii::QGauss<1>(fe.degree + 1),
                                        dealii::update_values |
                                          dealii::update_normal_vectors |
                                          dealii::update_JxW_values);
      dealii::FullMatrix<double>                   cell_matrix(n, n);
      std::vector<dealii::types::global_dof_index> dofs(n);
      for (const auto &cell : dof_handler.active_cell_iterators() |
                                dealii::IteratorFilters::LocallyOwnedCell())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == BoundaryIds::rim)
            {
              fe_values.reinit(cell, face);
              cell_matrix = 0.;
              for (const unsigned int q : fe_values.quadrature_point_indices())
                {
                  const auto normal = fe_values.normal_vector(q);
                  for (unsigned int i = 0; i < n; ++i)
                    for (unsigned int j = 0; j < n; ++j)
                      {
                        const unsigned int c =
                          fe.system_to_component_index(i).first;
                        const unsigned int d =
                          fe.system_to_component_index(j).first;
                        const double along_normal = normal[c] * normal[d];
                        const double stiffness =
                          k_n * along_normal +
                          k_t * ((c == d ? 1. : 0.) - along_normal);
                        cell_matrix(i, j) +=
                          stiffness * fe_values.shape_value(i, q) *
                          fe_values.shape_value(j, q) * fe_values.JxW(q);
                      }
                }
              cell->get_dof_indices(dofs);
              constraints.distribute_local_to_global(cell_matrix, dofs, matrix);
            }
      matrix.compress(dealii::VectorOperation::add);
    }



    void
    assemble_keys(const BoreNodes                        &rim,
                  const double                            stiffness,
                  dealii::TrilinosWrappers::SparseMatrix &matrix)
    {
      for (Eigen::Index k = 0; k < 3; ++k)
        {
          const Eigen::Index    i = k * rim.n_nodes() / 3;
          const Eigen::Vector2d t(-std::sin(rim.angles[i]),
                                  std::cos(rim.angles[i]));
          const auto            x = rim.x_dofs[i], y = rim.y_dofs[i];
          matrix.add(x, x, stiffness * t[0] * t[0]);
          matrix.add(x, y, stiffness * t[0] * t[1]);
          matrix.add(y, x, stiffness * t[1] * t[0]);
          matrix.add(y, y, stiffness * t[1] * t[1]);
        }
      matrix.compress(dealii::VectorOperation::add);
    }
  } // namespace Elasticity
} // namespace Tribody

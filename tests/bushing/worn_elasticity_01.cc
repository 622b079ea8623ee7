// SPDX-License-Identifier: LGPL-2.1-or-later

// Elasticity on the worn mapping of a distorted, locally refined mesh.
//
// Patch test: under a displacement that is linear in space all stresses are
// constant, so no forces remain inside: to rounding, for every degree.
//
// Manufactured solution u = (sin sx cos sy, c cos sx sin sy)/s, with the body
// force that Hooke's law wants for it and its values on both boundaries: the L2
// error falls at the rate degree + 1 on a ring that is worn all around,
// h = d cos^2(t/2).
//
// Pressurised ring (Lame): worn by the same depth h all around, the bushing is
// a ring of the bore radius a + h with u = A r + B/r, u(b) = 0 and sigma_r(a +
// h) = -p. Mapping, elements, and the pressure's nodal forces on the worn bore
// curve together must converge to it at the rate degree + 1.

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/numerics/vector_tools.h>

#include <tribody/algebra/direct_solver.h>
#include <tribody/elasticity/bushing_elasticity.h>
#include <tribody/elasticity/ring_mesh.h>
#include <tribody/elasticity/stiffness.h>
#include <tribody/geometry/worn_configuration.h>
#include <tribody/surface/bore_surface.h>
#include <tribody/surface/boundary_ids.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace Tribody;

constexpr double a = 9.535e-3, b = 15.875e-3;

const Material               material{"PTFE", 0.139e9, 0.38, 2160.};
const Elasticity::PlaneHooke law(material, Elasticity::PlaneState::strain);

class Manufactured : public dealii::Function<2>
{
public:
  Manufactured()
    : dealii::Function<2>(2)
  {}

  double
  value(const dealii::Point<2> &x, const unsigned int component) const override
  {
    return (component == 0 ? std::sin(s * x[0]) * std::cos(s * x[1])
                           : c * std::cos(s * x[0]) * std::sin(s * x[1])) /
           s;
  }

  /// -div sigma(u) by Hooke's law.
  dealii::Tensor<1, 2>
  body_force(const dealii::Point<2> &x) const
  {
    const double         gradient = (law.lambda + law.mu) * (1. + c) * s;
    dealii::Tensor<1, 2> f;
    f[0] =
      (gradient + 2. * law.mu * s) * std::sin(s * x[0]) * std::cos(s * x[1]);
    f[1] = (gradient + 2. * law.mu * c * s) * std::cos(s * x[0]) *
           std::sin(s * x[1]);
    return f;
  }

private:
  static constexpr double s = 250., c = 0.4;
};

class Linear : public dealii::Function<2>
{
public:
  Linear()
    : dealii::Function<2>(2)
  {}

  double
  value(const dealii::Point<2> &x, const unsigned int component) const override
  {
    return component == 0 ? 0.3 * x[0] - 0.7 * x[1] + 1e-3
                          : 0.4 * x[0] + 0.2 * x[1] - 2e-3;
  }
};

/// Stiffness on a worn mapping.
struct WornRing
{
  WornRing(const unsigned int n,
           const unsigned int degree,
           const bool         distorted)
  {
    Elasticity::RingMeshParameters mesh;
    mesh.n_bore_cells   = n;
    mesh.n_radial_cells = n / 8;
    mesh.grading        = 1.;
    Elasticity::make_ring_mesh(mesh, a, b, triangulation);
    if (distorted)
      {
        dealii::GridTools::distort_random(0.15,
                                          triangulation,
                                          /*keep_boundary = */ true,
                                          /*seed = */ 7);
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->center()[0] > 0.9 * a)
            cell->set_refine_flag();
        triangulation.execute_coarsening_and_refinement();
      }
    worn = std::make_unique<Geometry::WornConfiguration>(triangulation,
                                                         degree,
                                                         "ring");
    worn->update(1e-3 *
                 (0.5 * worn->bore_nodes().angles.array()).cos().square());

    dof_handler = &worn->get_dof_handler();
    dealii::DoFTools::make_hanging_node_constraints(*dof_handler,
                                                    hanging_nodes);
    hanging_nodes.close();
    fixed.merge(hanging_nodes);
    for (const auto id : {BoundaryIds::bore, BoundaryIds::rim})
      dealii::DoFTools::make_zero_boundary_constraints(*dof_handler, id, fixed);
    fixed.close();
    assemble(hanging_nodes, free_matrix);
    assemble(fixed, fixed_matrix);
  }

  void
  assemble(const dealii::AffineConstraints<double> &constraints,
           dealii::TrilinosWrappers::SparseMatrix  &matrix) const
  {
    dealii::DynamicSparsityPattern sparsity(dof_handler->n_dofs());
    dealii::DoFTools::make_sparsity_pattern(*dof_handler,
                                            sparsity,
                                            constraints);
    matrix.reinit(dof_handler->locally_owned_dofs(), sparsity, MPI_COMM_SELF);
    Elasticity::assemble_stiffness(
      worn->mapping(), *dof_handler, constraints, law, matrix);
  }

  dealii::Vector<double>
  interpolate(const dealii::Function<2> &function) const
  {
    dealii::Vector<double> values(dof_handler->n_dofs());
    dealii::VectorTools::interpolate(worn->mapping(),
                                     *dof_handler,
                                     function,
                                     values);
    return values;
  }

  dealii::Triangulation<2>                     triangulation;
  std::unique_ptr<Geometry::WornConfiguration> worn;
  const dealii::DoFHandler<2>                 *dof_handler;
  dealii::AffineConstraints<double>            hanging_nodes, fixed;
  dealii::TrilinosWrappers::SparseMatrix       free_matrix, fixed_matrix;
};

void
check_patch(const unsigned int degree)
{
  const WornRing         ring(24, degree, true);
  dealii::Vector<double> u = ring.interpolate(Linear());
  // Rows of hanging nodes are no equations.
  ring.hanging_nodes.set_zero(u);
  dealii::Vector<double> forces(u.size());
  ring.free_matrix.vmult(forces, u);
  const double at_boundary = forces.linfty_norm();
  ring.fixed.set_zero(forces);
  std::cout << "degree " << degree << ": patch test, " << u.size()
            << " unknowns, forces inside below 1e-12 of those outside "
            << (forces.linfty_norm() < 1e-12 * at_boundary) << std::endl;
}

double
manufactured_error(const unsigned int n, const unsigned int degree)
{
  const WornRing          ring(n, degree, false);
  const Manufactured      exact;
  const dealii::QGauss<2> quadrature(degree + 3);
  const auto             &fe = ring.dof_handler->get_fe();
  dealii::FEValues<2>     fe_values(ring.worn->mapping(),
                                fe,
                                quadrature,
                                dealii::update_values |
                                  dealii::update_quadrature_points |
                                  dealii::update_JxW_values);
  dealii::Vector<double>  right_hand_side(ring.dof_handler->n_dofs());
  std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
  for (const auto &cell : ring.dof_handler->active_cell_iterators())
    {
      fe_values.reinit(cell);
      cell->get_dof_indices(dofs);
      for (const unsigned int q : fe_values.quadrature_point_indices())
        {
          const auto f = exact.body_force(fe_values.quadrature_point(q));
          for (unsigned int i = 0; i < dofs.size(); ++i)
            right_hand_side[dofs[i]] +=
              f[fe.system_to_component_index(i).first] *
              fe_values.shape_value(i, q) * fe_values.JxW(q);
        }
    }
  // The boundary's values go to the right-hand side.
  dealii::Vector<double> at_boundary = ring.interpolate(exact);
  dealii::Vector<double> inside(at_boundary);
  ring.fixed.set_zero(inside);
  at_boundary -= inside;
  dealii::Vector<double> forces(right_hand_side.size());
  ring.free_matrix.vmult(forces, at_boundary);
  right_hand_side -= forces;
  ring.fixed.set_zero(right_hand_side);
  dealii::Vector<double> u =
    DirectSolver(ring.fixed_matrix).solve(right_hand_side);
  u += at_boundary;

  dealii::Vector<double> errors(ring.triangulation.n_active_cells());
  dealii::VectorTools::integrate_difference(ring.worn->mapping(),
                                            *ring.dof_handler,
                                            u,
                                            exact,
                                            errors,
                                            quadrature,
                                            dealii::VectorTools::L2_norm);
  return errors.l2_norm();
}

/// A ring under a pressure [Pa] in its bore of radius @p inner, clamped at b.
class Lame : public dealii::Function<2>
{
public:
  explicit Lame(const double inner)
    : dealii::Function<2>(2)
    // sigma_r = 2 (lambda + mu) A - 2 mu B/r^2, B = -A b^2
    , A(-pressure /
        (2. * (law.lambda + law.mu) + 2. * law.mu * b * b / (inner * inner)))
  {}

  double
  value(const dealii::Point<2> &x, const unsigned int component) const override
  {
    return A * (1. - b * b / x.norm_square()) * x[component];
  }

  static constexpr double pressure = 1e6;

private:
  const double A;
};

double
lame_error(const unsigned int n, const unsigned int degree)
{
  constexpr double               depth = 2e-3;
  Elasticity::RingMeshParameters mesh;
  mesh.n_bore_cells   = n;
  mesh.n_radial_cells = n / 8;
  mesh.grading        = 1.;
  dealii::Triangulation<2> triangulation;
  Elasticity::make_ring_mesh(mesh, a, b, triangulation);
  Geometry::WornConfiguration worn(triangulation, degree, "ring");
  worn.update(
    Eigen::VectorXd::Constant(worn.bore_nodes().angles.size(), depth));

  Elasticity::BushingElasticity elasticity(triangulation,
                                           degree,
                                           material,
                                           Elasticity::PlaneState::strain);
  elasticity.reinit(worn.mapping());
  const BoreSurface surface = make_bore_surface(worn.worn_positions(), degree);
  const auto u = elasticity.solve(Lame::pressure * surface.vector_weights);

  dealii::Vector<double> errors(triangulation.n_active_cells());
  dealii::VectorTools::integrate_difference(worn.mapping(),
                                            elasticity.get_dof_handler(),
                                            u,
                                            Lame(a + depth),
                                            errors,
                                            dealii::QGauss<2>(degree + 3),
                                            dealii::VectorTools::L2_norm);
  return errors.l2_norm();
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::fixed << std::setprecision(2);
  for (unsigned int degree = 1; degree <= 3; ++degree)
    check_patch(degree);
  for (unsigned int degree = 1; degree <= 3; ++degree)
    std::cout << "degree " << degree << ": manufactured solution, rate "
              << std::log2(manufactured_error(48, degree) /
                           manufactured_error(96, degree))
              << std::endl;
  for (unsigned int degree = 1; degree <= 3; ++degree)
    std::cout << "degree " << degree << ": pressurised worn ring, rate "
              << std::log2(lame_error(24, degree) / lame_error(48, degree))
              << std::endl;
}

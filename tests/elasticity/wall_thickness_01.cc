// SPDX-License-Identifier: LGPL-2.1-or-later

// The wall around a bore, along each ray. Known: that of a ring is even; an
// off-centre rim of radius b has the wall e cos f + sqrt(b^2 - e^2 sin^2 f) -
// a; a square the one to its nearest side; and where a rim has a step, as that
// of a bushing in a block, the wall beside it is what it is elsewhere, not what
// a curve through all its vertices would make of it.

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <tribody/elasticity/rim_shape.h>
#include <tribody/elasticity/ring_mesh.h>
#include <tribody/surface/boundary_ids.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <set>

using namespace Tribody;
using namespace Tribody::Elasticity;

namespace
{
  constexpr double a = 10., degree = dealii::numbers::PI / 180.;

  void
  mark_boundary(dealii::Triangulation<2> &triangulation, const double radius)
  {
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          face->set_boundary_id(
            std::max(face->vertex(0).norm(), face->vertex(1).norm()) <
                1.001 * radius
              ? BoundaryIds::bore
              : BoundaryIds::rim);
  }



  void
  compare(const std::string                         &name,
          const dealii::Triangulation<2>            &triangulation,
          const double                               radius,
          const Eigen::VectorXd                     &angles,
          const std::function<double(const double)> &known,
          const double                               tolerance)
  {
    const Eigen::VectorXd wall  = wall_thickness(triangulation, radius, angles);
    const Eigen::VectorXd exact = angles.unaryExpr(known);
    std::cout << name << ": as known "
              << ((wall - exact).lpNorm<Eigen::Infinity>() < tolerance * radius)
              << std::endl;
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const auto                               angles =
    Eigen::VectorXd::LinSpaced(1001, -180. * degree, 180. * degree).eval();

  {
    dealii::Triangulation<2> ring;
    make_ring_mesh({36, 4, 1.}, a, 12., ring);
    compare(
      "ring", ring, a, angles, [](const double) { return 2.; }, 1e-12);
  }
  {
    constexpr double e = 0.5, b = 12.;
    RimShape         shape;
    shape.centre = dealii::Point<2>(e, 0.);
    dealii::Triangulation<2> off_centre;
    make_ring_mesh({72, 4, 1.}, a, b, shape, off_centre);
    compare(
      "off-centre",
      off_centre,
      a,
      angles,
      [](const double f) {
        return e * std::cos(f) +
               std::sqrt(b * b - std::pow(e * std::sin(f), 2)) - a;
      },
      1e-5);
  }
  {
    dealii::Triangulation<2> square;
    dealii::GridGenerator::hyper_cube_with_cylindrical_hole(square, 0.5, 1.);
    square.refine_global(3);
    mark_boundary(square, 0.5);
    compare(
      "square",
      square,
      0.5,
      angles,
      [](const double f) {
        return 1. / std::max(std::abs(std::cos(f)), std::abs(std::sin(f))) -
               0.5;
      },
      1e-3);
  }
  {
    // Vertices at every fifth degree; the outer layer of two is on the right
    // only.
    dealii::Triangulation<2> ring, stepped;
    dealii::GridGenerator::hyper_shell(ring, dealii::Point<2>(), a, 14., 36);
    ring.refine_global(1);
    std::set<dealii::Triangulation<2>::active_cell_iterator> outer_left;
    for (const auto &cell : ring.active_cell_iterators())
      if (cell->center().norm() > 12. && cell->center()[0] < 0.)
        outer_left.insert(cell);
    dealii::GridGenerator::create_triangulation_with_removed_cells(ring,
                                                                   outer_left,
                                                                   stepped);
    mark_boundary(stepped, a);
    const Eigen::VectorXd at_vertices =
      Eigen::VectorXd::LinSpaced(72, -175. * degree, 180. * degree);
    compare(
      "step",
      stepped,
      a,
      at_vertices,
      [](const double f) { return std::abs(f) < 89. * degree ? 4. : 2.; },
      1e-9);
  }
}

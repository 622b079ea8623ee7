// SPDX-License-Identifier: LGPL-2.1-or-later

// The worn bushing. Known:
// - without wear, nodes of bore and rim lie on their circles for every degree
//   (a mapping that only displaces straight-sided cells leaves the nodes inside
//   the edges 20 um off on this mesh; see the design notes, trap 1);
// - the bore follows a prescribed wear depth, the rim stays;
// - what is gone from the ring is what the bore curve has gained in area: both
//   integrate the same polynomials exactly; also with hanging nodes;
// - a uniform depth h extends as w = h (b - r)/(b - a) e_r, up to the part of
// the
//   diffusion that is not along rays (1e-6): rates p + 1 in L2 before that
//   shows;
// - returning to zero leaves no trace;
// - more wear than wall is refused, and the shape stays what it was.

#include <deal.II/base/function.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>
#include <deal.II/numerics/vector_tools_integrate_difference.h>

#include <tribody/base/exceptions.h>
#include <tribody/geometry/worn_configuration.h>
#include <tribody/surface/bore_surface.h>
#include <tribody/surface/boundary_ids.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace Tribody;
using Tribody::Geometry::WornConfiguration;

constexpr double a = 9.535e-3, b = 15.875e-3;

void
make_ring(dealii::Triangulation<2> &triangulation, const unsigned int n)
{
  dealii::GridGenerator::concentric_hyper_shells(
    triangulation, dealii::Point<2>(), a, b, n / 12, 1., n, true);
}

/// The largest distance of the nodes on the boundary @p id from @p radius.
double
off_circle(const WornConfiguration         &configuration,
           const dealii::types::boundary_id id,
           const double                     radius)
{
  const auto                 &fe = configuration.get_dof_handler().get_fe();
  const dealii::Quadrature<1> nodes(fe.get_unit_face_support_points());
  dealii::FEFaceValues<2>     fe_values(configuration.mapping(),
                                    fe,
                                    nodes,
                                    dealii::update_quadrature_points);
  double                      distance = 0.;
  for (const auto &cell :
       configuration.get_dof_handler().active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && face->boundary_id() == id)
        {
          fe_values.reinit(cell, face);
          for (const auto &x : fe_values.get_quadrature_points())
            distance = std::max(distance, std::abs(x.norm() - radius));
        }
  return distance;
}

/// A crescent on one half of the bore, at most @p depth.
Eigen::VectorXd
crescent(const BoreNodes &nodes, const double depth)
{
  return depth * (nodes.angles.array() - 0.3).cos().max(0.).square();
}

/// What the mapping makes of a bore that was told to wear.
double
wear_error(const WornConfiguration &configuration, const double depth)
{
  const auto                 &fe = configuration.get_dof_handler().get_fe();
  const dealii::Quadrature<1> nodes(fe.get_unit_face_support_points());
  dealii::FEFaceValues<2>     fe_values(configuration.mapping(),
                                    fe,
                                    nodes,
                                    dealii::update_quadrature_points);
  double                      error = 0.;
  for (const auto &cell :
       configuration.get_dof_handler().active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && face->boundary_id() == BoundaryIds::bore)
        {
          fe_values.reinit(cell, face);
          for (const auto &x : fe_values.get_quadrature_points())
            {
              const double cosine =
                std::max(0., std::cos(std::atan2(x[1], x[0]) - 0.3));
              error =
                std::max(error,
                         std::abs(x.norm() - a - depth * cosine * cosine));
            }
        }
  return error;
}

class UniformExtension : public dealii::Function<2>
{
public:
  UniformExtension(const double depth)
    : dealii::Function<2>(2)
    , depth(depth)
  {}

  double
  value(const dealii::Point<2> &x, const unsigned int component) const override
  {
    return depth * (b / x.norm() - 1.) / (b - a) * x[component];
  }

  double depth;
};

double
extension_error(WornConfiguration &configuration, const unsigned int degree)
{
  const double depth = 0.1e-3;
  configuration.update(
    Eigen::VectorXd::Constant(configuration.bore_nodes().n_nodes(), depth));
  const auto            &dof_handler = configuration.get_dof_handler();
  dealii::Vector<double> errors(
    dof_handler.get_triangulation().n_active_cells());
  dealii::VectorTools::integrate_difference(dealii::MappingQ<2>(degree),
                                            dof_handler,
                                            configuration.wear_displacement(),
                                            UniformExtension(depth),
                                            errors,
                                            dealii::QGauss<2>(degree + 2),
                                            dealii::VectorTools::L2_norm);
  return errors.l2_norm();
}

void
check(const unsigned int degree, const bool refined_locally)
{
  dealii::Triangulation<2> triangulation;
  make_ring(triangulation, 48);
  if (refined_locally)
    {
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->center()[0] > 0.9 * a)
          cell->set_refine_flag();
      triangulation.execute_coarsening_and_refinement();
    }
  WornConfiguration configuration(triangulation, degree, "crank_pin");
  const auto       &nodes = configuration.bore_nodes();
  const auto        curve = [&]() {
    return make_bore_surface(configuration.worn_positions(), degree);
  };

  // 1e-12 R: a thousand roundings.
  std::cout << "degree " << degree << (refined_locally ? ", refined" : "")
            << ": round bore "
            << (off_circle(configuration, BoundaryIds::bore, a) < 1e-12 * a)
            << ", round rim "
            << (off_circle(configuration, BoundaryIds::rim, b) < 1e-12 * b);

  const double area_before = configuration.area();
  const double bore_before = curve().enclosed_area;
  configuration.update(crescent(nodes, 1e-3));
  const double removed = area_before - configuration.area();
  const double gained  = curve().enclosed_area - bore_before;
  std::cout << "; worn: bore " << (wear_error(configuration, 1e-3) < 1e-12 * a)
            << ", rim "
            << (off_circle(configuration, BoundaryIds::rim, b) < 1e-12 * b)
            << ", removed " << 1e6 * removed
            << " mm^2, as the curve says "
            // Rounding of the ring's area, in parts of what is removed.
            << (std::abs(removed - gained) < 1e-12 * area_before);
  configuration.update(Eigen::VectorXd::Zero(nodes.n_nodes()));
  std::cout << "; back "
            << (configuration.area() == area_before &&
                configuration.wear_displacement().linfty_norm() == 0.)
            << std::endl;
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::fixed << std::setprecision(4);
  for (unsigned int degree = 1; degree <= 3; ++degree)
    check(degree, false);
  check(2, true);

  for (unsigned int degree = 1; degree <= 3; ++degree)
    {
      double errors[2];
      for (unsigned int level = 0; level < 2; ++level)
        {
          dealii::Triangulation<2> triangulation;
          make_ring(triangulation, 24 << level);
          WornConfiguration configuration(triangulation, degree, "");
          errors[level] = extension_error(configuration, degree);
        }
      std::cout << "degree " << degree << ": rate of the extension "
                << std::setprecision(2) << std::log2(errors[0] / errors[1])
                << std::setprecision(4) << std::endl;
    }

  dealii::Triangulation<2> triangulation;
  make_ring(triangulation, 48);
  WornConfiguration configuration(triangulation, 2, "crank_pin");
  configuration.update(crescent(configuration.bore_nodes(), 3e-3));
  const double area = configuration.area();
  try
    {
      configuration.update(crescent(configuration.bore_nodes(), 7e-3));
    }
  catch (const ExcRun &exc)
    {
      exc.print_info(std::cout);
      std::cout << std::endl;
    }
  std::cout << "shape kept: " << (configuration.area() == area) << std::endl;
}

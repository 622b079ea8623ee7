// SPDX-License-Identifier: LGPL-2.1-or-later

// The mesh of a deeply worn bushing. Known:
// - the mesh displacement is linear along each ray, so that the wall keeps
//   1 - h/t of its size where it has lost h of t: nothing is turned inside out
//   whatever the shape. 60 % of the wall is asked for; the pits are as narrow
//   as the contact with a pin of a half and a quarter of the bore radius, and
//   the arc worn by the one-shot extrapolation of a narrow contact (half-angle
//   5 deg). An abrupt step is no shape that wear leaves; the polynomial of a
//   cell swings beyond it, and it is only asked to stay positive;
// - a bore worn uniformly by 60 % of the wall is the ring of Lame with a bore
//   that much larger: volume that a pressure displaces, plane strain;
// - for the other shapes, the volume that a pressure displaces converges under
//   refinement; the default mesh against one of half the cell size (a step has
//   another shape on each mesh). Bounds: 0.1 % is what the default mesh
//   promises of the pressure; with quadratic elements, shapes whose curvature
//   changes over no less than half a radius are to be a hundred times better.

#include <deal.II/base/mpi.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/vector.h>

#include <tribody/elasticity/bushing_elasticity.h>
#include <tribody/elasticity/ring_mesh.h>
#include <tribody/geometry/worn_configuration.h>
#include <tribody/surface/bore_surface.h>

#include <cmath>
#include <functional>
#include <iomanip>
#include <iostream>
#include <string>

using namespace Tribody;
using Geometry::WornConfiguration;

constexpr double a = 9.535e-3, b = 15.875e-3, wall = b - a;

/// Depth [m] at an angle for a largest depth [m].
using Shape = std::function<double(double, double)>;

/// What a pin of the given radius wears that has moved along the x axis until
/// the bore is @p h deep.
double
worn_by_pin(const double angle, const double pin_radius, const double h)
{
  const double e   = a - pin_radius + h;
  const double off = e * std::sin(angle);
  if (std::abs(off) >= pin_radius)
    return 0.;
  return std::max(0.,
                  e * std::cos(angle) +
                    std::sqrt(pin_radius * pin_radius - off * off) - a);
}

const std::vector<std::pair<std::string, Shape>> shapes = {
  {"uniform", [](const double, const double h) { return h; }},
  {"crescent",
   [](const double t, const double h) { return worn_by_pin(t, 9.525e-3, h); }},
  {"two lobes",
   [](const double t, const double h) {
     return std::max(worn_by_pin(t, 0.9 * a, h),
                     worn_by_pin(t - 2.6, 0.9 * a, 0.8 * h));
   }},
  {"pit of half the radius",
   [](const double t, const double h) { return worn_by_pin(t, 0.5 * a, h); }},
  {"pit of a quarter",
   [](const double t, const double h) { return worn_by_pin(t, 0.25 * a, h); }},
  {"one-shot arc of 5 deg",
   [](const double t, const double h) {
     const double x = std::remainder(t, 2. * M_PI) / (M_PI / 36.);
     return h * std::sqrt(std::max(0., 1. - x * x));
   }},
  {"step", [](const double t, const double h) {
     return std::abs(std::remainder(t, 2. * M_PI)) < 0.3 ? h : 0.;
   }}};

dealii::Triangulation<2>
make_ring(const unsigned int factor)
{
  Elasticity::RingMeshParameters parameters;
  parameters.n_bore_cells *= factor;
  parameters.n_radial_cells *= factor;
  dealii::Triangulation<2> triangulation;
  Elasticity::make_ring_mesh(parameters, a, b, triangulation);
  return triangulation;
}

void
wear(WornConfiguration &configuration, const Shape &shape, const double h)
{
  Eigen::VectorXd depth = configuration.bore_nodes().angles;
  for (double &value : depth)
    value = shape(value, h);
  configuration.update(depth);
}

/// By default mesh and elements of @p degree.
void
sweep(const Shape &shape, const unsigned int degree)
{
  const dealii::Triangulation<2> triangulation = make_ring(1);
  WornConfiguration configuration(triangulation, degree, "crank_pin");
  std::cout << "  degree " << degree << ':';
  for (const double part : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6})
    {
      wear(configuration, shape, part * wall);
      std::cout << ' ' << configuration.min_jacobian_ratio();
    }
  std::cout << std::endl;
}

/// Area [m^2] by which a pressure of 1 MPa enlarges the bore.
double
displaced_area(const Shape       &shape,
               const unsigned int degree,
               const unsigned int factor)
{
  const dealii::Triangulation<2> triangulation = make_ring(factor);
  WornConfiguration configuration(triangulation, degree, "crank_pin");
  wear(configuration, shape, 0.6 * wall);
  Elasticity::BushingElasticity elasticity(triangulation,
                                           degree,
                                           {"PTFE", 0.139e9, 0.38, 2160.},
                                           Elasticity::PlaneState::strain);
  elasticity.reinit(configuration.mapping());
  const Eigen::Matrix2Xd w =
    make_bore_surface(configuration.worn_positions(), degree).vector_weights;
  const MeshVector u = elasticity.solve(1e6 * w);

  const BoreNodes &nodes = elasticity.bore_nodes();
  double           area  = 0.;
  for (Eigen::Index i = 0; i < nodes.n_nodes(); ++i)
    area += w(0, i) * u[nodes.x_dofs[i]] + w(1, i) * u[nodes.y_dofs[i]];
  return area;
}

double
exact_displaced_area()
{
  const double E = 0.139e9, nu = 0.38, mu = E / (2. * (1. + nu)),
               lambda = E * nu / ((1. + nu) * (1. - 2. * nu));
  const double r      = a + 0.6 * wall;
  const double A      = -1e6 / (2. * lambda + 2. * mu * (1. + b * b / (r * r)));
  const double u      = A * r - A * b * b / r;
  return 2. * M_PI * r * u;
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::fixed << std::setprecision(2)
            << "smallest ratio of Jacobians at 10, 20, ..., 60 % of the "
               "wall"
            << std::endl;
  for (const auto &[name, shape] : shapes)
    {
      std::cout << name << std::endl;
      for (unsigned int degree = 1; degree <= 3; ++degree)
        sweep(shape, degree);
    }

  std::cout << "60 % of the wall, area displaced by a pressure" << std::endl;
  const auto compare = [](const double error, const bool is_smooth) {
    std::cout << (is_smooth ? "below 10 ppm: " : "below 0.1 %: ")
              << (error < (is_smooth ? 1e-5 : 1e-3)) << std::endl;
  };
  const double exact = exact_displaced_area();
  for (unsigned int degree = 1; degree <= 3; ++degree)
    {
      std::cout << "  uniform, degree " << degree << ", off Lame: ";
      compare(std::abs(displaced_area(shapes[0].second, degree, 1) / exact -
                       1.),
              degree > 1);
    }
  for (const auto &[name, shape] : shapes)
    if (name != "step" && name != "uniform")
      {
        const double coarse = displaced_area(shape, 2, 1);
        const double fine   = displaced_area(shape, 2, 2);
        std::cout << "  " << name << ", degree 2, off half the cell size: ";
        compare(std::abs(coarse / fine - 1.),
                name != "pit of a quarter" && name != "one-shot arc of 5 deg");
      }
}

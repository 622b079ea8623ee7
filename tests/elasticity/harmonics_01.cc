// SPDX-License-Identifier: LGPL-2.1-or-later

// The compliance of bore and pin under a pressure p cos n t, for which closed
// forms exist (kappa = 3 - 4 nu in plane strain, (3-nu)/(1+nu) in plane
// stress):
//   hole in an infinite plate  u = R p/(4 G) ((kappa+1) n + (kappa-1))/(n^2-1),
//   disc                       u = R p/(4 G) ((kappa+1) n - (kappa-1))/(n^2-1),
// n >= 2. Both are asked for n = 2 to 8 within 0.1 %; the plate ends at 100
// radii (1e-4), the disc has a pinhole (1e-5). Also for n = 0: the hole moves
// by p R/(2 G), the disc by p R (kappa-1)/(4 G), and a pin with a hole a moves
// by p R/E* ((R^2+a^2)/(R^2-a^2) - nu*) with E* = E/(1-nu^2), nu* = nu/(1-nu)
// in plane strain. A layer bonded to a rigid ground, of thickness t = 0.002 R:
// u = p t (1+nu)(1-2 nu)/(E (1-nu)), within 0.2 %, the t/R
// that it neglects.
//
// The matrix that is repeated from the columns of one cell is that of all
// columns, to the rounding of the direct solver; for the pin as well, which
// stands on three degrees of freedom that are not symmetric at all.

#include <deal.II/base/mpi.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>

#include <tribody/elasticity/bushing_elasticity.h>
#include <tribody/elasticity/pin_elasticity.h>
#include <tribody/elasticity/ring_mesh.h>
#include <tribody/surface/bore_surface.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace Tribody;
using namespace Tribody::Elasticity;

constexpr double R = 10e-3;
const Material   material{"steel", 200e9, 0.3, 7800.};

/// Amplitude of the displacement under unit pressure cos n t [m/Pa].
double
harmonic_compliance(const Eigen::MatrixXd &C,
                    const BoreNodes       &nodes,
                    const BoreSurface     &surface,
                    const unsigned int     n)
{
  const Eigen::VectorXd cosines = (n * nodes.angles.array()).cos();
  const Eigen::VectorXd displacement =
    C * surface.weights.cwiseProduct(cosines);
  return displacement.dot(cosines) / cosines.squaredNorm();
}

struct Harmonics
{
  double
  operator()(const unsigned int n) const
  {
    return harmonic_compliance(compliance, nodes, surface, n);
  }

  BoreNodes       nodes;
  BoreSurface     surface;
  Eigen::MatrixXd compliance;
};

template <typename Body, typename Nodes>
Harmonics
reduce(Body              &body,
       const Nodes       &nodes,
       const unsigned int degree,
       const RingSymmetry symmetry)
{
  body.reinit(dealii::MappingQ<2>(degree));
  Harmonics result;
  result.nodes   = nodes;
  result.surface = make_bore_surface(nodes.positions, degree);
  result.compliance =
    body.normal_compliance(nodes.radial_directions(), symmetry);
  return result;
}

Harmonics
hole(const RingMeshParameters &mesh,
     const double              outer_radius,
     const unsigned int        degree,
     const PlaneState          state,
     const RingSymmetry        symmetry = RingSymmetry::cells_alike)
{
  dealii::Triangulation<2> triangulation;
  make_ring_mesh(mesh, R, outer_radius, triangulation);
  BushingElasticity bushing(triangulation, degree, material, state);
  return reduce(bushing, bushing.bore_nodes(), degree, symmetry);
}

Harmonics
pin(const RingMeshParameters &mesh,
    const double              hole_radius,
    const unsigned int        degree,
    const PlaneState          state,
    const RingSymmetry        symmetry = RingSymmetry::cells_alike)
{
  dealii::Triangulation<2> triangulation;
  make_pin_mesh(mesh, hole_radius, R, triangulation);
  PinElasticity pin(triangulation, degree, material, state);
  return reduce(pin, pin.surface_nodes(), degree, symmetry);
}

void
check(const unsigned int degree, const PlaneState state)
{
  const double nu = material.poissons_ratio;
  const double G  = material.youngs_modulus / (2. * (1. + nu));
  const double kappa =
    (state == PlaneState::strain) ? 3. - 4. * nu : (3. - nu) / (1. + nu);
  const unsigned int n_cells = 180 * 2 / degree;
  const Harmonics    plate   = hole({n_cells, 40, 3.}, 100. * R, degree, state);
  const Harmonics    disc    = pin({n_cells, 24, 2.}, 0., degree, state);
  std::cout << "plane " << (state == PlaneState::strain ? "strain" : "stress")
            << ", degree " << degree << ", error [1e-3] of hole, disc:";
  double worst = 0.;
  for (const unsigned int n : {0, 2, 3, 4, 5, 6, 7, 8})
    {
      const double k = static_cast<double>(n) * n - 1.;
      const double exact_hole =
        R / (4. * G) * (n == 0 ? 2. : ((kappa + 1.) * n + (kappa - 1.)) / k);
      const double exact_disc =
        R / (4. * G) * ((kappa + 1.) * n - (kappa - 1.)) / k;
      const double hole_error = 1e3 * (plate(n) / exact_hole - 1.);
      const double disc_error = 1e3 * (disc(n) / exact_disc - 1.);
      std::cout << " n=" << n << ' ' << hole_error << ' ' << disc_error;
      worst = std::max({worst, std::abs(hole_error), std::abs(disc_error)});
    }
  std::cout << "; all within 0.1 % " << (worst < 1.) << std::endl;
}

void
check_hollow_pin()
{
  const double a = 0.6 * R, nu = material.poissons_ratio;
  const double exact = R * (1. - nu * nu) / material.youngs_modulus *
                       ((R * R + a * a) / (R * R - a * a) - nu / (1. - nu));
  const Harmonics ring = pin({60, 6, 1.}, a, 2, PlaneState::strain);
  // Lame's solution in quadratic elements.
  std::cout << "hollow pin, n=0: error " << 1e3 * (ring(0) / exact - 1.)
            << "e-3" << std::endl;
}

void
check_bonded_layer()
{
  const double    t = 2e-3 * R, nu = material.poissons_ratio;
  const Harmonics layer = hole({720, 2, 0.}, R + t, 2, PlaneState::strain);
  const double    exact =
    t * (1. + nu) * (1. - 2. * nu) / (material.youngs_modulus * (1. - nu));
  std::cout << "bonded layer, error [%]:";
  double worst = 0.;
  for (const unsigned int n : {0, 1, 2, 4, 8})
    {
      const double error = 100. * (layer(n) / exact - 1.);
      worst              = std::max(worst, std::abs(error));
      std::cout << " n=" << n << ' ' << error;
    }
  std::cout << "; all within 0.2 % " << (worst < 0.2) << std::endl;
}

void
check_symmetry(const unsigned int degree)
{
  const auto difference = [](const Harmonics &a, const Harmonics &b) {
    return (a.compliance - b.compliance).norm() / b.compliance.norm();
  };
  const auto         state = PlaneState::strain;
  RingMeshParameters mesh{24, 3, 1.};
  // What the condition of the stiffness leaves of 1e-16.
  std::cout
    << "degree " << degree << ": repeated columns right to 1e-10, hole "
    << (difference(hole(mesh, 2. * R, degree, state),
                   hole(mesh, 2. * R, degree, state, RingSymmetry::none)) <
        1e-10)
    << ", disc "
    << (difference(pin(mesh, 0., degree, state),
                   pin(mesh, 0., degree, state, RingSymmetry::none)) < 1e-10)
    << std::endl;
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::fixed << std::setprecision(3);
  check(2, PlaneState::strain);
  check(2, PlaneState::stress);
  check(3, PlaneState::strain);
  check_hollow_pin();
  check_bonded_layer();
  for (unsigned int degree = 1; degree <= 3; ++degree)
    check_symmetry(degree);
}

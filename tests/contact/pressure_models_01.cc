// SPDX-License-Identifier: LGPL-2.1-or-later

// What the finite elements buy: the validation joint (rigid pin, plane strain)
// under 25 N and 100 N with each pressure model, in per cent of the finite
// element results, and the closed forms of the other two.
//
// The Winkler layer has a solution of its own: p = k (d cos t - c) where that
// is positive, k = E (1-nu)/((1+nu)(1-2 nu) t), and the force R k (d (a + sin a
// cos a) - 2 c sin a), cos a = c/d: the peak within 0.5 % (nodes count whole),
// the half-angle within a node distance. The layer of the worn bore is thinner.
//
// The harmonics of the plate are those of tests/elasticity/harmonics_01, n = 0
// and 2 to 8, within 0.1 %, in plane strain and plane stress.

#include <deal.II/base/mpi.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>

#include <tribody/contact/contact_solver.h>
#include <tribody/elasticity/bushing_elasticity.h>
#include <tribody/elasticity/pressure_models.h>
#include <tribody/elasticity/ring_mesh.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace Tribody;
using namespace Tribody::Elasticity;

constexpr double a = 9.535e-3, b = 15.875e-3, pin_radius = 9.525e-3,
                 clearance = a - pin_radius;
const Material material{"PTFE", 0.139e9, 0.38, 2160.};

Contact::ContactSolution
solve(const BoreSurface     &surface,
      const Eigen::MatrixXd &compliance,
      const double           force)
{
  Contact::ContactSolver solver(surface, compliance, pin_radius);
  return solver.solve_force_controlled({force / 13.1e-3, 0.});
}

void
compare(const BoreSurface &surface, const Eigen::MatrixXd &finite_elements)
{
  const PlaneHooke      law(material, PlaneState::strain);
  const Eigen::MatrixXd plate     = infinite_plate_compliance(surface, law, b);
  const Eigen::MatrixXd winkler   = winkler_compliance(surface, law, b);
  const double          stiffness = (law.lambda + 2. * law.mu) / (b - a);
  for (const double force : {25., 100.})
    {
      const auto   exact = solve(surface, finite_elements, force);
      const double peak  = Contact::peak_pressure(exact, surface);
      std::cout << force << " N: finite elements " << 1e-6 * peak << " MPa, "
                << 180. / M_PI * exact.half_angle << " deg, "
                << 1e6 * exact.pin_centre[0] << " um" << std::endl;
      for (const bool is_plate : {true, false})
        {
          const auto   s = solve(surface, is_plate ? plate : winkler, force);
          const double p = Contact::peak_pressure(s, surface);
          std::cout << (is_plate ? "  infinite plate: peak "
                                 : "  Winkler layer: peak ")
                    << 100. * (p / peak - 1.) << " %, half-angle "
                    << 180. / M_PI * (s.half_angle - exact.half_angle)
                    << " deg, displacement "
                    << 100. * (s.pin_centre[0] / exact.pin_centre[0] - 1.)
                    << " %" << std::endl;
          if (is_plate)
            continue;
          double low = clearance, high = 1e-3;
          for (unsigned int k = 0; k < 100; ++k)
            {
              const double d = 0.5 * (low + high);
              const double t = std::acos(clearance / d);
              const double f = pin_radius * stiffness *
                               (d * (t + std::sin(t) * std::cos(t)) -
                                2. * clearance * std::sin(t));
              (f < force / 13.1e-3 ? low : high) = d;
            }
          std::cout << "    its closed form: peak within 0.5 % "
                    << (std::abs(p / (stiffness * (low - clearance)) - 1.) <
                        5e-3)
                    << ", half-angle within 1 deg "
                    << (std::abs(s.half_angle - std::acos(clearance / low)) <
                        M_PI / 180.)
                    << std::endl;
        }
    }
  const Eigen::Matrix2Xd worn = surface.positions * (1. + 1e-3 / a);
  std::cout << "worn by 1 mm, the layer's compliance times weight falls by "
            << 1. -
                 winkler_compliance(make_bore_surface(worn, 2), law, b)(0, 0) /
                   winkler(0, 0) * (1. + 1e-3 / a)
            << " (1 mm of the wall of 6.34 mm: 0.158)" << std::endl;
}

void
check_harmonics(const BoreSurface &surface, const PlaneState state)
{
  const PlaneHooke law(material, state);
  const double     kappa =
    (state == PlaneState::strain) ? 3. - 4. * 0.38 : (3. - 0.38) / (1. + 0.38);
  const Eigen::MatrixXd C     = infinite_plate_compliance(surface, law, b);
  double                worst = 0.;
  for (const int n : {0, 2, 3, 4, 5, 6, 7, 8})
    {
      Eigen::VectorXd cosines(surface.n_nodes());
      for (Eigen::Index i = 0; i < cosines.size(); ++i)
        cosines[i] = std::cos(
          n * std::atan2(surface.positions(1, i), surface.positions(0, i)));
      const double amplitude =
        cosines.dot(C * surface.weights.cwiseProduct(cosines)) /
        cosines.squaredNorm();
      const double exact =
        a / (4. * law.mu) *
        (n == 0 ? 2. : ((kappa + 1.) * n + (kappa - 1.)) / (n * n - 1.));
      worst = std::max(worst, std::abs(amplitude / exact - 1.));
    }
  std::cout << "plate, plane "
            << (state == PlaneState::strain ? "strain" : "stress")
            << ": harmonics within 1e-3 " << (worst < 1e-3) << std::endl;
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::fixed << std::setprecision(3);
  dealii::Triangulation<2> triangulation;
  make_ring_mesh({180, 6, 1.5}, a, b, triangulation);
  BushingElasticity ring(triangulation, 2, material, PlaneState::strain);
  ring.reinit(dealii::MappingQ<2>(2));
  const BoreSurface surface = make_bore_surface(ring.bore_nodes().positions, 2);
  compare(surface,
          ring.normal_compliance(surface.normals, RingSymmetry::cells_alike));
  check_harmonics(surface, PlaneState::strain);
  check_harmonics(surface, PlaneState::stress);
}

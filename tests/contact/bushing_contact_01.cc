// SPDX-License-Identifier: LGPL-2.1-or-later

// The validation joint: rigid pin, R = 9.525 mm, in a ring of 9.535 mm whose
// rim of 15.875 mm is clamped, E = 0.139 GPa, nu = 0.38, plane strain, 13.1 mm
// long. Reference: an independent finite element solution, converged to about
// 1e-3 (reference/bushing_contact.csv, printed below as "ref"). Peak pressure
// and displacement must agree to 0.5 %, the half-angle to 0.5 degrees, with the
// default mesh, linear and quadratic elements.
//
// "Ripple" is the largest second difference of the nodal pressures where they
// exceed 0.8 of the peak, relative to the peak. A smooth pressure
// p0 (1 - (x/a)^2)^(1/2) has up to 2 (h/a)^2 there (40 nodes to the half-angle:
// 1.2e-3); noise from node to node would add four times its amplitude.

#include <deal.II/base/mpi.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>

#include <tribody/contact/contact_solver.h>
#include <tribody/elasticity/bushing_elasticity.h>
#include <tribody/elasticity/ring_mesh.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace Tribody;

struct Reference
{
  double force, peak_pressure, half_angle, displacement;
};

// N, MPa, degrees, mm.
const Reference references[] = {{25., 0.194354, 43.588, 0.0147961},
                                {100., 0.603429, 62.458, 0.0248251}};

double
ripple(const Contact::ContactSolution &s)
{
  const Eigen::Index n       = s.pressure.size();
  double             largest = 0.;
  for (const Eigen::Index i : s.active_set)
    {
      if (s.pressure[i] > 0.8 * s.pressure.maxCoeff())
        largest =
          std::max(largest,
                   std::abs(s.pressure[(i + 1) % n] - 2. * s.pressure[i] +
                            s.pressure[(i - 1 + n) % n]));
    }
  return largest / s.pressure.maxCoeff();
}

void
check(const unsigned int degree, const bool finer)
{
  Elasticity::RingMeshParameters mesh;
  if (finer)
    {
      mesh.n_bore_cells *= 2;
      mesh.n_radial_cells *= 2;
    }
  dealii::Triangulation<2> triangulation;
  Elasticity::make_ring_mesh(mesh, 9.535e-3, 15.875e-3, triangulation);
  Elasticity::BushingElasticity elasticity(triangulation,
                                           degree,
                                           {"PTFE", 0.139e9, 0.38, 2160.},
                                           Elasticity::PlaneState::strain);
  elasticity.reinit(dealii::MappingQ<2>(degree));
  const BoreSurface surface =
    make_bore_surface(elasticity.bore_nodes().positions, degree);
  Contact::ContactSolver solver(surface,
                                elasticity.normal_compliance(surface.normals),
                                9.525e-3);

  std::cout << "degree " << degree << ", " << surface.n_nodes() << " bore nodes"
            << std::endl;
  for (const auto &reference : references)
    {
      const auto s =
        solver.solve_force_controlled({reference.force / 13.1e-3, 0.});
      const double peak       = 1e-6 * Contact::peak_pressure(s, surface);
      const double peak_error = 100. * (peak / reference.peak_pressure - 1.);
      const double angle_error =
        180. / M_PI * s.half_angle - reference.half_angle;
      const double displacement_error =
        100. * (1e3 * s.pin_centre[0] / reference.displacement - 1.);
      const bool within = s.report.converged && std::abs(peak_error) < 0.5 &&
                          std::abs(angle_error) < 0.5 &&
                          std::abs(displacement_error) < 0.5;
      std::cout << "  " << reference.force << " N: peak " << peak
                << " MPa (ref " << reference.peak_pressure << "), off by "
                << peak_error << " %; half-angle off by " << angle_error
                << " deg; displacement off by " << displacement_error
                << " %; within limits " << within << "; ripple "
                << 1e3 * ripple(s) << "e-3" << std::endl;
    }
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::fixed << std::setprecision(3);
  for (unsigned int degree = 1; degree <= 2; ++degree)
    check(degree, false);
  check(2, true);
}

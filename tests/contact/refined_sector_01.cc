// SPDX-License-Identifier: LGPL-2.1-or-later

// Contact on a bore that is refined in a sector, nodes hanging inside. Known:
// the pressure is that of the mesh which is as fine everywhere, up to what the
// coarser cells outside the sector and below change in the compliance. The
// validation joint under 100 N (contact over 125 degrees): peak pressure,
// half-angle and place of the pin against the fine ring, with the force in the
// middle of the sector and, worst case, at its edge. The nodes are in order and
// on the circle, the weights add up to the circumference, and the pressure
// integrates to the force.

#include <deal.II/base/mpi.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>

#include <tribody/contact/contact_solver.h>
#include <tribody/contact/pin_gap.h>
#include <tribody/elasticity/bushing_elasticity.h>
#include <tribody/elasticity/ring_mesh.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace Tribody;

constexpr double a = 9.535e-3, b = 15.875e-3, pin_radius = 9.525e-3;

struct Bushing
{
  Bushing(const Elasticity::RingMeshParameters &mesh, const unsigned int degree)
  {
    dealii::Triangulation<2> triangulation;
    Elasticity::make_ring_mesh(mesh, a, b, triangulation);
    Elasticity::refine_sector(mesh, a, b - a, "", triangulation);
    Elasticity::BushingElasticity elasticity(triangulation,
                                             degree,
                                             {"PTFE", 0.139e9, 0.38, 2160.},
                                             Elasticity::PlaneState::strain);
    elasticity.reinit(dealii::MappingQ<2>(degree));
    nodes      = elasticity.bore_nodes();
    surface    = make_bore_surface(nodes.positions, degree);
    compliance = elasticity.normal_compliance(surface.normals);
  }

  Contact::ContactSolution
  solve(const double direction) const
  {
    Contact::ContactSolver solver(surface, compliance, pin_radius);
    return solver.solve_force_controlled(
      100. / 13.1e-3 *
      Eigen::Vector2d(std::cos(direction), std::sin(direction)));
  }

  BoreNodes       nodes;
  BoreSurface     surface;
  Eigen::MatrixXd compliance;
};

void
compare(const Bushing &refined, const Bushing &fine, const double direction)
{
  const auto   s    = refined.solve(direction);
  const auto   f    = fine.solve(direction);
  const double peak = Contact::peak_pressure(s, refined.surface) /
                        Contact::peak_pressure(f, fine.surface) -
                      1.;
  const Contact::PinGap pin(refined.surface.positions,
                            s.pin_centre,
                            pin_radius);
  const Eigen::Vector2d total =
    pin.directions * refined.surface.weights.cwiseProduct(s.pressure);
  std::cout << "  force at " << 180. / M_PI * direction << " deg: peak off by "
            << 1e3 * peak << "e-3, half-angle by "
            << 180. / M_PI * (s.half_angle - f.half_angle) << " deg, place by "
            << 1e3 * (s.pin_centre.norm() / f.pin_centre.norm() - 1.)
            << "e-3; adds up to 1e-10 "
            << ((total - s.force).norm() < 1e-10 * s.force.norm()) << std::endl;
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::fixed << std::setprecision(2);
  for (unsigned int degree = 1; degree <= 3; ++degree)
    {
      Elasticity::RingMeshParameters mesh{45, 4, 1.5};
      mesh.n_sector_refinements = 2;
      mesh.sector               = {0., M_PI};
      const Bushing refined(mesh, degree);
      const Bushing fine({180, 16, 1.5}, degree);
      const auto   &angles = refined.nodes.angles;
      const auto    n      = angles.size();
      std::cout << "degree " << degree << ": " << n << " bore nodes, "
                << fine.nodes.n_nodes() << " if fine all around; in order "
                << ((angles.tail(n - 1) - angles.head(n - 1)).minCoeff() > 0.)
                << ", on the circle "
                << ((refined.nodes.positions.colwise().norm().array() - a)
                      .abs()
                      .maxCoeff() < 1e-12 * a)
                << ", circumference off by "
                << 1e3 * (refined.surface.weights.sum() / (2. * M_PI * a) - 1.)
                << "e-3" << std::endl;
      compare(refined, fine, 0.5 * M_PI);
      compare(refined, fine, 0.01);
    }
}

// SPDX-License-Identifier: LGPL-2.1-or-later

// A round ring, and one worn by a crescent of 0.3 mm, pressed by a rigid pin.
// Known:
// - The contact condensed to the bore's compliance and the contact on the full
//   mesh are the same discrete problem: nodal forces and pin centre agree to
//   1e-8 (both are solved directly; the condition of the stiffness leaves about
//   1e-11).
// - A ring worn evenly by h is a ring of radius a + h: the same pin centre (to
//   the mesh's error, which must fall) as on a mesh made with that
//   radius. This sees the stiffness on the worn mapping.
// - Everywhere under the worn mapping too: pressures times weights add up to
//   the force.

#include <deal.II/base/mpi.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>

#include <support/uncondensed_contact.h>

#include <tribody/contact/contact_solver.h>
#include <tribody/contact/pin_gap.h>
#include <tribody/elasticity/bushing_elasticity.h>
#include <tribody/elasticity/ring_mesh.h>
#include <tribody/geometry/worn_configuration.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace Tribody;

constexpr double a = 9.535e-3, b = 15.875e-3, pin_radius = 9.525e-3;

const Material material{"PTFE", 0.139e9, 0.38, 2160.};

void
make_mesh(const unsigned int        n,
          const double              radius,
          dealii::Triangulation<2> &triangulation)
{
  Elasticity::RingMeshParameters mesh;
  mesh.n_bore_cells   = n;
  mesh.n_radial_cells = n / 15;
  Elasticity::make_ring_mesh(mesh, radius, b, triangulation);
}

void
compare(const unsigned int degree,
        const double       depth,
        const unsigned int n_cells = 90)
{
  dealii::Triangulation<2> triangulation;
  make_mesh(n_cells, a, triangulation);
  Geometry::WornConfiguration worn(triangulation, degree, "crank_pin");
  // What a pin 5 um smaller than the bore wears when it is pushed to 0.3 rad.
  worn.update(
    (depth * (worn.bore_nodes().angles.array() - 0.3).cos() - 5e-6).max(0.));
  Elasticity::BushingElasticity elasticity(triangulation,
                                           degree,
                                           material,
                                           Elasticity::PlaneState::strain);
  elasticity.reinit(worn.mapping());
  const BoreSurface surface = make_bore_surface(worn.worn_positions(), degree);
  const Eigen::MatrixXd  C  = elasticity.normal_compliance(surface.normals);
  Contact::ContactSolver solver(surface, C, pin_radius);
  for (const double newtons : {25., 100.})
    {
      const Eigen::Vector2d force =
        newtons / 13.1e-3 * Eigen::Vector2d(std::cos(0.5), std::sin(0.5));
      const auto condensed = solver.solve_force_controlled(force);
      const auto full      = Coupling::solve_uncondensed_contact(elasticity,
                                                            surface,
                                                            pin_radius,
                                                            force);
      const Contact::PinGap pin(surface.positions,
                                condensed.pin_centre,
                                pin_radius);
      const Eigen::Vector2d total =
        pin.directions * surface.weights.cwiseProduct(condensed.pressure);
      std::cout << "degree " << degree << ", depth " << 1e3 * depth << " mm, "
                << newtons << " N: converged " << condensed.report.converged
                << full.report.converged << ", nodes in contact "
                << condensed.active_set.size() << ", same set "
                << (condensed.active_set == full.active_set) << ", half-angle "
                << 180. / M_PI * condensed.half_angle
                << ", forces equal to 1e-8 "
                << ((condensed.nodal_force - full.nodal_force).norm() <
                    1e-8 * full.nodal_force.norm())
                << ", pin centre "
                << ((condensed.pin_centre - full.pin_centre).norm() <
                    1e-8 * full.pin_centre.norm())
                // The solver's own tolerance is 1e-12.
                << ", pressure adds up to the force to 1e-10 "
                << ((total - force).norm() < 1e-10 * force.norm()) << std::endl;
    }
}

/// Displacement of the pin in an evenly worn bore and in a wider ring [um].
double
even_wear_difference(const unsigned int n)
{
  const double depth = 1e-3;
  double       displacement[2];
  for (const bool worn_evenly : {false, true})
    {
      dealii::Triangulation<2> triangulation;
      make_mesh(n, worn_evenly ? a : a + depth, triangulation);
      Geometry::WornConfiguration worn(triangulation, 2, "crank_pin");
      if (worn_evenly)
        worn.update(
          Eigen::VectorXd::Constant(worn.bore_nodes().n_nodes(), depth));
      Elasticity::BushingElasticity elasticity(triangulation,
                                               2,
                                               material,
                                               Elasticity::PlaneState::stress);
      elasticity.reinit(worn.mapping());
      const BoreSurface surface = make_bore_surface(worn.worn_positions(), 2);
      Contact::ContactSolver solver(surface,
                                    elasticity.normal_compliance(
                                      surface.normals),
                                    a + depth - 10e-6);
      displacement[worn_evenly] =
        1e6 * solver.solve_force_controlled({2000., 0.}).pin_centre.norm();
    }
  std::cout << "even wear, " << n << " cells: pin moves by " << displacement[0]
            << " um in the wider ring" << std::endl;
  return std::abs(displacement[1] - displacement[0]);
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::fixed << std::setprecision(2);
  for (unsigned int degree = 1; degree <= 2; ++degree)
    for (const double depth : {0., 0.3e-3})
      compare(degree, depth);
  // More iterations than a fixed small number.
  compare(2, 0., 180);
  const double coarse = even_wear_difference(30);
  const double fine   = even_wear_difference(60);
  // Differing by the mesh only: quadratic elements, energy at rate 4.
  std::cout << "difference below 1e-4 um " << (fine < 1e-4)
            << ", falls by more than 8 times " << (coarse > 8. * fine)
            << std::endl;
}

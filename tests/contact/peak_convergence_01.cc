// SPDX-License-Identifier: LGPL-2.1-or-later

// The peak pressure of the validation joint (quadratic elements on meshes that
// are graded towards the bore, all layers refined) and the place of its pin
// under refinement: their errors against the finest mesh must fall at second
// order. What a single force shows depends on where the ends of contact fall
// between two nodes, so the error is the root mean square over six forces (10
// to 320 N) and eight directions within a cell; what chance that leaves in the
// rates, a few tenths, falls as the range grows: the last rate is that of all
// refinements together. The finest mesh has four times the nodes of the last
// but one, which adds 0.03 to that rate.

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

constexpr double          a = 9.535e-3, b = 15.875e-3, pin_radius = 9.525e-3;
constexpr unsigned int    degree = 2, n_directions = 8;
const std::vector<double> forces{10., 20., 40., 80., 160., 320.};

/// One row per force, one column per direction.
struct Readings
{
  Eigen::ArrayXXd peaks, places;
};

Readings
solve(const unsigned int n_cells)
{
  dealii::Triangulation<2> triangulation;
  Elasticity::make_ring_mesh({n_cells, n_cells / 15, 1.5}, a, b, triangulation);
  Elasticity::BushingElasticity elasticity(triangulation,
                                           degree,
                                           {"PTFE", 0.139e9, 0.38, 2160.},
                                           Elasticity::PlaneState::strain);
  elasticity.reinit(dealii::MappingQ<2>(degree));
  const BoreSurface surface =
    make_bore_surface(elasticity.bore_nodes().positions, degree);
  Contact::ContactSolver solver(
    surface,
    elasticity.normal_compliance(surface.normals,
                                 Elasticity::RingSymmetry::cells_alike),
    pin_radius);
  const Eigen::Index n_forces = forces.size();
  Readings           readings{Eigen::ArrayXXd(n_forces, n_directions),
                    Eigen::ArrayXXd(n_forces, n_directions)};
  for (Eigen::Index j = 0; j < n_forces; ++j)
    for (unsigned int k = 0; k < n_directions; ++k)
      {
        const double angle = 2. * M_PI / n_cells * k / n_directions;
        const auto   s     = solver.solve_force_controlled(
          forces[j] / 13.1e-3 *
          Eigen::Vector2d(std::cos(angle), std::sin(angle)));
        readings.peaks(j, k)  = Contact::peak_pressure(s, surface);
        readings.places(j, k) = s.pin_centre.norm();
      }
  return readings;
}

double
root_mean_square(const Eigen::ArrayXXd &values, const Eigen::ArrayXd &exact)
{
  return std::sqrt((values.colwise() / exact - 1.).square().mean());
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::fixed << std::setprecision(3);
  const Readings       finest = solve(480);
  const Eigen::ArrayXd peak   = finest.peaks.rowwise().mean();
  const Eigen::ArrayXd place  = finest.places.rowwise().mean();
  std::cout << "finest, 960 bore nodes, 160 N: peak " << 1e-6 * peak[4]
            << " MPa, pin at " << 1e6 * place[4] << " um" << std::endl;
  double first_error = 0., last_error = 0., last_place = 0.;
  for (const unsigned int n_cells : {15, 30, 60, 120})
    {
      const Readings readings    = solve(n_cells);
      const double   peak_error  = root_mean_square(readings.peaks, peak);
      const double   place_error = root_mean_square(readings.places, place);
      std::cout << 2 * n_cells << " bore nodes: error of the peak "
                << 1e3 * peak_error << "e-3, of the place " << 1e3 * place_error
                << "e-3";
      if (last_error > 0.)
        std::cout << ", rates " << std::log2(last_error / peak_error) << ' '
                  << std::log2(last_place / place_error);
      else
        first_error = peak_error;
      std::cout << std::endl;
      last_error = peak_error;
      last_place = place_error;
    }
  std::cout << "rate of the peak over all refinements "
            << std::log2(first_error / last_error) / 3. << std::endl;
}

// The peak pressure of the validation joint (100 N, quadratic elements) under
// refinement: its error against the finest mesh must approach the second order.
// What a single force shows depends on where the edge of contact
// falls between two nodes, so the error is the root mean square over eight
// directions within a cell. The same for the place
// of the pin.

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

constexpr double       a = 9.535e-3, b = 15.875e-3, pin_radius = 9.525e-3;
constexpr unsigned int degree = 2, n_directions = 8;

struct Readings
{
  std::vector<double> peaks, places;
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
  Readings readings;
  for (unsigned int k = 0; k < n_directions; ++k)
    {
      const double angle = 2. * M_PI / n_cells * k / n_directions;
      const auto   s     = solver.solve_force_controlled(
        100. / 13.1e-3 * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
      readings.peaks.push_back(1e-6 * Contact::peak_pressure(s, surface));
      readings.places.push_back(1e6 * s.pin_centre.norm());
    }
  return readings;
}

double
root_mean_square(const std::vector<double> &values, const double exact)
{
  double sum = 0.;
  for (const double value : values)
    sum += std::pow(value / exact - 1., 2);
  return std::sqrt(sum / values.size());
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::fixed << std::setprecision(3);
  const Readings finest = solve(480);
  double         peak = 0., place = 0.;
  for (unsigned int k = 0; k < n_directions; ++k)
    {
      peak += finest.peaks[k] / n_directions;
      place += finest.places[k] / n_directions;
    }
  std::cout << "finest, 960 bore nodes: peak " << peak << " MPa, pin at "
            << place << " um" << std::endl;
  double last_peak = 0., last_place = 0.;
  for (const unsigned int n_cells : {15, 30, 60, 120})
    {
      const Readings readings    = solve(n_cells);
      const double   peak_error  = root_mean_square(readings.peaks, peak);
      const double   place_error = root_mean_square(readings.places, place);
      std::cout << 2 * n_cells << " bore nodes: error of the peak "
                << 1e3 * peak_error << "e-3, of the place " << 1e3 * place_error
                << "e-3";
      if (last_peak > 0.)
        std::cout << ", rates " << std::log2(last_peak / peak_error) << ' '
                  << std::log2(last_place / place_error);
      std::cout << std::endl;
      last_peak  = peak_error;
      last_place = place_error;
    }
}

// SPDX-License-Identifier: LGPL-2.1-or-later

// Heat from the bore of a ring to its rim. Closed forms:
// - evenly, rim at ambient temperature: T = Q ln(b/r)/(2 pi lambda), per
//   length; through a film alpha at the rim that much more as Q/(2 pi b alpha);
// - in parts 1 + cos t: besides T = (A r + B/r) cos t with -lambda dT/dr =
//   Q/(2 pi a) at the bore and T = 0, or -lambda dT/dr = alpha T, at the rim.
// Nodal heat q is exact for functions of the degree of the elements, cos t is
// none. Errors fall with the square of the cells' size or faster: on 96 cells
// they are 0.2 % for linear elements, and far less for quadratic ones.
// The mean over the ring of ln(b/r) is (1/2) - a^2/(b^2 - a^2) ln(b/a) by
// integration. The length of the rim is that of a circle.
// Known besides: the paper's ring (9.535 to 15.875 mm, 8.6 mm long, 0.25
// W/(m K)) under 0.5 W: 18.87 K.

#include <deal.II/base/mpi.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>

#include <tribody/elasticity/ring_mesh.h>
#include <tribody/surface/bore_surface.h>
#include <tribody/thermal/heat_conduction.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>

using namespace Tribody;
using namespace Tribody::Thermal;

namespace
{
  constexpr double a = 9.535e-3, b = 15.875e-3, lambda = 0.25;
  constexpr double heat = 0.5 / 8.6e-3;



  struct Errors
  {
    double even, cosine, mean;
  };



  // Relative to the largest temperature of the closed form.
  Errors
  errors(const unsigned int degree, const unsigned int n, const double alpha)
  {
    dealii::Triangulation<2> mesh;
    Elasticity::make_ring_mesh({n, n / 16, 1.}, a, b, mesh);
    HeatConduction ring(mesh, degree, lambda, alpha);
    ring.reinit(dealii::MappingQ<2>(degree));

    const Eigen::Index n_nodes = static_cast<Eigen::Index>(n) * degree;
    Eigen::VectorXd    cosine(n_nodes);
    Eigen::Matrix2Xd   positions(2, n_nodes);
    // Gauss-Lobatto nodes within a cell: equally spaced up to degree 2.
    for (Eigen::Index i = 0; i < n_nodes; ++i)
      {
        const double t   = 2. * M_PI * i / n_nodes;
        cosine[i]        = std::cos(t);
        positions.col(i) = a * Eigen::Vector2d(std::cos(t), std::sin(t));
      }
    const Eigen::VectorXd weights =
      make_bore_surface(positions, degree).weights;
    const Eigen::VectorXd flux = heat / (2. * M_PI * a) * weights;

    const double film = std::isinf(alpha) ? 0. : heat / (2. * M_PI * b * alpha);
    const double scale         = heat / (2. * M_PI * lambda);
    const double at_bore       = scale * std::log(b / a) + film;
    const TemperatureRise even = ring.solve(flux);

    // A r + B/r: -lambda (A - B/a^2) = q, and at the rim A b + B/b = 0 or
    // -lambda (A - B/b^2) = alpha (A b + B/b).
    const double q = heat / (2. * M_PI * a);
    const double rim =
      std::isinf(alpha) ? -1. : (lambda / b - alpha) / (lambda / b + alpha);
    // A = rim * B / b^2
    const double          B      = q / lambda / (1. / (a * a) - rim / (b * b));
    const double          A      = rim * B / (b * b);
    const TemperatureRise uneven = ring.solve(flux.cwiseProduct(cosine));

    const double mean =
      scale * (0.5 - a * a / (b * b - a * a) * std::log(b / a)) + film;
    return {
      std::abs(even.at_bore.mean() / at_bore - 1.),
      (uneven.at_bore - (A * a + B / a) * cosine).lpNorm<Eigen::Infinity>() /
        (A * a + B / a),
      std::abs(even.mean / mean - 1.)};
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::setprecision(5);
  std::cout << "known: "
            << 0.5 * std::log(b / a) / (2. * M_PI * lambda * 8.6e-3) << " K"
            << std::endl;
  for (const double alpha : {std::numeric_limits<double>::infinity(), 40.})
    for (unsigned int degree = 1; degree <= 2; ++degree)
      {
        const Errors coarse = errors(degree, 48, alpha),
                     fine   = errors(degree, 96, alpha);
        std::cout << "film " << alpha << " W/(m^2 K), degree " << degree
                  << ", 96 cells: evenly right to 0.2 % " << (fine.even < 2e-3)
                  << ", cosine to 0.2 % " << (fine.cosine < 2e-3)
                  << ", mean to 0.2 % " << (fine.mean < 2e-3)
                  << "; orders at least 2: "
                  << (std::log2(coarse.even / fine.even) > 1.9) << ' '
                  << (std::log2(coarse.cosine / fine.cosine) > 1.9)
                  << std::endl;
      }
  dealii::Triangulation<2> mesh;
  Elasticity::make_ring_mesh({90, 6, 1.}, a, b, mesh);
  std::cout << "rim: 2 pi b to 1e-6 "
            << (std::abs(rim_length(mesh, 2) / (2. * M_PI * b) - 1.) < 1e-6)
            << "; uniform "
            << HeatConduction(mesh, 2, lambda, 1.).uniform(7.).mean
            << std::endl;
}

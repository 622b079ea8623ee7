// SPDX-License-Identifier: LGPL-2.1-or-later

// Fields carried between a bore and a pin that is turned against it. Known:
// whatever the angle, the number of nodes and the wear of the bore, as much
// arrives at the pin as leaves the bore, and what is the same everywhere on the
// pin is so on the bore (1e-12). Fields and forces do the same work on both
// sides. A field cos 3t of the pin arrives in a round bore as cos 3(t - angle)
// with the rate of the elements in the mean square, degree + 1, to 0.15 (on the
// pin there are 1.1 times as many pieces, so that those of both meet alike on
// every mesh). For the same nodes on both sides nothing changes. For a round
// bore the general make_turned_interpolation() is the same but for its
// correction of forces, which the polygons of degree p leave (h^(p+1)); what
// columns() leaves out is 1e-4.

#include <tribody/surface/turned_interpolation.h>
#include <tribody/surface/turned_surfaces.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <numeric>

using namespace Tribody;

constexpr double R = 10e-3;

/// A curve of n pieces; a crescent of the given depth towards 0.4 rad is worn
/// out of it.
BoreSurface
make_curve(const unsigned int n, const unsigned int degree, const double depth)
{
  const Eigen::VectorXd angles = TurnedSurfaces::pin_node_angles(n, degree);
  Eigen::Matrix2Xd      positions(2, n * degree);
  for (Eigen::Index i = 0; i < angles.size(); ++i)
    {
      const double worn =
        std::max(0., depth * std::cos(angles[i] - 0.4) - 0.2 * depth);
      positions.col(i) << (R + worn) * std::cos(angles[i]),
        (R + worn) * std::sin(angles[i]);
    }
  return make_bore_surface(positions, degree);
}

Eigen::VectorXd
wave(const unsigned int n, const unsigned int degree, const double by)
{
  return (3. * (TurnedSurfaces::pin_node_angles(n, degree).array() - by)).cos();
}

double
wave_error(const unsigned int n, const unsigned int degree)
{
  const double         angle = 0.7;
  const unsigned int   n_pin = n * 11 / 10;
  const TurnedSurfaces surfaces(make_curve(n, degree, 0.),
                                make_curve(n, degree, 0.).positions,
                                n_pin);
  return (surfaces.turned_by(angle).to_bore(wave(n_pin, degree, 0.)) -
          wave(n, degree, angle))
           .norm() /
         std::sqrt(n * degree);
}

int
main()
{
  std::cout << std::fixed << std::setprecision(2);
  for (unsigned int degree = 1; degree <= 3; ++degree)
    for (const double depth : {0., 0.3e-3})
      {
        const unsigned int    n = 90, n_pin = 64;
        const BoreSurface     bore = make_curve(n, degree, depth);
        const TurnedSurfaces  surfaces(bore,
                                      make_curve(n, degree, 0.).positions,
                                      n_pin);
        const Eigen::VectorXd force =
          wave(n, degree, 0.2).cwiseMax(0.).cwiseProduct(bore.weights);
        const Eigen::VectorXd field = wave(n_pin, degree, 0.1);
        double                lost = 0., constant = 0., work = 0.;
        for (const double angle : {0., 0.01, -2.5, 40.})
          {
            const TurnedTransfer  transfer = surfaces.turned_by(angle);
            const Eigen::VectorXd on_pin   = transfer.to_pin(force);
            const Eigen::VectorXd on_bore  = transfer.to_bore(field);
            lost += std::abs(on_pin.sum() / force.sum() - 1.);
            constant +=
              (transfer.to_bore(Eigen::VectorXd::Ones(n_pin * degree)).array() -
               1.)
                .abs()
                .maxCoeff();
            work += std::abs(on_pin.dot(field) - force.dot(on_bore)) /
                    force.cwiseAbs().dot(on_bore.cwiseAbs());
          }
        std::cout << "degree " << degree << ", worn by " << 1e3 * depth
                  << " mm: nothing lost " << (lost < 1e-12)
                  << ", constant kept " << (constant < 1e-12) << ", same work "
                  << (work < 1e-12) << std::endl;
      }

  for (unsigned int degree = 1; degree <= 3; ++degree)
    {
      const double rate =
        std::log2(wave_error(120, degree) / wave_error(240, degree));
      std::cout << "degree " << degree << ": error of the wave falls at rate "
                << degree + 1 << " to 0.15 ";
      if (std::abs(rate - (degree + 1.)) < 0.15)
        std::cout << true << std::endl;
      else
        std::cout << "NO, " << rate << std::endl;
    }

  for (unsigned int degree = 1; degree <= 3; ++degree)
    {
      const unsigned int    n    = 60;
      const BoreSurface     bore = make_curve(n, degree, 0.);
      const TurnedSurfaces  surfaces(bore, bore.positions, n);
      const Eigen::VectorXd field = wave(n, degree, 0.);
      const double same = (surfaces.turned_by(0.).to_pin(field) - field).norm();

      std::vector<Eigen::Index> all(n * degree);
      std::iota(all.begin(), all.end(), 0);
      const TurnedTransfer  transfer = surfaces.turned_by(1.);
      const Eigen::MatrixXd columns  = transfer.columns(all);
      const Eigen::MatrixXd P       = make_turned_interpolation(bore, bore, 1.);
      double                dropped = 0.;
      for (const Eigen::Index i : {0, 1, 17})
        dropped =
          std::max(dropped,
                   (transfer.to_pin(Eigen::VectorXd::Unit(n * degree, i)) -
                    columns.col(i))
                     .lpNorm<Eigen::Infinity>());
      std::cout << "degree " << degree << ": same nodes, nothing changes "
                << (same < 1e-10) << ", columns right to 1e-3 "
                << (dropped < 1e-3) << ", as the general one to 1e-2 "
                << ((columns - P).lpNorm<Eigen::Infinity>() < 1e-2)
                << std::endl;
    }
}

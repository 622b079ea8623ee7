// SPDX-License-Identifier: LGPL-2.1-or-later

// Forces and displacements between a bore and a pin that is turned against it.
// Known: whatever the angle, the number of nodes and the wear of the bore, each
// nodal force keeps its direction and size, and the pin feels no moment, to
// rounding (1e-12 of the force and of force times radius). A displacement of
// the pin's surface u = cos 3t arrives in a round bore as cos 3(t - angle), and
// of a constant nothing is lost. The error in the mean square falls
// - at the rate of the elements, 2 and 3 for degrees 1 and 2, to 0.1. The pin
//   has 1.1 times as many pieces, so that the pieces of both meet alike on
//   every mesh. (With 7 pieces more on each, the curves would become alike as
//   the mesh grows finer, which shows as rates of 2.96 and 2.72);
// - at the rate 3 for degree 3, because bore and pin touch where normals agree,
//   and the normal of a cubic curve, the derivative of its interpolation, is
//   off at the two nodes inside a piece. With the angle h of a piece and
//   w(s) = s (s - a)(s - 1 + a)(s - 1), a = (1 - 1/sqrt 5)/2, that is by
//   h^3 |w'(a)|/24 = 3.727e-3 h^3; and the wave, whose slope is 3, by three
//   times as much at most. Within 2 %: what else there is falls at the rate 4
//   and is 1 % of that on the coarser mesh.
// With the same nodes on both sides and no turn, P is the identity as far as
// curves of different radius through the same angles are similar: to rounding.

#include <tribody/surface/turned_interpolation.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <utility>

using namespace Tribody;

constexpr double R = 10e-3;

/// A curve of n pieces; a crescent of the given depth towards 0.4 rad is worn
/// out of it.
BoreSurface
make_curve(const unsigned int n,
           const unsigned int degree,
           const double       radius,
           const double       depth)
{
  // Nodes of Gauss-Lobatto on each arc; for the third degree they lie at
  // (1 -+ 1/sqrt 5)/2.
  const double     inner       = 0.5 * (1. - 1. / std::sqrt(5.));
  const double     shift[3][3] = {{0.}, {0., 0.5}, {0., inner, 1. - inner}};
  Eigen::Matrix2Xd positions(2, n * degree);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int k = 0; k < degree; ++k)
      {
        const double t = 2. * M_PI * (i + shift[degree - 1][k]) / n;
        const double worn =
          std::max(0., depth * std::cos(t - 0.4) - 0.2 * depth);
        positions.col(i * degree + k) << (radius + worn) * std::cos(t),
          (radius + worn) * std::sin(t);
      }
  return make_bore_surface(positions, degree);
}

struct WaveError
{
  /// Root of the mean square over the nodes, and the largest.
  double mean, largest;
  /// Of a constant one.
  double constant;
};

WaveError
compute_wave_error(const unsigned int n, const unsigned int degree)
{
  const double          angle = 0.7;
  const BoreSurface     bore  = make_curve(n, degree, R, 0.);
  const BoreSurface     pin   = make_curve(n * 11 / 10, degree, 0.99 * R, 0.);
  const Eigen::MatrixXd P     = make_turned_interpolation(bore, pin, angle);
  const auto            wave  = [](const BoreSurface &curve, const double by) {
    Eigen::VectorXd u(curve.n_nodes());
    for (Eigen::Index i = 0; i < u.size(); ++i)
      u[i] = std::cos(
        3. * (std::atan2(curve.positions(1, i), curve.positions(0, i)) - by));
    return u;
  };
  const Eigen::VectorXd error =
    P.transpose() * wave(pin, 0.) - wave(bore, angle);
  return {error.norm() / std::sqrt(error.size()),
          error.lpNorm<Eigen::Infinity>(),
          (P.colwise().sum().array() - 1.).abs().maxCoeff()};
}

int
main()
{
  std::cout << std::fixed << std::setprecision(2);
  for (unsigned int degree = 1; degree <= 3; ++degree)
    for (const double depth : {0., 0.3e-3})
      {
        const BoreSurface bore = make_curve(90, degree, R, depth);
        const BoreSurface pin  = make_curve(64, degree, 0.99 * R, 0.);
        Eigen::Vector2d   errors(0., 0.);
        for (const double angle : {0., 0.01, -2.5, 40.})
          {
            const Eigen::MatrixXd P =
              make_turned_interpolation(bore, pin, angle);
            const Eigen::Matrix2Xd radii = pin.positions.colwise().normalized();
            const Eigen::Matrix2Xd felt  = radii * P;
            Eigen::Matrix2d        turn;
            turn << std::cos(angle), -std::sin(angle), std::sin(angle),
              std::cos(angle);
            const Eigen::RowVectorXd moments =
              (pin.positions.row(0).cwiseProduct(radii.row(1)) -
               pin.positions.row(1).cwiseProduct(radii.row(0))) *
              P;
            // A sum of squares keeps what is not a number.
            errors += Eigen::Vector2d((turn * felt - bore.normals).norm(),
                                      moments.norm() / R);
          }
        std::cout << "degree " << degree << ", worn by " << 1e3 * depth
                  << " mm: force kept " << (errors[0] < 1e-12) << ", no moment "
                  << (errors[1] < 1e-12) << std::endl;
      }

  for (unsigned int degree = 1; degree <= 3; ++degree)
    {
      const WaveError coarse = compute_wave_error(120, degree);
      const WaveError fine   = compute_wave_error(240, degree);
      const double    rate   = std::log2(coarse.mean / fine.mean);
      const double    known  = std::min(degree + 1., 3.);
      std::cout << "degree " << degree << ": error of the wave falls at rate "
                << known << " to 0.1 ";
      if (std::abs(rate - known) < 0.1)
        std::cout << true;
      else
        std::cout << "NO, " << rate;
      std::cout << ", constant kept to 1e-4 "
                << (coarse.constant < 1e-4 && fine.constant < 1e-4)
                << std::endl;
      if (degree == 3)
        for (const auto &[n, error] :
             {std::make_pair(120, coarse), std::make_pair(240, fine)})
          {
            const double from_normals =
              3. * 3.727e-3 * std::pow(2. * M_PI / n, 3);
            std::cout << "  " << n << " pieces: error of the normals to 2 % "
                      << (std::abs(error.largest / from_normals - 1.) < 0.02)
                      << std::endl;
          }
    }

  for (unsigned int degree = 1; degree <= 2; ++degree)
    {
      const Eigen::MatrixXd P =
        make_turned_interpolation(make_curve(60, degree, R, 0.),
                                  make_curve(60, degree, 0.99 * R, 0.),
                                  0.);
      const Eigen::MatrixXd error =
        P - Eigen::MatrixXd::Identity(60 * degree, 60 * degree);
      std::cout << "degree " << degree << ": identity for the same nodes "
                << (error.norm() < 1e-10) << std::endl;
    }
}

// SPDX-License-Identifier: LGPL-2.1-or-later

// Forces and displacements between a bore and a pin that is turned against it.
// Known: whatever the angle, the number of nodes and the wear of the bore, each
// nodal force keeps its direction and size, and the pin feels no moment, to
// rounding (1e-12 of the force and of force times radius). A displacement of
// the pin's surface u = cos 3t arrives in a round bore as cos 3(t - angle),
// with the rate of the elements, degree + 1, and of a constant nothing is lost.
// With the same nodes on both sides and no turn, P is the identity as far as
// curves of different radius through the same angles are similar: to rounding.

#include <tribody/surface/turned_interpolation.h>

#include <cmath>
#include <iomanip>
#include <iostream>

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

double
interpolation_error(const unsigned int n,
                    const unsigned int degree,
                    const double       angle,
                    double            &constant_error)
{
  const BoreSurface     bore = make_curve(n, degree, R, 0.);
  const BoreSurface     pin  = make_curve(n + 7, degree, 0.99 * R, 0.);
  const Eigen::MatrixXd P    = make_turned_interpolation(bore, pin, angle);
  const auto            wave = [](const BoreSurface &curve, const double by) {
    Eigen::VectorXd u(curve.n_nodes());
    for (Eigen::Index i = 0; i < u.size(); ++i)
      u[i] = std::cos(
        3. * (std::atan2(curve.positions(1, i), curve.positions(0, i)) - by));
    return u;
  };
  constant_error = (P.colwise().sum().array() - 1.).abs().maxCoeff();
  return (P.transpose() * wave(pin, 0.) - wave(bore, angle))
    .lpNorm<Eigen::Infinity>();
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
      double       constant_coarse, constant_fine;
      const double coarse =
        interpolation_error(120, degree, 0.7, constant_coarse);
      const double fine = interpolation_error(240, degree, 0.7, constant_fine);
      std::cout << "degree " << degree << ": error of the wave falls at rate "
                << std::log2(coarse / fine) << ", constant kept to 1e-4 "
                << (constant_coarse < 1e-4 && constant_fine < 1e-4)
                << std::endl;
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

// SPDX-License-Identifier: LGPL-2.1-or-later

// The bore as a curve: on a round bore weights add up to the circumference and
// the enclosed area to that of the circle at the rate of the interpolation
// (2, 4, 6 for degrees 1, 2, 3 with Gauss-Lobatto nodes), normals are radial
// (to the interpolation error where a node is no mirror of its piece), and the
// vector weights are the derivative of the area (checked by differences on a
// bore that is not round; the area is quadratic in the position of a node, so
// central differences are exact to rounding).

#include <tribody/surface/bore_surface.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace Tribody;

Eigen::Matrix2Xd
nodes(const unsigned int n_pieces,
      const unsigned int degree,
      const double       depth)
{
  // Gauss-Lobatto points on (0, 1), degrees 1 to 3.
  const double                           c      = 0.5 - 0.5 / std::sqrt(5.);
  const std::vector<std::vector<double>> points = {{0.},
                                                   {0., 0.5},
                                                   {0., c, 1. - c}};
  Eigen::Matrix2Xd                       positions(2, n_pieces * degree);
  for (unsigned int i = 0; i < n_pieces * degree; ++i)
    {
      const double angle =
        2. * M_PI * (i / degree + points[degree - 1][i % degree]) / n_pieces;
      const double radius = 1. + depth * std::exp(-4. * angle);
      positions.col(i) << radius * std::cos(angle), radius * std::sin(angle);
    }
  return positions;
}

int
main()
{
  std::cout << std::fixed << std::setprecision(2);
  for (unsigned int degree = 1; degree <= 3; ++degree)
    {
      double length_error[2], area_error[2];
      for (unsigned int level = 0; level < 2; ++level)
        {
          const BoreSurface bore =
            make_bore_surface(nodes(16 << level, degree, 0.), degree);
          length_error[level] = std::abs(bore.weights.sum() - 2. * M_PI);
          area_error[level]   = std::abs(bore.enclosed_area - M_PI);
          if (level == 1)
            std::cout
              << "degree " << degree << ": normals radial: "
              << ((bore.normals - bore.positions).lpNorm<Eigen::Infinity>() <
                  (degree < 3 ? 1e-12 : 1e-3))
              << std::endl;
        }
      std::cout << "  rates: length "
                << std::log2(length_error[0] / length_error[1]) << ", area "
                << std::log2(area_error[0] / area_error[1]) << std::endl;

      const Eigen::Matrix2Xd positions = nodes(16, degree, 0.1);
      const BoreSurface      bore      = make_bore_surface(positions, degree);
      const double           step      = 1e-3;
      double                 error     = 0.;
      for (Eigen::Index i = 0; i < bore.n_nodes(); ++i)
        for (unsigned int d = 0; d < 2; ++d)
          {
            Eigen::Matrix2Xd moved = positions;
            moved(d, i) += step;
            const double plus = make_bore_surface(moved, degree).enclosed_area;
            moved(d, i) -= 2. * step;
            const double minus = make_bore_surface(moved, degree).enclosed_area;
            error              = std::max(error,
                             std::abs((plus - minus) / (2. * step) -
                                      bore.vector_weights(d, i)));
          }
      std::cout << "  area derivative right to 1e-11: " << (error < 1e-11)
                << std::endl;
    }
}

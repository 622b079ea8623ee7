// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <tribody/surface/bore_surface.h>

namespace Tribody
{
  BoreSurface
  make_bore_surface(const Eigen::Matrix2Xd &positions,
                    const unsigned int      degree)
  {
    const Eigen::Index n = positions.cols();
    Assert(degree > 0 && n % degree == 0,
           dealii::ExcMessage("The nodes are not those of whole pieces."));

    const auto basis = dealii::Polynomials::generate_complete_Lagrange_basis(
      dealii::QGaussLobatto<1>(degree + 1).get_points());
    // n ds and x . n ds are polynomials, integrated exactly; ds is the root of
    // one, for which these points leave less than the geometry's own error.
    const dealii::QGauss<1> quadrature(2 * degree + 1);

    BoreSurface surface;
    surface.degree         = degree;
    surface.positions      = positions;
    surface.weights        = Eigen::VectorXd::Zero(n);
    surface.vector_weights = Eigen::Matrix2Xd::Zero(2, n);

    std::vector<double> derivatives(2);
    for (Eigen::Index first = 0; first < n; first += degree)
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          Eigen::Vector2d     position = Eigen::Vector2d::Zero();
          Eigen::Vector2d     tangent  = Eigen::Vector2d::Zero();
          std::vector<double> shape_values;
          for (unsigned int i = 0; i <= degree; ++i)
            {
              basis[i].value(quadrature.point(q)[0], derivatives);
              const auto node = positions.col((first + i) % n);
              position += derivatives[0] * node;
              tangent += derivatives[1] * node;
              shape_values.push_back(derivatives[0]);
            }
          // Counter-clockwise: the outward normal is the tangent turned
          // clockwise.
          const Eigen::Vector2d normal_ds =
            quadrature.weight(q) * Eigen::Vector2d(tangent[1], -tangent[0]);

          for (unsigned int i = 0; i <= degree; ++i)
            {
              const Eigen::Index node = (first + i) % n;
              surface.weights[node] += shape_values[i] * normal_ds.norm();
              surface.vector_weights.col(node) += shape_values[i] * normal_ds;
            }
          surface.enclosed_area += 0.5 * position.dot(normal_ds);
        }

    surface.normals = surface.vector_weights.colwise().normalized();
    return surface;
  }
} // namespace Tribody

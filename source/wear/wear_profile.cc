#include <tribody/wear/wear_profile.h>

#include <cmath>

namespace Tribody
{
  namespace Wear
  {
    BoreSurface
    WearProfile::surface() const
    {
      return make_bore_surface(positions + normals * depth.asDiagonal(),
                               degree);
    }



    Eigen::VectorXd
    WearProfile::area_derivative(const BoreSurface &surface) const
    {
      return normals.cwiseProduct(surface.vector_weights).colwise().sum();
    }



    Eigen::VectorXd
    WearProfile::depth_for_removed_area(
      const BoreSurface     &surface,
      const Eigen::VectorXd &removed_area) const
    {
      return removed_area.cwiseQuotient(area_derivative(surface));
    }



    double
    WearProfile::max_depth() const
    {
      return depth.maxCoeff();
    }



    Eigen::Index
    WearProfile::deepest_node() const
    {
      Eigen::Index node = 0;
      depth.maxCoeff(&node);
      return node;
    }



    WearProfile
    make_wear_profile(const Eigen::Matrix2Xd &positions,
                      const Eigen::Matrix2Xd &normals,
                      const unsigned int      degree)
    {
      return {positions,
              normals,
              Eigen::VectorXd::Zero(positions.cols()),
              degree};
    }



    double
    mesh_oscillation(const Eigen::VectorXd &values)
    {
      const Eigen::Index n       = values.size();
      double             largest = 0.;
      for (Eigen::Index i = 0; i < n; ++i)
        {
          const double a = values[(i + n - 2) % n], b = values[(i + n - 1) % n],
                       c = values[i], d = values[(i + 1) % n],
                       e = values[(i + 2) % n];
          if (a > 0. && b > 0. && c > 0. && d > 0. && e > 0.)
            largest =
              std::max(largest,
                       std::abs(a - 4. * b + 6. * c - 4. * d + e) / 16.);
        }
      const double scale = values.maxCoeff();
      return scale > 0. ? largest / scale : 0.;
    }
  } // namespace Wear
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/wear/wear_profile.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

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
      return side *
             normals.cwiseProduct(surface.vector_weights).colwise().sum();
    }



    Eigen::VectorXd
    WearProfile::depth_for_removed_area(
      const BoreSurface     &surface,
      const Eigen::VectorXd &removed_area) const
    {
      return removed_area.cwiseQuotient(area_derivative(surface));
    }



    Eigen::VectorXd
    WearProfile::depth_after_removing(const Eigen::VectorXd &removed_area) const
    {
      // The derivative changes by the depth over the radius: each iteration
      // gains that factor.
      WearProfile     mean   = *this;
      Eigen::VectorXd result = depth;
      for (unsigned int i = 0; i < 50; ++i)
        {
          mean.depth = 0.5 * (depth + result);
          const Eigen::VectorXd next =
            depth + mean.depth_for_removed_area(mean.surface(), removed_area);
          const double change = (next - result).lpNorm<Eigen::Infinity>();
          result              = next;
          if (!(change > 1e-13 * (next - depth).lpNorm<Eigen::Infinity>()))
            break;
        }
      return result;
    }



    double
    WearProfile::lost_area() const
    {
      return side * (surface().enclosed_area -
                     make_bore_surface(positions, degree).enclosed_area);
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



    WearProfile
    make_pin_profile(const double           radius,
                     const Eigen::VectorXd &angles,
                     const unsigned int     degree)
    {
      Eigen::Matrix2Xd directions(2, angles.size());
      directions << angles.array().cos().transpose(),
        angles.array().sin().transpose();
      WearProfile profile =
        make_wear_profile(radius * directions, -directions, degree);
      profile.side = -1.;
      return profile;
    }



    namespace
    {
      // The parts of the values that alternate from node to node; where not all
      // five nodes are well inside the arc of positive values, nothing.
      std::vector<std::optional<double>>
      alternating_parts(const Eigen::VectorXd &values)
      {
        const Eigen::Index n  = values.size();
        const auto         at = [&](const Eigen::Index i) {
          return values[(i + n) % n];
        };
        const auto is_inside = [&](const Eigen::Index i) {
          const double before = std::max({at(i - 2), at(i - 1), at(i)});
          const double after  = std::max({at(i), at(i + 1), at(i + 2)});
          return before > 0. && after > 0.;
        };
        std::vector<std::optional<double>> parts(n);
        for (Eigen::Index i = 0; i < n; ++i)
          {
            bool all_inside = true;
            for (Eigen::Index k = i - 2; k <= i + 2; ++k)
              all_inside = all_inside && is_inside(k);
            if (all_inside)
              parts[i] = std::abs(at(i - 2) - 4. * at(i - 1) + 6. * at(i) -
                                  4. * at(i + 1) + at(i + 2)) /
                         16.;
          }
        return parts;
      }
    } // namespace



    double
    mesh_oscillation(const Eigen::VectorXd &values)
    {
      // An edge or a corner touches at most five of these in a row, so that it
      // does not move the median of eleven.
      constexpr Eigen::Index reach = 5;

      const auto         parts   = alternating_parts(values);
      const Eigen::Index n       = values.size();
      double             largest = 0.;
      for (Eigen::Index i = 0; i < n; ++i)
        {
          if (!parts[i])
            continue;
          std::vector<double> around;
          for (Eigen::Index k = i - reach; k <= i + reach; ++k)
            if (parts[(k + n) % n])
              around.push_back(*parts[(k + n) % n]);
          const auto middle = around.begin() + around.size() / 2;
          std::nth_element(around.begin(), middle, around.end());
          largest = std::max(largest, *middle);
        }
      const double scale = values.maxCoeff();
      return scale > 0. ? largest / scale : 0.;
    }
  } // namespace Wear
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/elements/marker_distance.h>

#include <limits>

namespace Tribody
{
  namespace Multibody
  {
    MarkerDistance
    compute_marker_distance(const PairVector      &q,
                            const Eigen::Vector2d &s_1,
                            const Eigen::Vector2d &s_2)
    {
      const Eigen::Vector2d a1 = turned(s_1, q(2)), a2 = turned(s_2, q(5));
      const Eigen::Vector2d d = q.segment<2>(3) + a2 - q.head<2>() - a1;
      const double          l = d.norm();
      if (l < std::numeric_limits<double>::min())
        return {0.,
                Eigen::Vector2d::Zero(),
                PairVector::Zero(),
                PairMatrix::Zero()};
      const Eigen::Vector2d u = d / l;

      Eigen::Matrix<double, 2, 6> d_q;
      d_q << -Eigen::Matrix2d::Identity(), -perpendicular(a1),
        Eigen::Matrix2d::Identity(), perpendicular(a2);
      PairMatrix l_qq =
        d_q.transpose() *
        ((Eigen::Matrix2d::Identity() - u * u.transpose()) / l) * d_q;
      l_qq(2, 2) += u.dot(a1);
      l_qq(5, 5) -= u.dot(a2);
      return {l, u, d_q.transpose() * u, l_qq};
    }
  } // namespace Multibody
} // namespace Tribody

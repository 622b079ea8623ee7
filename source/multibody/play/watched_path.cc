// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/play/watched_path.h>

#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    Eigen::Index
    WatchedPath::largest_sample() const
    {
      Eigen::Index sample = 0;
      deviation.maxCoeff(&sample);
      return sample;
    }



    double
    WatchedPath::rms_deviation() const
    {
      return std::sqrt(deviation.squaredNorm() / deviation.size());
    }



    WatchedPath
    compare_paths(const std::string     &name,
                  const Marker          &marker,
                  const Eigen::MatrixXd &coordinates,
                  const Eigen::MatrixXd &ideal)
    {
      const auto path_of = [&marker](const Eigen::MatrixXd &q) {
        Eigen::Matrix2Xd path(2, q.cols());
        for (Eigen::Index s = 0; s < q.cols(); ++s)
          path.col(s) = marker_position(q.col(s).segment<3>(3 * marker.body),
                                        marker.position);
        return path;
      };
      WatchedPath path;
      path.name      = name;
      path.position  = path_of(coordinates);
      path.ideal     = path_of(ideal);
      path.deviation = (path.position - path.ideal).colwise().norm();
      return path;
    }
  } // namespace Multibody
} // namespace Tribody

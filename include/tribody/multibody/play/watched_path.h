// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_play_watched_path_h
#define tribody_multibody_play_watched_path_h

#include <Eigen/Core>

#include <tribody/multibody/elements/body_pair.h>

#include <string>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * The path of a marker over a cycle beside the one that it has in the same
     * mechanism with ideal joints, at the same times: what the play of the
     * joints means at the tool,
     * @f[ d(t) = |r(t) - r_\mathrm{ideal}(t)|. @f]
     * One column or entry per sample of the cycle, in global axes.
     */
    struct WatchedPath
    {
      /// "<body>.<marker>".
      std::string name;
      /// r [m].
      Eigen::Matrix2Xd position;
      /// r_ideal [m].
      Eigen::Matrix2Xd ideal;
      /// d [m].
      Eigen::VectorXd deviation;

      /// The largest d among the samples [m].
      double
      largest_deviation() const
      {
        return deviation.maxCoeff();
      }

      /// The sample that has it.
      Eigen::Index
      largest_sample() const;

      /// Root of the mean of d^2 over the samples, which have equal intervals
      /// [m].
      double
      rms_deviation() const;
    };

    /// The paths of @p marker, called @p name, where the bodies have the
    /// @p coordinates and with ideal joints those in @p ideal, a column of
    /// (x, y, phi) of each body [m, rad] per sample.
    WatchedPath
    compare_paths(const std::string     &name,
                  const Marker          &marker,
                  const Eigen::MatrixXd &coordinates,
                  const Eigen::MatrixXd &ideal);
  } // namespace Multibody
} // namespace Tribody

#endif

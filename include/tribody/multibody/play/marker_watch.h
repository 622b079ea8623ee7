// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_play_marker_watch_h
#define tribody_multibody_play_marker_watch_h

#include <Eigen/Core>

#include <tribody/multibody/elements/body_pair.h>
#include <tribody/multibody/play/watched_path.h>

#include <string>
#include <utility>
#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    class EquationsOfMotion;

    /// How the mechanism with ideal joints moves.
    enum class IdealMotion
    {
      /// As drivers prescribe: it has no degrees of freedom left.
      prescribed,
      /// In static equilibrium at each instant.
      at_rest
    };

    /**
     * Compares the paths of the markers that a mechanism lists with those of
     * the same mechanism with ideal joints, which has the positions
     * @f$ \Phi(q, t) = 0 @f$ that its drivers prescribe, or in which its forces
     * balance. Of several such positions the one nearest to where the bodies
     * are is meant: play is small beside the links.
     */
    class MarkerWatch
    {
    public:
      /// @param closed the mechanism with ideal joints, which lists the
      ///   markers; must outlive this object.
      /// @throws ExcParameter for markers that do not exist, or are of the
      ///   ground; for a motion that is prescribed while degrees of freedom are
      ///   left, naming the bodies that they move.
      MarkerWatch(const EquationsOfMotion &closed, const IdealMotion motion);

      /// One path per marker.
      /// @param times of the samples [s].
      /// @param coordinates (x, y, phi) of each body [m, rad], a column per
      ///   sample.
      /// @throws ExcRun if the mechanism cannot be closed near them.
      std::vector<WatchedPath>
      compare(const Eigen::VectorXd &times,
              const Eigen::MatrixXd &coordinates) const;

    private:
      // Near q, at time t [s].
      Eigen::VectorXd
      find_ideal(const double t, const Eigen::VectorXd &q) const;

      const EquationsOfMotion                    &closed;
      IdealMotion                                 motion;
      std::vector<std::pair<std::string, Marker>> markers;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

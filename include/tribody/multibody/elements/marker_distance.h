// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_marker_distance_h
#define tribody_multibody_elements_marker_distance_h

#include <tribody/multibody/elements/body_pair.h>

namespace Tribody
{
  namespace Multibody
  {
    /// Distance l of two markers, with its derivatives by the coordinates.
    struct MarkerDistance
    {
      /// l [m].
      double value;
      /// From the first to the second marker, length 1; zero if they coincide.
      Eigen::Vector2d direction;
      /// dl/dq [-, -, m]; zero if the markers coincide.
      PairVector gradient;
      /// d2l/dq2, symmetric; zero if the markers coincide.
      PairMatrix hessian;
    };

    /// @param s_1 and @p s_2: the markers in the frames of the two bodies.
    MarkerDistance
    compute_marker_distance(const PairVector      &q,
                            const Eigen::Vector2d &s_1,
                            const Eigen::Vector2d &s_2);
  } // namespace Multibody
} // namespace Tribody

#endif

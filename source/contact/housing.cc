// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/contact/housing.h>

namespace Tribody
{
  namespace Contact
  {
    PinGap
    append_rim(const PinGap          &bore,
               const Housing         &housing,
               const Eigen::Vector2d &ring_place)
    {
      // From outside, the housing is a pin at -d that the rim surrounds.
      const PinGap rim(housing.rim.positions, -ring_place, housing.radius);
      const Eigen::Index n = bore.gap.size() + rim.gap.size();

      PinGap both;
      both.directions.resize(2, n);
      both.distances.resize(n);
      both.gap.resize(n);
      both.directions << bore.directions, rim.directions;
      both.distances << bore.distances, rim.distances;
      both.gap << bore.gap, -rim.gap;
      return both;
    }
  } // namespace Contact
} // namespace Tribody

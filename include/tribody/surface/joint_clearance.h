// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_surface_joint_clearance_h
#define tribody_surface_joint_clearance_h

#include <tribody/surface/periodic_profile.h>

namespace Tribody
{
  /// The surfaces of a revolute joint, as worn as they are.
  struct JointClearance
  {
    JointClearance() = default;

    /// Whoever knows the bore only: the pin is as manufactured.
    JointClearance(const PeriodicProfile &bushing,
                   const PeriodicProfile &pin_wear = PeriodicProfile(0.))
      : bushing(bushing)
      , pin_wear(pin_wear)
    {}

    /// Radius of the worn bore minus that of the pin as manufactured [m], over
    /// the angle in the bushing's frame.
    PeriodicProfile bushing;
    /// What the pin's radius has lost [m], over the angle in the pin's frame.
    PeriodicProfile pin_wear;
  };
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_following_resting_pin_h
#define tribody_multibody_following_resting_pin_h

#include <Eigen/Core>

#include <tribody/multibody/joints/clearance_joint.h>

namespace Tribody
{
  namespace Multibody
  {
    class EquationsOfMotion;
    struct Motion;

    /**
     * Where a pin rests that its joint's reaction presses into the bore: the
     * normal of the contact lies at the friction angle from the reaction,
     * against the sliding, and the penetration is what force law or elastic
     * surfaces give for that force.
     */
    struct RestingPin
    {
      /// e, of the pin's centre from the bushing's [m], global axes.
      Eigen::Vector2d eccentricity = Eigen::Vector2d::Zero();
      /// n, the normal of the contact, global axes; where the pin rests on two
      /// points, that of their forces together.
      Eigen::Vector2d direction = Eigen::Vector2d::UnitX();
      /// delta [m].
      double penetration = 0.;
      /// F_N [N].
      double normal_force = 0.;
      /// Tangential over normal force [-].
      double ratio = 0.;
      /// As in JointContact, where the normal is that of the contact [m/s].
      double sliding_speed = 0.;
      /// @copydoc sliding_speed
      double swing_speed = 0.;
      /// Of the contact forces on the pin about its centre and on the bushing
      /// about its own [N m].
      Eigen::Vector2d moments = Eigen::Vector2d::Zero();
    };

    /**
     * The pin of clearance joint @p joint under @p reaction [N], on the bushing
     * in global axes.
     * @param contact of the joint in @p motion: its sliding and swing.
     * @param rate of the penetration [m/s].
     */
    RestingPin
    find_resting_pin(const EquationsOfMotion &equations,
                     const unsigned int       joint,
                     const Motion            &motion,
                     const JointContact      &contact,
                     const Eigen::Vector2d   &reaction,
                     const double             rate);
  } // namespace Multibody
} // namespace Tribody

#endif

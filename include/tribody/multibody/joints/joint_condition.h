// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_joints_joint_condition_h
#define tribody_multibody_joints_joint_condition_h

#include <tribody/multibody/joints/pin_support.h>
#include <tribody/surface/pin_in_bore.h>

#include <memory>

namespace Tribody
{
  namespace Multibody
  {
    /// What a joint with clearance has become: its worn surfaces, and how they
    /// hold the pin if its law asks for that.
    struct JointCondition
    {
      /// Worn bore and pin, with which the penetration is found.
      PinInBore surfaces;
      /// Of its elastic surfaces; null if the law does not need them.
      std::shared_ptr<const PinSupport> support = nullptr;
    };

    /**
     * The contact in a joint with elastic surfaces, or of rigid ones as seen by
     * SurfaceContact. Where a support presses, the direction is that of its
     * force, and pin and bushing touch each other in that direction, as far
     * beside the pin's centre as the support's moment asks for.
     */
    struct SupportedContact : SurfaceContact
    {
      /// Magnitude of the support's force [N].
      double elastic_force = 0.;
      /// Its gradient by (e_x, e_y, alpha) [N/m, N/m, N].
      RowVector3 d_elastic_force = RowVector3::Zero();
      /// SupportForce::magnitudes over that [-]; one without a support.
      double wrapping = 1.;
      /// Its gradient [1/m, 1/m, -].
      RowVector3 d_wrapping = RowVector3::Zero();
      /// SupportForce::energy [J].
      double energy = 0.;
    };

    /// At the place (@p e, @p alpha) in the bushing's frame.
    SupportedContact
    find_supported_contact(const JointCondition  &condition,
                           const Eigen::Vector2d &e,
                           const double           alpha);
  } // namespace Multibody
} // namespace Tribody

#endif

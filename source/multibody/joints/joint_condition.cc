// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/elements/body_pair.h>
#include <tribody/multibody/joints/joint_condition.h>

namespace Tribody
{
  namespace Multibody
  {
    SupportedContact
    find_supported_contact(const JointCondition  &condition,
                           const Eigen::Vector2d &e,
                           const double           alpha)
    {
      SupportedContact contact = {condition.surfaces.find_contact(e, alpha)};
      if (condition.support == nullptr || contact.penetration < 0.)
        return contact;
      const SupportForce support = condition.support->compute_force(e, alpha);
      const double       force   = support.force.norm();
      if (!(force > 0.))
        return contact;

      const Eigen::Vector2d n = support.force / force, t = perpendicular(n);
      contact.elastic_force   = force;
      contact.d_elastic_force = n.transpose() * support.d_force;
      contact.direction       = n;
      contact.d_direction     = t * (t.transpose() * support.d_force) / force;
      contact.force_ratio     = 1.;
      contact.d_force_ratio.setZero();
      contact.wrapping = support.magnitudes / force;
      contact.d_wrapping =
        (support.d_magnitudes - contact.wrapping * contact.d_elastic_force) /
        force;
      contact.energy = support.energy;

      const double radius = condition.surfaces.pin_radius();
      // The line of the force passes the pin's centre at this distance.
      const double offset = support.moment / force;
      contact.pin_point   = radius * n + offset * t;
      contact.d_pin_point =
        radius * contact.d_direction +
        t * (support.d_moment - offset * contact.d_elastic_force) / force -
        offset * n * (t.transpose() * contact.d_direction);
      contact.bushing_point   = e + contact.pin_point;
      contact.d_bushing_point = contact.d_pin_point;
      contact.d_bushing_point.leftCols<2>() += Eigen::Matrix2d::Identity();
      return contact;
    }
  } // namespace Multibody
} // namespace Tribody

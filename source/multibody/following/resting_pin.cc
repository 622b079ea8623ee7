// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/following/resting_pin.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>

#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // In the bushing's frame, under a normal force in the direction n.
      Eigen::Vector2d
      find_position(const ClearanceJoint  &joint,
                    const JointCondition  &condition,
                    const double           normal_force,
                    const Eigen::Vector2d &n,
                    const double           alpha,
                    const double           rate)
      {
        if (condition.support == nullptr)
          return condition.surfaces.find_position(
            n,
            compute_penetration(joint.contact_law,
                                normal_force,
                                rate,
                                joint.minimum_approach_speed),
            alpha);
        const double factor =
          compute_normal_force(joint.contact_law,
                               {1., rate, joint.minimum_approach_speed, 1.})
            .value;
        return condition.support->find_position(normal_force / factor * n,
                                                alpha);
      }



      double
      angle_of(const int body, const Eigen::VectorXd &q)
      {
        return body == ground_body ? 0. : q(3 * body + 2);
      }
    } // namespace



    RestingPin
    find_resting_pin(const EquationsOfMotion &equations,
                     const unsigned int       index,
                     const Motion            &motion,
                     const JointContact      &contact,
                     const Eigen::Vector2d   &reaction,
                     const double             rate)
    {
      const ClearanceJoint &joint =
        equations.mechanism().clearance_joints()[index];
      const double force = reaction.norm();

      // The reaction is F_N (n + ratio k x n), and the ratio that of the
      // sliding at n. Not of that in the deepest place: of two that are as deep
      // it is now the one and now the other.
      RestingPin      pin;
      Eigen::Vector2d normal =
        force > 0 ? Eigen::Vector2d(reaction / force) : contact.direction;
      double friction_ratio = 0.;
      for (unsigned int round = 0; round < 3; ++round)
        {
          pin.sliding_speed = contact.sliding_speed_at(normal);
          pin.swing_speed   = contact.swing_speed_at(normal);
          friction_ratio =
            compute_friction_ratio(joint.friction_law,
                                   pin.sliding_speed,
                                   compute_steady_friction_state(
                                     joint.friction_law, pin.sliding_speed))
              .value;
          pin.ratio = friction_ratio;
          if (force > 0)
            {
              pin.ratio += joint.tangential_damping * pin.swing_speed / force;
              normal = turned(reaction / force, -std::atan(pin.ratio));
            }
        }
      pin.normal_force           = force / std::hypot(1., pin.ratio);
      const double bushing_angle = angle_of(joint.bodies.second, motion.q);
      const double pin_angle     = angle_of(joint.bodies.first, motion.q);
      const double angle         = std::atan2(reaction.y(), reaction.x()) -
                           std::atan(pin.ratio) - bushing_angle;
      const Eigen::Vector2d n(std::cos(angle), std::sin(angle));

      const JointCondition &condition = equations.condition(index);
      const double          alpha     = pin_angle - bushing_angle;
      const Eigen::Vector2d e_in_bushing =
        find_position(joint, condition, pin.normal_force, n, alpha, rate);
      SupportedContact at =
        find_supported_contact(condition, e_in_bushing, alpha);
      // On two points, as if between them; a worn pin's normal is no radius.
      constexpr double one_point = 1e-9;
      if (1. - at.direction.dot(n) > one_point)
        {
          at.pin_point     = at.pin_point.norm() * n;
          at.bushing_point = e_in_bushing + at.pin_point;
          at.direction     = n;
        }
      pin.direction    = turned(at.direction, bushing_angle);
      pin.penetration  = at.penetration;
      pin.eccentricity = turned(e_in_bushing, bushing_angle);
      pin.moments =
        joint.compute_moments(at,
                              pin.normal_force,
                              friction_ratio * pin.normal_force,
                              (pin.ratio - friction_ratio) * pin.normal_force);
      return pin;
    }
  } // namespace Multibody
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_joints_impact_joint_h
#define tribody_multibody_joints_impact_joint_h

#include <tribody/multibody/elements/massless_link_constraint.h>

#include <memory>
#include <string>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * A revolute joint with clearance between rigid surfaces, in one of three
     * states (@cite miedema1976): the pin flies freely, @f$|e|<c@f$; it hits
     * the bushing, and the velocities jump, see IntermittentMotion; or it
     * follows the bore, held there by a constraint whose force presses. The
     * surfaces do not rub while it follows.
     */
    struct ImpactJoint
    {
      /// Index into Mechanism::joints().
      unsigned int joint;
      /// |e| - c, its derivatives and what e is.
      std::shared_ptr<const MasslessLinkConstraint> link;
      /// R_i [m].
      double pin_radius;
      /// R_j [m].
      double bushing_radius;
      /// Normal speed after an impact over that before [-].
      double restitution_coefficient;
      /// Friction in impacts [-].
      double friction_coefficient;
      /// Approach speed below which the pin does not bounce any more [m/s].
      double capture_speed;
      /// Whether it follows the bore.
      bool is_following = false;
      /// The row of its multiplier while it follows; else without meaning.
      unsigned int first_row = 0;

      /// |e| - c [m].
      double
      compute_penetration(const PairVector &q) const;

      /// Derivative of the penetration with respect to q.
      Eigen::Matrix<double, 1, 6>
      normal_row(const PairVector &q) const;

      /// Sliding speed of the surfaces, as in ClearanceJoint, is this times v
      /// in contact.
      Eigen::Matrix<double, 1, 6>
      tangential_row(const PairVector &q) const;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

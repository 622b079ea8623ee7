// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_applied_force_h
#define tribody_multibody_elements_applied_force_h

#include <tribody/multibody/elements/body_pair.h>
#include <tribody/multibody/elements/time_function.h>

namespace Tribody
{
  namespace Multibody
  {
    /// Forces of an element on one body, with their derivatives.
    struct BodyForce
    {
      /// Generalised force [N, N, N m].
      Eigen::Vector3d force;
      /// Its derivative by (x, y, phi).
      Eigen::Matrix3d d_position;
    };

    /**
     * A given force f(t) F at a marker. The vector F is fixed in global axes,
     * or in those of the body, with which it turns.
     */
    struct AppliedForce
    {
      /// Where it acts.
      Marker marker;
      /// F [N].
      Eigen::Vector2d vector;
      /// Whether F is given in the axes of the body, not in global ones.
      bool turns_with_body;
      /// f [-].
      TimeFunction function;

      /// Force at time @p t [s]. @param q coordinates of the marker's body.
      BodyForce
      compute_force(const double t, const Eigen::Vector3d &q) const;
    };

    /// A given torque f(t) M on the first body, and its reaction on the second.
    struct AppliedTorque
    {
      /// The first takes the torque, the second its reaction.
      BodyPair bodies;
      /// M [N m], positive counter-clockwise on the first body.
      double torque;
      /// f [-].
      TimeFunction function;

      /// Generalised forces at time @p t [s], (0, 0, f M) and (0, 0, -f M).
      /// They do not depend on q.
      PairVector
      compute_force(const double t) const;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

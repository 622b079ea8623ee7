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
      Marker marker;
      /// F [N].
      Eigen::Vector2d vector;
      bool            turns_with_body;
      /// f [-].
      TimeFunction function;

      /// @param q coordinates of the marker's body.
      BodyForce
      compute_force(const double t, const Eigen::Vector3d &q) const;
    };

    /// A given torque f(t) M on the first body, and its reaction on the second.
    struct AppliedTorque
    {
      BodyPair bodies;
      /// M [N m], positive counter-clockwise on the first body.
      double torque;
      /// f [-].
      TimeFunction function;

      PairVector
      compute_force(const double t) const;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/elements/applied_force.h>

namespace Tribody
{
  namespace Multibody
  {
    BodyForce
    AppliedForce::compute_force(const double t, const Eigen::Vector3d &q) const
    {
      const Eigen::Vector2d arm = turned(marker.position, q(2));
      const Eigen::Vector2d force =
        function.value(t) * (turns_with_body ? turned(vector, q(2)) : vector);

      BodyForce result = {Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero()};
      result.force << force, perpendicular(arm).dot(force);
      // A force that turns with its arm keeps its moment.
      if (turns_with_body)
        result.d_position.col(2).head<2>() = perpendicular(force);
      else
        result.d_position(2, 2) = -arm.dot(force);
      return result;
    }



    PairVector
    AppliedTorque::compute_force(const double t) const
    {
      return torque * function.value(t) *
             (PairVector::Unit(2) - PairVector::Unit(5));
    }
  } // namespace Multibody
} // namespace Tribody

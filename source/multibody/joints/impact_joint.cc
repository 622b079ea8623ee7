// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/joints/impact_joint.h>

namespace Tribody
{
  namespace Multibody
  {
    double
    ImpactJoint::compute_penetration(const PairVector &q) const
    {
      return link->value(0., q)(0);
    }



    Eigen::Matrix<double, 1, 6>
    ImpactJoint::normal_row(const PairVector &q) const
    {
      return link->jacobian(q).row(0);
    }



    Eigen::Matrix<double, 1, 6>
    ImpactJoint::tangential_row(const PairVector &q) const
    {
      Eigen::Matrix<double, 1, 6> row =
        perpendicular(link->direction(q)).transpose() *
        link->eccentricity_jacobian(q);
      row(2) += pin_radius;
      row(5) -= bushing_radius;
      return row;
    }
  } // namespace Multibody
} // namespace Tribody

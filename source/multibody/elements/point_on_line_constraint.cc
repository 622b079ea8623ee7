// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/elements/point_on_line_constraint.h>

namespace Tribody
{
  namespace Multibody
  {
    PointOnLineConstraint::PointOnLineConstraint(const std::string &description,
                                                 const Marker      &first,
                                                 const Marker      &second,
                                                 const double       axis_angle)
      : Constraint(description, {first.body, second.body}, 1)
      , s_1(first.position)
      , s_2(second.position)
      , axis_angle(axis_angle)
    {}



    Eigen::Vector2d
    PointOnLineConstraint::axis(const PairVector &q) const
    {
      return {std::cos(q(2) + axis_angle), std::sin(q(2) + axis_angle)};
    }



    Constraint::Values
    PointOnLineConstraint::value(const double /*t*/, const PairVector &q) const
    {
      const Eigen::Vector2d d =
        marker_position(q.tail<3>(), s_2) - marker_position(q.head<3>(), s_1);
      return perpendicular(axis(q)).dot(d) * Values::UnitX();
    }



    Constraint::Jacobian
    PointOnLineConstraint::jacobian(const PairVector &q) const
    {
      const Eigen::Vector2d u  = axis(q);
      const Eigen::Vector2d n  = perpendicular(u);
      const Eigen::Vector2d a2 = turned(s_2, q(5));
      // Second marker minus origin of the first body.
      const Eigen::Vector2d d = marker_position(q.tail<3>(), s_2) - q.head<2>();

      Jacobian result = Jacobian::Zero();
      result.row(0) << -n.transpose(), -u.dot(d), n.transpose(), u.dot(a2);
      return result;
    }



    PairMatrix
    PointOnLineConstraint::weighted_hessian(const PairVector &q,
                                            const Values     &weights) const
    {
      const Eigen::Vector2d u  = axis(q);
      const Eigen::Vector2d n  = perpendicular(u);
      const Eigen::Vector2d a2 = turned(s_2, q(5));
      const Eigen::Vector2d d = marker_position(q.tail<3>(), s_2) - q.head<2>();

      // Only the angles meet other coordinates.
      PairMatrix result        = PairMatrix::Zero();
      result.block<2, 1>(0, 2) = u;
      result.block<2, 1>(3, 2) = -u;
      result(5, 2)             = n.dot(a2);
      result.row(2)            = result.col(2).transpose();
      result(2, 2)             = -n.dot(d);
      result(5, 5)             = -n.dot(a2);
      return weights(0) * result;
    }



    Eigen::Vector2d
    PointOnLineConstraint::reaction_force(const PairVector &q,
                                          const Values     &multipliers) const
    {
      return -multipliers(0) * perpendicular(axis(q));
    }
  } // namespace Multibody
} // namespace Tribody

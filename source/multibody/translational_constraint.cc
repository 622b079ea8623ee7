#include <tribody/multibody/translational_constraint.h>

namespace Tribody
{
  namespace Multibody
  {
    TranslationalConstraint::TranslationalConstraint(
      const std::string &description,
      const Marker      &first,
      const Marker      &second,
      const double       axis_angle,
      const double       relative_angle)
      : Constraint(description, {first.body, second.body}, 2)
      , s_1(first.position)
      , s_2(second.position)
      , axis_angle(axis_angle)
      , relative_angle(relative_angle)
    {}



    Eigen::Vector2d
    TranslationalConstraint::axis(const PairVector &q) const
    {
      return {std::cos(q(2) + axis_angle), std::sin(q(2) + axis_angle)};
    }



    Eigen::Vector2d
    TranslationalConstraint::value(const double /*t*/,
                                   const PairVector &q) const
    {
      const Eigen::Vector2d d =
        marker_position(q.tail<3>(), s_2) - marker_position(q.head<3>(), s_1);
      return {perpendicular(axis(q)).dot(d), q(5) - q(2) - relative_angle};
    }



    Constraint::Jacobian
    TranslationalConstraint::jacobian(const PairVector &q) const
    {
      const Eigen::Vector2d u  = axis(q);
      const Eigen::Vector2d n  = perpendicular(u);
      const Eigen::Vector2d a2 = turned(s_2, q(5));
      // Second marker minus origin of the first body.
      const Eigen::Vector2d d = marker_position(q.tail<3>(), s_2) - q.head<2>();

      Jacobian result = Jacobian::Zero();
      result.row(0) << -n.transpose(), -u.dot(d), n.transpose(), u.dot(a2);
      result(1, 2) = -1.;
      result(1, 5) = 1.;
      return result;
    }



    PairMatrix
    TranslationalConstraint::weighted_hessian(
      const PairVector      &q,
      const Eigen::Vector2d &weights) const
    {
      const Eigen::Vector2d u  = axis(q);
      const Eigen::Vector2d n  = perpendicular(u);
      const Eigen::Vector2d a2 = turned(s_2, q(5));
      const Eigen::Vector2d d = marker_position(q.tail<3>(), s_2) - q.head<2>();

      // The second equation is linear. In the first, only the angles meet
      // other coordinates.
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
    TranslationalConstraint::reaction_force(
      const PairVector      &q,
      const Eigen::Vector2d &multipliers) const
    {
      return -multipliers(0) * perpendicular(axis(q));
    }
  } // namespace Multibody
} // namespace Tribody

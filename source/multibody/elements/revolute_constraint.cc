// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/elements/revolute_constraint.h>

namespace Tribody
{
  namespace Multibody
  {
    RevoluteConstraint::RevoluteConstraint(const std::string &description,
                                           const Marker      &first,
                                           const Marker      &second)
      : Constraint(description, {first.body, second.body}, 2)
      , s_1(first.position)
      , s_2(second.position)
    {}



    Constraint::Values
    RevoluteConstraint::value(const double /*t*/, const PairVector &q) const
    {
      Values result;
      result << marker_position(q.head<3>(), s_1) -
                  marker_position(q.tail<3>(), s_2),
        0.;
      return result;
    }



    Constraint::Jacobian
    RevoluteConstraint::jacobian(const PairVector &q) const
    {
      Jacobian result = Jacobian::Zero();
      result.topLeftCorner<2, 2>().setIdentity();
      result.col(2).head<2>()  = perpendicular(turned(s_1, q(2)));
      result.block<2, 2>(0, 3) = -Eigen::Matrix2d::Identity();
      result.col(5).head<2>()  = -perpendicular(turned(s_2, q(5)));
      return result;
    }



    PairMatrix
    RevoluteConstraint::weighted_hessian(const PairVector &q,
                                         const Values     &weights) const
    {
      PairMatrix result = PairMatrix::Zero();
      result(2, 2)      = -weights.head<2>().dot(turned(s_1, q(2)));
      result(5, 5)      = weights.head<2>().dot(turned(s_2, q(5)));
      return result;
    }



    Eigen::Vector2d
    RevoluteConstraint::reaction_force(const PairVector & /*q*/,
                                       const Values &multipliers) const
    {
      return multipliers.head<2>();
    }
  } // namespace Multibody
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <tribody/multibody/elements/rigid_constraint.h>

#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    RigidConstraint::RigidConstraint(const std::string &description,
                                     const Marker      &first,
                                     const Marker      &second,
                                     const double       relative_angle)
      : Constraint(description, {first.body, second.body}, 3)
      , pin(description, first, second)
      , relative_angle(relative_angle)
    {}



    Constraint::Values
    RigidConstraint::value(const double t, const PairVector &q) const
    {
      Values result = pin.value(t, q);
      // Whole turns do not count.
      result(2) =
        std::remainder(q(5) - q(2) - relative_angle, 2 * dealii::numbers::PI);
      return result;
    }



    Constraint::Jacobian
    RigidConstraint::jacobian(const PairVector &q) const
    {
      Jacobian result = pin.jacobian(q);
      result(2, 2)    = -1.;
      result(2, 5)    = 1.;
      return result;
    }



    PairMatrix
    RigidConstraint::weighted_hessian(const PairVector &q,
                                      const Values     &weights) const
    {
      // The third equation is linear.
      return pin.weighted_hessian(q, weights);
    }



    Eigen::Vector2d
    RigidConstraint::reaction_force(const PairVector &q,
                                    const Values     &multipliers) const
    {
      return pin.reaction_force(q, multipliers);
    }
  } // namespace Multibody
} // namespace Tribody

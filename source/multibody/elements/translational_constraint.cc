// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <tribody/multibody/elements/translational_constraint.h>

#include <cmath>

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
      , line(description, first, second, axis_angle)
      , relative_angle(relative_angle)
    {}



    Constraint::Values
    TranslationalConstraint::value(const double t, const PairVector &q) const
    {
      Values result = line.value(t, q);
      // Whole turns do not count.
      result(1) =
        std::remainder(q(5) - q(2) - relative_angle, 2 * dealii::numbers::PI);
      return result;
    }



    Constraint::Jacobian
    TranslationalConstraint::jacobian(const PairVector &q) const
    {
      Jacobian result = line.jacobian(q);
      result(1, 2)    = -1.;
      result(1, 5)    = 1.;
      return result;
    }



    PairMatrix
    TranslationalConstraint::weighted_hessian(const PairVector &q,
                                              const Values     &weights) const
    {
      // The second equation is linear.
      return line.weighted_hessian(q, weights);
    }



    Eigen::Vector2d
    TranslationalConstraint::reaction_force(const PairVector &q,
                                            const Values     &multipliers) const
    {
      return line.reaction_force(q, multipliers);
    }
  } // namespace Multibody
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/elements/partial_constraint.h>

namespace Tribody
{
  namespace Multibody
  {
    PartialConstraint::PartialConstraint(
      const std::shared_ptr<const Constraint> &whole,
      const Selection                         &left_out)
      : Constraint(whole->description, whole->bodies, whole->n_equations)
      , whole(whole)
      , left_out(left_out)
    {
      for (unsigned int i = 0; i < max_equations; ++i)
        kept(i) = left_out[i] ? 0. : 1.;
    }



    Constraint::Values
    PartialConstraint::value(const double t, const PairVector &q) const
    {
      return kept.cwiseProduct(whole->value(t, q));
    }



    Constraint::Jacobian
    PartialConstraint::jacobian(const PairVector &q) const
    {
      return kept.asDiagonal() * whole->jacobian(q);
    }



    PairMatrix
    PartialConstraint::weighted_hessian(const PairVector &q,
                                        const Values     &weights) const
    {
      return whole->weighted_hessian(q, kept.cwiseProduct(weights));
    }



    Constraint::Values
    PartialConstraint::time_derivative(const double t) const
    {
      return kept.cwiseProduct(whole->time_derivative(t));
    }



    Constraint::Values
    PartialConstraint::second_time_derivative(const double t) const
    {
      return kept.cwiseProduct(whole->second_time_derivative(t));
    }



    bool
    PartialConstraint::is_angle(const unsigned int i) const
    {
      return whole->is_angle(i);
    }



    bool
    PartialConstraint::is_left_out(const unsigned int i) const
    {
      return left_out[i];
    }



    Eigen::Vector2d
    PartialConstraint::reaction_force(const PairVector &q,
                                      const Values     &multipliers) const
    {
      return whole->reaction_force(q, kept.cwiseProduct(multipliers));
    }
  } // namespace Multibody
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_partial_constraint_h
#define tribody_multibody_elements_partial_constraint_h

#include <tribody/multibody/elements/constraint.h>

#include <array>
#include <memory>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * A constraint of which some equations follow from those of others and are
     * left out. They keep their rows, so that numbers do not change, but all is
     * zero there; is_left_out() tells solvers that need regular matrices.
     */
    class PartialConstraint : public Constraint
    {
    public:
      /// Which of at most max_equations are left out.
      using Selection = std::array<bool, max_equations>;

      /// Of @p whole, without its equations @p left_out.
      PartialConstraint(const std::shared_ptr<const Constraint> &whole,
                        const Selection                         &left_out);

      Values
      value(const double t, const PairVector &q) const override;

      Jacobian
      jacobian(const PairVector &q) const override;

      PairMatrix
      weighted_hessian(const PairVector &q,
                       const Values     &weights) const override;

      Values
      time_derivative(const double t) const override;

      Values
      second_time_derivative(const double t) const override;

      bool
      is_angle(const unsigned int i) const override;

      bool
      is_left_out(const unsigned int i) const override;

      Eigen::Vector2d
      reaction_force(const PairVector &q,
                     const Values     &multipliers) const override;

    private:
      const std::shared_ptr<const Constraint> whole;
      const Selection                         left_out;
      // One for each equation that is kept, otherwise zero.
      Values kept;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

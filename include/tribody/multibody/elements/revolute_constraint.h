// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_revolute_constraint_h
#define tribody_multibody_elements_revolute_constraint_h

#include <tribody/multibody/elements/constraint.h>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * An ideal revolute joint: two markers coincide,
     * @f[ \Phi = r_1 + A_1 s_1 - r_2 - A_2 s_2 = 0. @f]
     * The first body carries the pin, the second the bushing.
     */
    class RevoluteConstraint : public Constraint
    {
    public:
      /// @p first: centre of the pin, @p second: centre of the bushing.
      RevoluteConstraint(const std::string &description,
                         const Marker      &first,
                         const Marker      &second);

      Values
      value(const double t, const PairVector &q) const override;

      Jacobian
      jacobian(const PairVector &q) const override;

      PairMatrix
      weighted_hessian(const PairVector &q,
                       const Values     &weights) const override;

      bool
      is_angle(const unsigned int /*i*/) const override
      {
        return false;
      }

      Eigen::Vector2d
      reaction_force(const PairVector &q,
                     const Values     &multipliers) const override;

    private:
      const Eigen::Vector2d s_1;
      const Eigen::Vector2d s_2;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

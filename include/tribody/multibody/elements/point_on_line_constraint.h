// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_point_on_line_constraint_h
#define tribody_multibody_elements_point_on_line_constraint_h

#include <tribody/multibody/elements/constraint.h>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * The second marker stays on a line through the first, fixed in the first
     * body at the angle @f$\beta@f$, and both bodies may turn. With
     * @f$u@f$ the direction of the line,
     * @f[ \Phi = (k \times u) \cdot (p_2 - p_1) = 0. @f]
     */
    class PointOnLineConstraint : public Constraint
    {
    public:
      /// @param axis_angle beta [rad].
      PointOnLineConstraint(const std::string &description,
                            const Marker      &first,
                            const Marker      &second,
                            const double       axis_angle);

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
      Eigen::Vector2d
      axis(const PairVector &q) const;

      const Eigen::Vector2d s_1;
      const Eigen::Vector2d s_2;
      const double          axis_angle;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

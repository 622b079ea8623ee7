// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_translational_constraint_h
#define tribody_multibody_elements_translational_constraint_h

#include <tribody/multibody/elements/point_on_line_constraint.h>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * A translational joint: the second marker stays on a line through the
     * first, fixed in the first body (see PointOnLineConstraint), and the angle
     * between the bodies is locked,
     * @f[ \Phi = \begin{pmatrix} (k \times u) \cdot (p_2 - p_1) \\
     *     \varphi_2 - \varphi_1 - \varphi_{rel} \end{pmatrix} = 0. @f]
     */
    class TranslationalConstraint : public Constraint
    {
    public:
      /// @param axis_angle beta [rad]; @param relative_angle [rad].
      TranslationalConstraint(const std::string &description,
                              const Marker      &first,
                              const Marker      &second,
                              const double       axis_angle,
                              const double       relative_angle);

      Values
      value(const double t, const PairVector &q) const override;

      Jacobian
      jacobian(const PairVector &q) const override;

      PairMatrix
      weighted_hessian(const PairVector &q,
                       const Values     &weights) const override;

      bool
      is_angle(const unsigned int i) const override
      {
        return i == 1;
      }

      Eigen::Vector2d
      reaction_force(const PairVector &q,
                     const Values     &multipliers) const override;

    private:
      const PointOnLineConstraint line;
      const double                relative_angle;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

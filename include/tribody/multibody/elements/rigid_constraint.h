// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_rigid_constraint_h
#define tribody_multibody_elements_rigid_constraint_h

#include <tribody/multibody/elements/revolute_constraint.h>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * Two bodies that are welded together: two markers coincide, and the angle
     * between the bodies is locked,
     * @f[ \Phi = \begin{pmatrix} p_1 - p_2 \\
     *     \varphi_2 - \varphi_1 - \varphi_{rel} \end{pmatrix} = 0. @f]
     */
    class RigidConstraint : public Constraint
    {
    public:
      /// @param relative_angle [rad].
      RigidConstraint(const std::string &description,
                      const Marker      &first,
                      const Marker      &second,
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
        return i == 2;
      }

      Eigen::Vector2d
      reaction_force(const PairVector &q,
                     const Values     &multipliers) const override;

    private:
      const RevoluteConstraint pin;
      const double             relative_angle;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

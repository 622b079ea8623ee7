// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_massless_link_constraint_h
#define tribody_multibody_elements_massless_link_constraint_h

#include <tribody/multibody/elements/revolute_constraint.h>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * Two markers at a constant distance, @f$ \Phi = |e| - c = 0 @f$ with
     * @f$ e = r_1 + A_1 s_1 - r_2 - A_2 s_2 @f$: the clearance of a revolute
     * joint taken for a rigid link without mass or friction,
     * @cite earles1972. Its multiplier is the force along the link, positive
     * where the pin (first body) presses on the bushing (second body).
     *
     * The direction of a vector e without length is taken as that of x, so
     * that the rank of a mechanism can be looked at before it is assembled.
     */
    class MasslessLinkConstraint : public Constraint
    {
    public:
      /// @p length is the clearance c [m], positive.
      MasslessLinkConstraint(const std::string &description,
                             const Marker      &pin,
                             const Marker      &bushing,
                             const double       length);

      /// e [m], global axes.
      Eigen::Vector2d
      eccentricity(const PairVector &q) const;

      /// de/dq.
      Eigen::Matrix<double, 2, 6>
      eccentricity_jacobian(const PairVector &q) const;

      /// e/|e|.
      Eigen::Vector2d
      direction(const PairVector &q) const;

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

      /// c [m].
      const double length;

    private:
      const RevoluteConstraint ends;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

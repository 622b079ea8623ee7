#ifndef tribody_multibody_translational_constraint_h
#define tribody_multibody_translational_constraint_h

#include <tribody/multibody/constraint.h>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * A translational joint: the second marker stays on an axis through the
     * first, fixed in the first body at the angle @f$\beta@f$, and the angle
     * between the bodies is locked. With @f$u@f$ the direction of the axis,
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

      Eigen::Vector2d
      value(const double t, const PairVector &q) const override;

      Jacobian
      jacobian(const PairVector &q) const override;

      PairMatrix
      weighted_hessian(const PairVector      &q,
                       const Eigen::Vector2d &weights) const override;

      bool
      is_angle(const unsigned int i) const override
      {
        return i == 1;
      }

      Eigen::Vector2d
      reaction_force(const PairVector      &q,
                     const Eigen::Vector2d &multipliers) const override;

    private:
      Eigen::Vector2d
      axis(const PairVector &q) const;

      const Eigen::Vector2d s_1;
      const Eigen::Vector2d s_2;
      const double          axis_angle;
      const double          relative_angle;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

#ifndef tribody_multibody_angle_driver_h
#define tribody_multibody_angle_driver_h

#include <tribody/multibody/constraint.h>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * A motor of constant speed,
     * @f[ \Phi = \varphi_1 - \varphi_2 - \theta_0 - \omega t = 0. @f]
     */
    class AngleDriver : public Constraint
    {
    public:
      /// @param initial_angle [rad]; @param speed [rad/s].
      AngleDriver(const std::string &description,
                  const BodyPair    &bodies,
                  const double       initial_angle,
                  const double       speed);

      Eigen::Vector2d
      value(const double t, const PairVector &q) const override;

      Jacobian
      jacobian(const PairVector &q) const override;

      PairMatrix
      weighted_hessian(const PairVector      &q,
                       const Eigen::Vector2d &weights) const override;

      Eigen::Vector2d
      time_derivative(const double t) const override;

      bool
      is_angle(const unsigned int /*i*/) const override
      {
        return true;
      }

      /// A motor transmits a moment, no force.
      Eigen::Vector2d
      reaction_force(const PairVector      &q,
                     const Eigen::Vector2d &multipliers) const override;

    private:
      const double initial_angle;
      const double speed;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

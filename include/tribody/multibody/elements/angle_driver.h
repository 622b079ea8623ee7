// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_angle_driver_h
#define tribody_multibody_elements_angle_driver_h

#include <tribody/multibody/elements/constraint.h>
#include <tribody/multibody/elements/driver_motion.h>

namespace Tribody
{
  namespace Multibody
  {
    /// A motor that prescribes the angle @f$\theta(t)@f$ between two bodies,
    /// @f$ \Phi = \varphi_1 - \varphi_2 - \theta(t) = 0 @f$.
    class AngleDriver : public Constraint
    {
    public:
      /// @param motion theta(t) [rad].
      AngleDriver(const std::string  &description,
                  const BodyPair     &bodies,
                  const DriverMotion &motion);

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
      is_angle(const unsigned int /*i*/) const override
      {
        return true;
      }

      /// A motor transmits a moment, no force.
      Eigen::Vector2d
      reaction_force(const PairVector &q,
                     const Values     &multipliers) const override;

    private:
      const DriverMotion motion;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

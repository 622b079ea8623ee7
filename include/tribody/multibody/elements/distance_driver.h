// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_distance_driver_h
#define tribody_multibody_elements_distance_driver_h

#include <tribody/multibody/elements/constraint.h>
#include <tribody/multibody/elements/driver_motion.h>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * An actuator that prescribes the distance L(t) > 0 of two markers,
     * @f$ \Phi = |p_2 - p_1| - L(t) = 0 @f$. Where the markers coincide, its
     * derivatives do not exist.
     */
    class DistanceDriver : public Constraint
    {
    public:
      /// @param motion L(t) [m].
      DistanceDriver(const std::string  &description,
                     const Marker       &first,
                     const Marker       &second,
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
        return false;
      }

      Eigen::Vector2d
      reaction_force(const PairVector &q,
                     const Values     &multipliers) const override;

    private:
      const Eigen::Vector2d s_1;
      const Eigen::Vector2d s_2;
      const DriverMotion    motion;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

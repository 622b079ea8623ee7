// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_rotational_spring_h
#define tribody_multibody_elements_rotational_spring_h

#include <tribody/multibody/elements/pair_force.h>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * A linear rotational spring with damper. With the angle
     * @f$ \theta = \varphi_1 - \varphi_2 @f$, whole turns included, its torque
     * is @f$ M = M_0 + k (\theta - \theta_0) + d\,\dot\theta @f$: -M on the
     * first body, M on the second.
     */
    struct RotationalSpring
    {
      /// The first is that whose angle counts positive.
      BodyPair bodies;
      /// k [N m/rad].
      double stiffness;
      /// d [N m s/rad].
      double damping;
      /// theta_0 [rad].
      double reference_angle;
      /// M_0 [N m].
      double torque_at_reference_angle;

      /// Torques on the two bodies at coordinates @p q and velocities @p v.
      PairForce
      compute_force(const PairVector &q, const PairVector &v) const;

      /// Potential energy [J], zero at the reference angle.
      double
      potential_energy(const PairVector &q) const;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

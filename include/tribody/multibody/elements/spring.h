// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_spring_h
#define tribody_multibody_elements_spring_h

#include <tribody/multibody/elements/pair_force.h>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * A linear spring with damper between two markers at the distance l. Its
     * tension is @f$ T = F_0 + k (l - l_0) + d\,\dot l @f$.
     */
    struct Spring
    {
      /// The bodies that it pulls together.
      BodyPair bodies;
      /// Its end in the frame of the first body [m].
      Eigen::Vector2d s_1;
      /// Its end in the frame of the second body [m].
      Eigen::Vector2d s_2;
      /// k [N/m].
      double stiffness;
      /// d [N s/m].
      double damping;
      /// l_0 [m].
      double reference_length;
      /// F_0 [N].
      double force_at_reference_length;

      /// Forces on the two bodies at coordinates @p q and velocities @p v.
      /// None if the markers coincide: the direction is not defined then.
      PairForce
      compute_force(const PairVector &q, const PairVector &v) const;

      /// Potential energy [J], zero at the reference length.
      double
      potential_energy(const PairVector &q) const;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

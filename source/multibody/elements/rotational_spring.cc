// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/elements/rotational_spring.h>

namespace Tribody
{
  namespace Multibody
  {
    PairForce
    RotationalSpring::compute_force(const PairVector &q,
                                    const PairVector &v) const
    {
      const PairVector angle_q = PairVector::Unit(2) - PairVector::Unit(5);
      const double     torque  = torque_at_reference_angle +
                            stiffness * (angle_q.dot(q) - reference_angle) +
                            damping * angle_q.dot(v);
      return {-torque * angle_q,
              -stiffness * angle_q * angle_q.transpose(),
              -damping * angle_q * angle_q.transpose()};
    }



    double
    RotationalSpring::potential_energy(const PairVector &q) const
    {
      const double turn = q(2) - q(5) - reference_angle;
      return (torque_at_reference_angle + stiffness / 2 * turn) * turn;
    }
  } // namespace Multibody
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/elements/marker_distance.h>
#include <tribody/multibody/elements/spring.h>

namespace Tribody
{
  namespace Multibody
  {
    PairForce
    Spring::compute_force(const PairVector &q, const PairVector &v) const
    {
      const MarkerDistance distance = compute_marker_distance(q, s_1, s_2);
      const double         l        = distance.value;
      if (l == 0.)
        return {PairVector::Zero(), PairMatrix::Zero(), PairMatrix::Zero()};
      const PairVector &l_q     = distance.gradient;
      const PairMatrix &l_qq    = distance.hessian;
      const double      tension = force_at_reference_length +
                             stiffness * (l - reference_length) +
                             damping * l_q.dot(v);
      return {-tension * l_q,
              -tension * l_qq -
                l_q * (stiffness * l_q + damping * l_qq * v).transpose(),
              -damping * l_q * l_q.transpose()};
    }



    double
    Spring::potential_energy(const PairVector &q) const
    {
      const double extension =
        (marker_position(q.tail<3>(), s_2) - marker_position(q.head<3>(), s_1))
          .norm() -
        reference_length;
      return (force_at_reference_length + stiffness / 2 * extension) *
             extension;
    }
  } // namespace Multibody
} // namespace Tribody

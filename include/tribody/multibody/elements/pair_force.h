// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_pair_force_h
#define tribody_multibody_elements_pair_force_h

#include <tribody/multibody/elements/body_pair.h>

namespace Tribody
{
  namespace Multibody
  {
    /// Forces of an element on its two bodies, with their derivatives.
    struct PairForce
    {
      /// Generalised forces Q [N, N, N m] on the first and second body.
      PairVector force;
      /// dQ/dq.
      PairMatrix d_position;
      /// dQ/dv.
      PairMatrix d_velocity;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

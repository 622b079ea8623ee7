// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_case_repetition_h
#define tribody_case_repetition_h

#include <tribody/multibody/motion/dynamics_parameters.h>
#include <tribody/multibody/system/mechanism.h>

namespace Tribody
{
  namespace Coupling
  {
    /**
     * Wear goes on as in one cycle: given forces, torques and drivers must not
     * need several cycles of the dynamics to repeat, nor turn by a part of a
     * turn in a cycle that is a turn of the first driver. What never repeats is
     * taken as it is in the first cycle, unless the motion is integrated, which
     * would go on to later ones. Without wear (@p wears), what needs several
     * cycles is refused where the cycle is a turn of the first driver.
     * @throws ExcParameter naming what does not repeat, and when it would.
     */
    void
    check_repetition(const Multibody::Mechanism          &mechanism,
                     const Multibody::DynamicsParameters &parameters,
                     const bool                           wears);
  } // namespace Coupling
} // namespace Tribody

#endif

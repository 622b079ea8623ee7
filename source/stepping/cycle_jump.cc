// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/stepping/cycle_jump.h>

namespace Tribody
{
  namespace Coupling
  {
    CycleJump::CycleJump(const std::deque<WearingBushing> &bushings,
                         const StopConditions             &stop_conditions)
      : bushings(bushings)
      , stop_conditions(stop_conditions)
    {}
  } // namespace Coupling
} // namespace Tribody

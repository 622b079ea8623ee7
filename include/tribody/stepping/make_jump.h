// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_stepping_make_jump_h
#define tribody_stepping_make_jump_h

#include <tribody/stepping/cycle_jump.h>
#include <tribody/stepping/wear_parameters.h>

#include <deque>
#include <memory>

namespace Tribody
{
  namespace Coupling
  {
    /// The extrapolation that @p parameters ask for. It keeps references to
    /// @p bushings and @p stop_conditions.
    std::unique_ptr<CycleJump>
    make_jump(const WearParameters             &parameters,
              const std::deque<WearingBushing> &bushings,
              const StopConditions             &stop_conditions);
  } // namespace Coupling
} // namespace Tribody

#endif

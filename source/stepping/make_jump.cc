// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/stepping/constant_jump.h>
#include <tribody/stepping/implicit_jump.h>
#include <tribody/stepping/make_jump.h>

#include <limits>

namespace Tribody
{
  namespace Coupling
  {
    std::unique_ptr<CycleJump>
    make_jump(const WearParameters             &parameters,
              const std::deque<WearingBushing> &bushings,
              const StopConditions             &stop_conditions)
    {
      if (parameters.extrapolation == Extrapolation::constant)
        return std::make_unique<ConstantJump>(bushings,
                                              stop_conditions,
                                              parameters.cycles_per_step);
      if (parameters.extrapolation == Extrapolation::one_shot)
        return std::make_unique<ConstantJump>(
          bushings, stop_conditions, std::numeric_limits<double>::max(), true);
      return std::make_unique<ImplicitJump>(bushings,
                                            stop_conditions,
                                            parameters.tolerance);
    }
  } // namespace Coupling
} // namespace Tribody

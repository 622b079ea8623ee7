// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/stepping/cycle_jump.h>

namespace Tribody
{
  namespace Coupling
  {
    CycleJump::CycleJump(std::list<WearingBushing> &bushings,
                         const StopConditions      &stop_conditions)
      : bushings(bushings)
      , stop_conditions(stop_conditions)
    {}



    void
    CycleJump::wear(WearingBushing        &bushing,
                    BushingTotals         &totals,
                    const Eigen::VectorXd &depth,
                    const Eigen::VectorXd &removed_area)
    {
      bushing.set_depth(depth);
      std::size_t i = 0;
      for (const WearingSurface &surface : bushing.surfaces())
        totals.surfaces[i++].removed_volume +=
          surface.part_of(removed_area).sum() *
          bushing.bushing_parameters().axial_length;
    }
  } // namespace Coupling
} // namespace Tribody

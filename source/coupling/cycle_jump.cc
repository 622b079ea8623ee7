#include <tribody/coupling/cycle_jump.h>

namespace Tribody
{
  namespace Coupling
  {
    CycleJump::CycleJump(std::list<WearingBushing> &bushings,
                         const StopConditions      &stop_conditions)
      : bushings(bushings)
      , stop_conditions(stop_conditions)
    {}
  } // namespace Coupling
} // namespace Tribody

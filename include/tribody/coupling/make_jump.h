#ifndef tribody_coupling_make_jump_h
#define tribody_coupling_make_jump_h

#include <tribody/coupling/cycle_jump.h>
#include <tribody/coupling/wear_parameters.h>

#include <list>
#include <memory>

namespace Tribody
{
  namespace Coupling
  {
    /// The extrapolation that @p parameters ask for. It keeps references to
    /// @p bushings and @p stop_conditions.
    std::unique_ptr<CycleJump>
    make_jump(const WearParameters      &parameters,
              std::list<WearingBushing> &bushings,
              const StopConditions      &stop_conditions);
  } // namespace Coupling
} // namespace Tribody

#endif

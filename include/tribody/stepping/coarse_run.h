// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_stepping_coarse_run_h
#define tribody_stepping_coarse_run_h

#include <tribody/bushing/wearing_bushing.h>
#include <tribody/stepping/cycle_jump.h>
#include <tribody/stepping/mesh_error.h>
#include <tribody/stepping/run_state.h>
#include <tribody/stepping/wear_parameters.h>

#include <list>
#include <memory>
#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    /**
     * The wear of the same bushings on the next coarser meshes, see
     * coarsen_mesh(), under the duty cycles of the run that it goes along with:
     * the dynamics is not repeated. What differs is the estimate of the
     * error that the mesh makes. It is on the safe side: as the error falls
     * with the square of the cells' size or faster, that of the finer mesh is a
     * third of the difference or less.
     */
    class CoarseRun
    {
    public:
      /// @param bushings those of the run; what has no coarser mesh stays out.
      CoarseRun(const WearParameters            &parameters,
                const std::list<WearingBushing> &bushings);

      CoarseRun(const CoarseRun &) = delete;
      CoarseRun &
      operator=(const CoarseRun &) = delete;

      /// Before any wear: compare the first cycle of @p state.
      void
      start(const RunState &state, const std::list<WearingBushing> &bushings);

      /// Wear under @p cycle up to @p end [cycles], if the whole run is asked
      /// for.
      void
      follow(const Multibody::DutyCycle &cycle, const double end);

      /// The differences so far, one entry per bushing of the run.
      const std::vector<MeshError> &
      compare(const std::list<WearingBushing> &bushings);

    private:
      void
      solve_contacts();

      bool                       follows_whole_run;
      std::list<WearingBushing>  coarse;
      RunState                   state;
      StopConditions             no_conditions;
      std::unique_ptr<CycleJump> jump;

      std::vector<MeshError> errors;
    };
  } // namespace Coupling
} // namespace Tribody

#endif

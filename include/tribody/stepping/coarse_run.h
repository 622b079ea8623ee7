// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_stepping_coarse_run_h
#define tribody_stepping_coarse_run_h

#include <tribody/stepping/run_state.h>
#include <tribody/stepping/wear_parameters.h>
#include <tribody/stepping/wear_process.h>

#include <deque>
#include <mpi.h>
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
      /// @param run whose bushings have twins, where they have a coarser mesh.
      /// @param communicator of the ranks of the run, which share samples here
      ///   as there.
      CoarseRun(const WearParameters &parameters,
                const WearProcess    &run,
                const MPI_Comm       &communicator = MPI_COMM_SELF);

      /// Go on from the twin of the state of a run, with the errors seen so
      /// far.
      /// @throws ExcRun if it does not fit.
      void
      restore(const RunState               &state,
              const std::vector<MeshError> &errors_so_far);

      /// Where it stands, if it follows the whole run; else empty.
      std::vector<RunState>
      state() const;

      /// Before any wear: the first cycle of the run on coarser meshes.
      void
      start(const WearProcess &run);

      /// Wear as far as @p run has under its duty cycle, if the whole run is
      /// asked for. Called before the run renews that.
      void
      follow(const WearProcess &run);

      /// The differences so far, one entry per bushing of the run.
      const std::vector<MeshError> &
      mesh_errors() const
      {
        return errors;
      }

    private:
      /// Those of @p run, with contacts and temperatures that belong to them.
      void
      renew_duty_cycles(const WearProcess &run);

      bool        follows_whole_run;
      WearProcess twin;
      /// Which bushing of the run each of the twin's belongs to.
      std::vector<std::size_t> bushing_of_run;
      std::vector<MeshError>   errors;
    };
  } // namespace Coupling
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_run_run_cost_h
#define tribody_run_run_cost_h

#include <tribody/case/case_parameters.h>
#include <tribody/run/wear_simulation.h>

#include <chrono>
#include <ostream>

namespace Tribody
{
  namespace Coupling
  {
    /// What a run takes of wall clock, measured on its beginning.
    struct RunCost
    {
      /// Motion and contacts of the first cycle [s].
      double first_cycle = 0.;
      /// Of a wear step the motion, and the rest: contacts and wear [s].
      double step_motion = 0.;
      /// @copydoc step_motion
      double step_wear = 0.;
      /// Steps that were measured, and those that come after them: as many as
      /// 'Cycles per step' makes of the cycles, or, where the program chooses,
      /// as many as the shipped cases take.
      double n_measured = 0.;
      /// @copydoc n_measured
      double n_left = 0.;
      /// The first cycle or the first step was given up: it takes longer, and
      /// all of this is a lower bound.
      bool is_bound = false;

      /// The whole run, the measured part included [s].
      double
      total() const;
    };

    /**
     * Begin with @p simulation, of which nothing has been done, and measure.
     * @param patience on one rank, a motion that lasts longer than this [s] is
     *   given up; a wear step cannot be.
     * @throws ExcRun if the run fails there.
     */
    RunCost
    measure_cost(WearSimulation                     &simulation,
                 const CaseParameters               &parameters,
                 const std::chrono::duration<double> patience,
                 const MPI_Comm                     &communicator);

    /// Say it in a line, and where it is more than an hour what makes it so.
    void
    print_cost(std::ostream         &out,
               const RunCost        &cost,
               const CaseParameters &parameters);
  } // namespace Coupling
} // namespace Tribody

#endif

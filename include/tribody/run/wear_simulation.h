// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_run_wear_simulation_h
#define tribody_run_wear_simulation_h

#include <deal.II/base/timer.h>

#include <tribody/base/console.h>
#include <tribody/bushing/wearing_bushing.h>
#include <tribody/case/case_parameters.h>
#include <tribody/multibody/cycle/cycle_simulation.h>
#include <tribody/multibody/system/mechanism.h>
#include <tribody/output/output_directory.h>
#include <tribody/results/run_recorder.h>
#include <tribody/results/summary.h>
#include <tribody/stepping/coarse_run.h>
#include <tribody/stepping/cycle_jump.h>
#include <tribody/stepping/run_state.h>

#include <exception>
#include <functional>
#include <list>
#include <memory>
#include <mpi.h>

namespace Tribody
{
  namespace Coupling
  {
    /**
     * The chain: dynamics of one cycle, contact pressure in the bushings,
     * Archard's law, extrapolation over many cycles, worn geometry, and round
     * again (sections 2.3 and 3 of @cite mukras2010). What each of these does
     * is the matter of its module; here they only pass plain values on.
     */
    class WearSimulation
    {
    public:
      /**
       * Build everything: mechanism, meshes, compliances.
       * @param parameters must outlive this object.
       * @throws ExcRun if the mechanism cannot be assembled or a mesh made.
       */
      WearSimulation(const CaseParameters &parameters,
                     Console              &console,
                     const MPI_Comm       &communicator);

      /// Say what was built; change and write nothing. For --check.
      void
      print_setup();

      /**
       * Run all cycles and write the results to @p directory, the summary last.
       * @throws ExcRun if a part fails; the results up to there and a summary
       *   with the status "failed" are written first.
       */
      void
      run(Output::OutputDirectory &directory);

    private:
      /// @return the stop condition that ended the run, or "".
      std::string
      run_cycles(RunRecorder &recorder);

      /// By a signal, which need not reach all ranks at the same moment.
      bool
      is_interrupted() const;

      /// See RunRecorder; a failure to write stops all ranks.
      void
      record(RunRecorder &recorder);

      void
      record_fields(RunRecorder &recorder);

      /// One settled cycle of the mechanism with its worn joints, on each rank.
      void
      run_dynamics();

      /// What the contacts need of the duty cycle, so that no rounding lets the
      /// ranks drift apart.
      void
      take_forces_of_first_rank();
      /// Whether a profile has changed by more than the tolerance since then.
      bool
      dynamics_is_due() const;

      /// Contact and wear per cycle in every bushing.
      void
      solve_contacts();

      /// One step of the wear over many cycles, at most to @p end [cycles].
      /// @return index of the stop condition that was reached, or -1.
      int
      take_wear_step(const double end);

      /// Compare the first cycle with that on coarser meshes.
      void
      start_coarse_run();

      /// Let the bushings on coarser meshes wear as far as the others have.
      void
      follow_on_coarse_meshes();

      /// Do this, or say why it cannot be done and go on without.
      void
      on_coarse_meshes(const std::function<void()> &action);

      /// Add up what the last wear step has left of error, now that the rates
      /// at its end are known.
      void
      estimate_error();

      void
      count_rate_evaluations(const unsigned int n);

      void
      warn_of_unstable_step();

      /// After a failure: write what has been reached, as far as it goes.
      void
      keep_results(const Output::OutputDirectory &directory,
                   RunRecorder                   &recorder,
                   const std::exception          &exception);

      void
      write_summary(const Output::OutputDirectory &directory,
                    RunRecorder                   &recorder,
                    const std::string             &status,
                    const std::string             &message);

      const CaseParameters      &parameters;
      Console                   &console;
      MPI_Comm                   communicator;
      dealii::TimerOutput        timer;
      Multibody::Mechanism       mechanism;
      Multibody::CycleSimulation dynamics;
      std::list<WearingBushing>  bushings;
      // Of the joints with finite elements inside the dynamics, by name.
      Multibody::CycleSimulation::Supports supports;
      RunState                             state;
      StopConditions                       stop_conditions;
      std::unique_ptr<CycleJump>           jump;
      std::unique_ptr<CoarseRun>           coarse_run;
      bool                                 unstable_step_reported = false;
      /// Where the dynamics was run last [cycles], and the depths there [m].
      double cycles_at_dynamics = 0.;
      /// For how long the duty cycle or the contacts before those of now were
      /// kept, see CycleJump::estimate_error().
      double                       cycles_kept = 0.;
      std::vector<Eigen::VectorXd> depths_at_dynamics;
    };
  } // namespace Coupling
} // namespace Tribody

#endif

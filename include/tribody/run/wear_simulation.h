// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_run_wear_simulation_h
#define tribody_run_wear_simulation_h

#include <deal.II/base/timer.h>

#include <tribody/base/console.h>
#include <tribody/case/case_parameters.h>
#include <tribody/output/output_directory.h>
#include <tribody/results/run_recorder.h>
#include <tribody/results/run_results.h>
#include <tribody/run/deviation_limits.h>
#include <tribody/run/operating_case.h>
#include <tribody/stepping/coarse_run.h>
#include <tribody/stepping/wear_process.h>

#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mpi.h>
#include <string>

namespace Tribody
{
  namespace Coupling
  {
    /**
     * The chain: dynamics of one cycle, contact pressure in the bushings,
     * Archard's law, extrapolation over many cycles, worn geometry, and round
     * again (sections 2.3 and 3 of @cite mukras2010). What each of these does
     * is the matter of its module; here they only pass plain values on.
     *
     * run() does all of it and writes it down. start() and advance() do it step
     * by step: any number of simulations go on side by side, and from a state()
     * that was kept, restore() goes on with the same bits.
     */
    class WearSimulation
    {
    public:
      /**
       * Build everything: mechanism, meshes, compliances.
       * @param parameters must outlive this object, as must @p console.
       * @throws ExcRun if the mechanism cannot be assembled or a mesh made.
       */
      WearSimulation(const CaseParameters &parameters,
                     Console              &console,
                     const MPI_Comm       &communicator);

      /// Say what was built; change and write nothing. For --check.
      void
      print_setup();

      /// Motion and contacts of the first cycle.
      void
      start();

      /// Whether all cycles are done, or a stop condition was reached.
      bool
      is_over() const;

      /// One wear step, at most to @p end [cycles], with the motion where the
      /// wear has changed it, and the contacts at its end.
      void
      advance(const double end);

      /// Where it stands, after start() and after each advance().
      const RunState &
      state() const
      {
        return process.state();
      }

      /// Go on from @p state, of a simulation with the same parameters on as
      /// many ranks: each rank holds its share of the samples. All ranks must
      /// call this together.
      /// @throws ExcRun if it is not one of these parameters.
      void
      restore(const RunState &state);

      /// What has been reached; without the costs.
      RunResults
      results() const;

      /// Wall clock [s] that start() and advance() have taken so far for the
      /// parts that are named in the table at the end of a run.
      std::map<std::string, double>
      times_of_parts() const;

      /**
       * Run all cycles and write the results to @p directory, the summary last.
       * @throws ExcRun if a part fails; the results up to there and a summary
       *   with the status "failed" are written first.
       * @throws ExcInterrupted if a signal comes (see
       * watch_for_interruption()); likewise, with the status "stopped".
       */
      RunResults
      run(Output::OutputDirectory &directory);

    private:
      bool
      needs_more_samples() const;

      /// What advance() does without limits of watched markers; the motion is
      /// renewed always if there are some.
      void
      take_step(const double end);

      /// Find the moment in the step from @p before to where it stands at which
      /// a watched marker has reached its limit, and go back to it.
      void
      stop_at_deviation(const RunState &before);

      std::unique_ptr<CoarseRun>
      make_coarse_run() const;

      void
      run_cycles(RunRecorder &recorder);

      /// A signal need not reach all ranks at the same moment.
      /// @throws ExcInterrupted on all ranks if it has reached one.
      void
      stop_if_interrupted_anywhere() const;

      /// @throws ExcRun if a file has been removed, or the log is incomplete.
      void
      check_files(const Output::OutputDirectory &directory) const;

      /// One settled cycle of the mechanism with its worn joints in each load
      /// case that has a share, on each rank; wear goes on with these @p
      /// shares.
      void
      run_dynamics(const Eigen::VectorXd &shares);

      /// Of a load case, with the friction of joints as warm as they are.
      Multibody::DutyCycle
      run_case(const std::size_t                             i,
               const Multibody::CycleSimulation::Clearances &clearances,
               const Multibody::CycleSimulation::Supports   &supports,
               const Multibody::CycleSimulation::Arcs       &arcs,
               const Multibody::DutyCycle                   *before) const;

      void
      solve_contacts();

      /// Temperature, motion and contact in turn, until they belong together.
      /// @throws ExcRun if they do not come to an end.
      void
      settle_temperatures();

      /// Do this with the bushings on coarser meshes, or say why it cannot be
      /// done and go on without.
      void
      on_coarse_meshes(const std::function<void()> &action);

      void
      warn_of_unstable_step();

      /// After a failure or an interruption: write what has been reached, as
      /// far as it goes.
      void
      keep_results(const Output::OutputDirectory &directory,
                   RunRecorder                   &recorder,
                   const std::exception          &exception);

      /// Write and print what has been reached, with the costs.
      RunResults
      conclude(const Output::OutputDirectory &directory,
               const RunRecorder             &recorder,
               const RunStatus                status,
               const std::string             &message);

      const CaseParameters      &parameters;
      Console                   &console;
      MPI_Comm                   communicator;
      dealii::TimerOutput        timer;
      std::deque<OperatingCase>  cases;
      WearProcess                process;
      const DeviationLimits      deviation_limits;
      std::unique_ptr<CoarseRun> coarse_run;
    };
  } // namespace Coupling
} // namespace Tribody

#endif

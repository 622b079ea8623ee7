// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_results_run_recorder_h
#define tribody_results_run_recorder_h

#include <tribody/base/console.h>
#include <tribody/case/case_parameters.h>
#include <tribody/multibody/system/mechanism.h>
#include <tribody/output/output_directory.h>
#include <tribody/stepping/run_state.h>
#include <tribody/tables/table_writer.h>

#include <chrono>
#include <ctime>
#include <deque>
#include <memory>
#include <mpi.h>
#include <string>
#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    /**
     * Writes down what a run does while it goes: history, tables of the cycle,
     * profiles and VTU files in the output directory, progress on the console.
     * Knows nothing of how the numbers come about.
     */
    class RunRecorder
    {
    public:
      /// Nothing is written before start(), and by the first rank of
      /// @p communicator, but for meshes that the ranks share. All of them
      /// must call record() and record_fields() together.
      /// @param mechanisms of the load cases, null pointers where there is
      ///   none; they must outlive this object.
      RunRecorder(const CaseParameters                            &parameters,
                  const std::vector<const Multibody::Mechanism *> &mechanisms,
                  Output::OutputDirectory                         &directory,
                  Console                                         &console,
                  const MPI_Comm &communicator);

      /// Make the output directory, open the log, write parameters.prm.
      void
      start();

      /// Write down @p state, which was reached by the wear step
      /// state.counts.wear_steps.
      void
      record(const RunState &state, const std::deque<WearingBushing> &bushings);

      /// Cycles at which fields are to be written next.
      double
      next_output() const;

      /// Write the fields of @p state now, if record() has not just done so:
      /// for a run that ends before its time.
      void
      record_fields(const RunState                   &state,
                    const std::deque<WearingBushing> &bushings);

      /// Seconds since start().
      double
      wall_time() const;

      /// Processor time of this rank since start() [s].
      double
      cpu_time() const;

    private:
      void
      open_history(const std::string &file_name);

      std::string
      vtu_name() const;

      void
      write_fields(const RunState                   &state,
                   const std::deque<WearingBushing> &bushings);

      void
      write_history_row(const RunState                   &state,
                        const std::deque<WearingBushing> &bushings);

      // A film of the mechanism as it moves in a load case; the last one
      // stays.
      void
      write_mechanism(const std::size_t           load_case,
                      const Multibody::DutyCycle &cycle) const;

      void
      write_bushing(const RunState       &state,
                    const WearingBushing &bushing,
                    const CycleContact   &contact);

      void
      write_pin(const RunState &state, const WearingBushing &bushing) const;

      void
      print_progress(const RunState                   &state,
                     const std::deque<WearingBushing> &bushings);

      const CaseParameters                     &parameters;
      std::vector<const Multibody::Mechanism *> mechanisms;
      Output::OutputDirectory                  &directory;
      Console                                  &console;
      MPI_Comm                                  communicator;
      bool                                      writes;

      std::unique_ptr<TableWriter> history;
      /// Fields written so far, and at which cycle the last were.
      unsigned int n_outputs      = 0;
      double       last_output_at = -1.;
      /// VTU files by cycle, for each bushing.
      std::vector<std::vector<std::pair<double, std::string>>> vtu_files;

      std::chrono::steady_clock::time_point started_at;
      std::clock_t                          processor_started_at = 0;
      std::chrono::steady_clock::time_point progress_printed_at;
    };
  } // namespace Coupling
} // namespace Tribody

#endif

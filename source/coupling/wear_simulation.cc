#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <tribody/base/exceptions.h>
#include <tribody/coupling/run_summary.h>
#include <tribody/coupling/wear_simulation.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <map>
#include <sstream>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // Of the stable length, when the program chooses the wear step: far
      // enough below it that a sawtooth decays.
      constexpr double safe_fraction_of_stable_step = 0.8;
    } // namespace



    WearSimulation::WearSimulation(const CaseParameters &parameters,
                                   Console              &console,
                                   const MPI_Comm       &communicator)
      : parameters(parameters)
      , console(console)
      , communicator(communicator)
      , timer(console.out(),
              dealii::TimerOutput::never,
              dealii::TimerOutput::wall_times)
      , mechanism(parameters.mechanism)
      , dynamics(mechanism, parameters.dynamics)
    {
      dealii::TimerOutput::Scope scope(timer, "set up bushings");
      if (parameters.cycles > 0)
        for (const BushingParameters &bushing : parameters.bushings)
          bushings.emplace_back(bushing,
                                parameters.joint(bushing.name),
                                parameters.wear.compliance_update);

      state.totals.resize(bushings.size());
      state.contact_losses.resize(mechanism.parameters().joints.size());
    }



    void
    WearSimulation::print_setup()
    {
      std::ostream &out = console.out();
      out << "Mechanism: " << parameters.mechanism.bodies.size() << " bodies, "
          << parameters.mechanism.joints.size() << " joints, "
          << mechanism.n_degrees_of_freedom() << " degrees of freedom"
          << std::endl;
      for (const WearingBushing &bushing : bushings)
        out << "Bushing " << bushing.name() << ": "
            << bushing.node_angles().size() << " bore nodes, clearance "
            << 1e3 * bushing.clearance_profile().mean() << " mm" << std::endl;
    }



    void
    WearSimulation::run(const Output::OutputDirectory &directory)
    {
      RunRecorder recorder(parameters,
                           directory,
                           console,
                           dealii::Utilities::MPI::this_mpi_process(
                             communicator) == 0);
      recorder.start();
      try
        {
          run_cycles(recorder);
        }
      catch (const ExcRun &exception)
        {
          write_summary(directory, recorder, "failed", message_of(exception));
          throw;
        }
      write_summary(directory, recorder, "completed", "");
      timer.print_summary();
    }



    void
    WearSimulation::write_summary(const Output::OutputDirectory &directory,
                                  RunRecorder                   &recorder,
                                  const std::string             &status,
                                  const std::string             &message)
    {
      // What was reached before a failure is kept, as far as it goes.
      if (status == "failed" && state.contacts.size() == bushings.size() &&
          state.counts.rate_evaluations > 0)
        recorder.record_fields(state, bushings);

      Output::RunSummary summary =
        make_run_summary(parameters, state, bushings);
      summary.status    = status;
      summary.message   = message;
      summary.wall_time = recorder.wall_time();
      summary.cpu_time  = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
      dealii::Utilities::System::MemoryStats memory;
      dealii::Utilities::System::get_memory_stats(memory);
      summary.peak_memory_bytes = 1024. * memory.VmHWM;

      if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
        Output::write_summary_json(directory.file("summary.json"), summary);
      print_results(console.out(), summary);
    }



    void
    WearSimulation::run_cycles(RunRecorder &recorder)
    {
      run_dynamics();
      solve_contacts();
      recorder.record(state, bushings);

      while (state.cycles < parameters.cycles)
        {
          const double                    n_cycles = choose_wear_step();
          const std::vector<CycleContact> before   = state.contacts;

          wear(n_cycles);
          run_dynamics();
          solve_contacts();

          for (std::size_t b = 0; b < state.totals.size(); ++b)
            state.totals[b].error_estimate.add_step(before[b].wear_rate,
                                                    state.contacts[b].wear_rate,
                                                    n_cycles);
          recorder.record(state, bushings);
        }
    }



    void
    WearSimulation::run_dynamics()
    {
      dealii::TimerOutput::Scope scope(timer, "dynamics");

      std::map<std::string, ClearanceProfile> clearances;
      for (const WearingBushing &bushing : bushings)
        clearances.emplace(bushing.name(), bushing.clearance_profile());
      state.duty_cycle = dynamics.run(clearances);

      ++state.counts.dynamics_cycles;
      state.constraint_drift =
        std::max(state.constraint_drift, state.duty_cycle.constraint_drift);
      state.all_settled =
        state.all_settled && state.duty_cycle.settling.converged;
      for (std::size_t j = 0; j < state.contact_losses.size(); ++j)
        state.contact_losses[j] += state.duty_cycle.joints[j].n_losses;
    }



    void
    WearSimulation::solve_contacts()
    {
      dealii::TimerOutput::Scope scope(timer, "contact");

      state.contacts.clear();
      for (const WearingBushing &bushing : bushings)
        {
          state.contacts.push_back(bushing.compute_cycle_contact(
            state.duty_cycle.joint(bushing.name())));
          state.counts.contact_solves += state.contacts.back().n_solves;
        }
      ++state.counts.rate_evaluations;
    }



    double
    WearSimulation::choose_wear_step()
    {
      // The bound follows the compliance, and costs an eigenvalue problem.
      unsigned int n_builds = 0;
      for (const WearingBushing &bushing : bushings)
        n_builds += bushing.n_compliance_builds();
      if (n_builds != stable_step_builds)
        {
          dealii::TimerOutput::Scope scope(timer, "stable wear step");
          state.max_stable_step = std::numeric_limits<double>::max();
          for (const WearingBushing &bushing : bushings)
            if (bushing.bushing_parameters().wear_coefficient > 0.)
              state.max_stable_step = std::min(
                state.max_stable_step,
                bushing.max_stable_step(
                  state.duty_cycle.joint(bushing.name()).sliding_distance()));
          stable_step_builds = n_builds;
        }

      Wear::ConstantExtrapolation extrapolation{
        parameters.wear.cycles_per_step};
      if (extrapolation.cycles_per_step == 0.)
        extrapolation.cycles_per_step = std::max(
          1., std::floor(safe_fraction_of_stable_step * state.max_stable_step));
      else if (extrapolation.cycles_per_step > state.max_stable_step &&
               !unstable_step_reported)
        {
          console.out() << "WARNING: 'Wear/Cycles per step' = "
                        << extrapolation.cycles_per_step
                        << " is longer than explicit steps are stable for on "
                           "this mesh, about "
                        << state.max_stable_step
                        << ": pressure and depth will oscillate from node to "
                           "node. Choose shorter steps or a coarser mesh."
                        << std::endl;
          unstable_step_reported = true;
        }
      return extrapolation.next_step(state.cycles, parameters.cycles);
    }



    void
    WearSimulation::wear(const double n_cycles)
    {
      dealii::TimerOutput::Scope scope(timer, "worn geometry, compliance");

      std::size_t b = 0;
      for (WearingBushing &bushing : bushings)
        {
          bushing.wear_by(n_cycles * state.contacts[b].wear_rate);
          state.totals[b].removed_volume +=
            n_cycles * state.contacts[b].removed_area.sum() *
            bushing.bushing_parameters().axial_length;
          state.totals[b].sliding_distance +=
            n_cycles *
            state.duty_cycle.joint(bushing.name()).sliding_distance();
          ++b;
        }
      state.cycles += n_cycles;
      ++state.counts.wear_steps;
    }
  } // namespace Coupling
} // namespace Tribody

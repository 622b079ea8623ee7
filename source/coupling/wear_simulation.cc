#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/interruption.h>
#include <tribody/coupling/constant_jump.h>
#include <tribody/coupling/implicit_jump.h>
#include <tribody/coupling/run_summary.h>
#include <tribody/coupling/wear_simulation.h>
#include <tribody/multibody/significant_digits.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <string>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      std::unique_ptr<CycleJump>
      make_jump(const WearParameters      &parameters,
                std::list<WearingBushing> &bushings,
                const StopConditions      &stop_conditions)
      {
        if (parameters.extrapolation == "constant")
          return std::make_unique<ConstantJump>(bushings,
                                                stop_conditions,
                                                parameters.cycles_per_step);
        if (parameters.extrapolation == "one-shot")
          return std::make_unique<ConstantJump>(
            bushings,
            stop_conditions,
            std::numeric_limits<double>::max(),
            true);
        return std::make_unique<ImplicitJump>(bushings,
                                              stop_conditions,
                                              parameters.tolerance);
      }



      // What 'Energy balance = without wear' means here.
      Multibody::DynamicsParameters
      make_dynamics_parameters(const CaseParameters &parameters)
      {
        Multibody::DynamicsParameters dynamics = parameters.dynamics;
        if (dynamics.energy_balance == "without wear")
          dynamics.energy_balance = parameters.cycles == 0 ? "always" : "never";
        return dynamics;
      }



      std::list<WearingBushing>
      make_bushings(const CaseParameters &parameters)
      {
        std::list<WearingBushing> bushings;
        if (parameters.cycles > 0)
          for (const BushingParameters &bushing : parameters.bushings)
            bushings.emplace_back(bushing,
                                  parameters.joint(bushing.name),
                                  parameters.wear.compliance_update);
        return bushings;
      }
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
      , dynamics(mechanism, make_dynamics_parameters(parameters))
      , bushings(make_bushings(parameters))
      , stop_conditions(bushings)
      , jump(make_jump(parameters.wear, bushings, stop_conditions))
    {
      state.totals.resize(bushings.size());
      std::size_t b = 0;
      for (const WearingBushing &bushing : bushings)
        state.totals[b++].depth_error =
          Eigen::VectorXd::Zero(bushing.profile().depth.size());
      state.contact_losses.resize(mechanism.parameters().joints.size());
    }



    void
    WearSimulation::print_setup()
    {
      std::ostream &out = console.out();
      const auto    count =
        [&out](const std::size_t n, const char *one, const char *many) {
          out << n << ' ' << (n == 1 ? one : many);
        };
      out << "Mechanism: ";
      count(parameters.mechanism.bodies.size(), "body, ", "bodies, ");
      count(parameters.mechanism.joints.size(), "joint, ", "joints, ");
      count(mechanism.n_degrees_of_freedom(),
            "degree of freedom",
            "degrees of freedom");
      out << std::endl;
      for (const WearingBushing &bushing : bushings)
        out << "Bushing " << bushing.name() << ": "
            << bushing.node_angles().size() << " bore nodes, clearance "
            << 1e3 * bushing.clearance_profile().mean() << " mm, "
            << (bushing.has_elastic_pin() ? "elastic" : "rigid")
            << " pin (modulus "
            << Multibody::significant_digits(
                 bushing.joint_parameters().pin_material.youngs_modulus /
                   bushing.joint_parameters().bushing_material.youngs_modulus,
                 3)
            << " times the bushing's)" << std::endl;
    }



    void
    WearSimulation::run(Output::OutputDirectory &directory)
    {
      RunRecorder recorder(parameters,
                           mechanism,
                           directory,
                           console,
                           dealii::Utilities::MPI::this_mpi_process(
                             communicator) == 0);
      recorder.start();
      watch_for_interruption();
      try
        {
          const std::string reached = run_cycles(recorder);
          write_summary(directory,
                        recorder,
                        reached.empty() ? "completed" : "stopped",
                        reached);
        }
      catch (const std::exception &exception)
        {
          keep_results(directory, recorder, exception);
          throw;
        }
      if (parameters.cycles > 0)
        timer.print_summary();
      AssertThrow(!was_interrupted(),
                  ExcRun("It was interrupted; the results up to there are "
                         "written."));
    }



    void
    WearSimulation::keep_results(const Output::OutputDirectory &directory,
                                 RunRecorder                   &recorder,
                                 const std::exception          &exception)
    {
      const auto *ours =
        dynamic_cast<const dealii::ExceptionBase *>(&exception);
      const std::string message =
        ours != nullptr ? message_of(*ours) : exception.what();
      // What made the run fail may make this fail too, a full disk for example;
      // the first failure is the one to report.
      try
        {
          write_summary(directory, recorder, "failed", message);
          recorder.record_fields(state, bushings);
        }
      catch (const std::exception &)
        {}
    }



    void
    WearSimulation::write_summary(const Output::OutputDirectory &directory,
                                  RunRecorder                   &recorder,
                                  const std::string             &status,
                                  const std::string             &message)
    {
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



    std::string
    WearSimulation::run_cycles(RunRecorder &recorder)
    {
      run_dynamics();
      solve_contacts();
      recorder.record(state, bushings);

      while (state.cycles < parameters.cycles)
        {
          const double cycles_before = state.cycles;
          const int    reached       = take_wear_step(recorder.next_output());
          double       cycles_kept   = state.cycles - cycles_before;
          if (reached >= 0 || state.cycles >= parameters.cycles ||
              dynamics_is_due())
            {
              cycles_kept = state.cycles - cycles_at_dynamics;
              run_dynamics();
            }
          solve_contacts();
          estimate_error(cycles_kept);
          if (reached >= 0)
            {
              recorder.record_fields(state, bushings);
              return stop_conditions.describe(reached);
            }
          recorder.record(state, bushings);
          if (was_interrupted())
            {
              recorder.record_fields(state, bushings);
              return "interrupted by a signal";
            }
        }
      return "";
    }



    int
    WearSimulation::take_wear_step(const double end)
    {
      dealii::TimerOutput::Scope scope(timer, "wear step");

      const double       cycles_before = state.cycles;
      const unsigned int n_before      = jump->n_rate_evaluations();
      const int          reached       = jump->advance(state, end);
      count_rate_evaluations(jump->n_rate_evaluations() - n_before);
      warn_of_unstable_step();

      std::size_t b = 0;
      for (const WearingBushing &bushing : bushings)
        {
          const Multibody::JointDutyCycle &cycle =
            state.duty_cycle.joint(bushing.name());
          const double distance =
            (state.cycles - cycles_before) * cycle.sliding_distance();
          state.totals[b].sliding_distance += distance;
          state.totals[b].force_over_sliding +=
            distance * cycle.mean_normal_force();
          ++b;
        }
      ++state.counts.wear_steps;
      return reached;
    }



    void
    WearSimulation::count_rate_evaluations(const unsigned int n)
    {
      state.counts.rate_evaluations += n;
      for (const CycleContact &contact : state.contacts)
        state.counts.contact_solves += n * contact.samples.size();
    }



    void
    WearSimulation::warn_of_unstable_step()
    {
      if (unstable_step_reported || state.max_stable_step == 0. ||
          parameters.wear.cycles_per_step <= state.max_stable_step)
        return;
      unstable_step_reported = true;
      console.out() << "WARNING: 'Wear/Cycles per step' = "
                    << parameters.wear.cycles_per_step
                    << " is longer than explicit steps are stable for on this "
                       "mesh, about "
                    << state.max_stable_step
                    << ": pressure and depth will oscillate from node to node. "
                       "Choose shorter steps, a coarser mesh, or 'set "
                       "Extrapolation = implicit'."
                    << std::endl;
    }



    void
    WearSimulation::estimate_error(const double cycles_kept)
    {
      // Absolute values: an oscillation must not cancel in the sum.
      const std::vector<StepError> errors =
        jump->estimate_error(state.contacts, cycles_kept);
      for (std::size_t b = 0; b < state.totals.size(); ++b)
        {
          state.totals[b].depth_error += errors[b].depth.cwiseAbs();
          state.totals[b].volume_error += std::abs(errors[b].volume);
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

      cycles_at_dynamics = state.cycles;
      depths_at_dynamics.clear();
      for (const WearingBushing &bushing : bushings)
        depths_at_dynamics.push_back(bushing.profile().depth);

      const Multibody::SettlingReport &settling = state.duty_cycle.settling;
      state.counts.dynamics_cycles += settling.n_cycles;
      if (!settling.message.empty() && state.settling_message.empty())
        {
          // Without wear, the results say it right away.
          std::ostringstream message;
          if (parameters.cycles > 0)
            message << "after " << state.cycles << " cycles: ";
          message << settling.message;
          state.settling_message = message.str();
          if (parameters.cycles > 0)
            console.out() << "WARNING: dynamics " << state.settling_message
                          << "." << std::endl;
        }
      state.constraint_drift =
        std::max(state.constraint_drift, state.duty_cycle.constraint_drift);
      state.all_settled = state.all_settled && settling.converged;
      for (std::size_t j = 0; j < state.contact_losses.size(); ++j)
        state.contact_losses[j] += state.duty_cycle.joints[j].n_losses;
    }



    bool
    WearSimulation::dynamics_is_due() const
    {
      bool        is_due = false;
      std::size_t b      = 0;
      for (const WearingBushing &bushing : bushings)
        {
          const Multibody::JointParameters &joint = bushing.joint_parameters();
          const Wear::WearProfile          &worn  = bushing.profile();
          const double                      clearance =
            joint.bushing_radius - joint.pin_radius + worn.max_depth();
          const double change =
            (worn.depth - depths_at_dynamics[b++]).lpNorm<Eigen::Infinity>();
          is_due =
            is_due || change > parameters.wear.dynamics_update * clearance;
        }
      return is_due;
    }



    void
    WearSimulation::solve_contacts()
    {
      dealii::TimerOutput::Scope scope(timer, "contact");

      std::size_t b = 0;
      for (const WearingBushing &bushing : bushings)
        {
          const Multibody::JointDutyCycle &cycle =
            state.duty_cycle.joint(bushing.name());
          const bool         is_first = state.contacts.size() <= b;
          const CycleContact contact =
            bushing.compute_cycle_contact(bushing.profile().depth,
                                          cycle,
                                          is_first ? nullptr
                                                   : &state.contacts[b]);
          if (is_first)
            state.contacts.push_back(contact);
          else
            state.contacts[b] = contact;
          ++b;
        }
      count_rate_evaluations(1);
    }
  } // namespace Coupling
} // namespace Tribody

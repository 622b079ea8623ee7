// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/interruption.h>
#include <tribody/base/ranks.h>
#include <tribody/base/significant_digits.h>
#include <tribody/bushing/mesh_resolution.h>
#include <tribody/results/run_summary.h>
#include <tribody/run/make_unworn_supports.h>
#include <tribody/run/wear_simulation.h>
#include <tribody/stepping/make_jump.h>

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
      // What 'Energy balance = without wear' means here.
      Multibody::DynamicsParameters
      make_dynamics_parameters(const CaseParameters &parameters)
      {
        Multibody::DynamicsParameters dynamics = parameters.dynamics;
        if (dynamics.energy_balance == Multibody::EnergyBalance::without_wear)
          dynamics.energy_balance = parameters.cycles == 0
                                      ? Multibody::EnergyBalance::always
                                      : Multibody::EnergyBalance::never;
        return dynamics;
      }



      // Where they are more than those of the joints: a ring in a housing
      // follows the pin until it touches that.
      Multibody::CycleSimulation::Clearances
      make_unworn_clearances(const CaseParameters &parameters)
      {
        Multibody::CycleSimulation::Clearances clearances;
        for (const BushingParameters &bushing : parameters.bushings)
          {
            const Multibody::JointParameters &joint =
              parameters.joint(bushing.name);
            const double gap = bushing.rim_support.housing_gap;
            if (gap > 0. && joint.has_contact_law())
              clearances.emplace(bushing.name,
                                 JointClearance{PeriodicProfile(
                                                  joint.clearance() + gap),
                                                PeriodicProfile(0.)});
          }
        return clearances;
      }

      // Unworn. If a mesh is to be as fine as the contact wants it, a cycle of
      // the dynamics says how large that is.
      std::list<WearingBushing>
      make_bushings(const CaseParameters             &parameters,
                    const Multibody::CycleSimulation &dynamics,
                    const MPI_Comm                   &communicator)
      {
        std::list<WearingBushing> bushings;
        if (parameters.cycles == 0)
          return bushings;
        const bool needs_forces =
          std::any_of(parameters.bushings.begin(),
                      parameters.bushings.end(),
                      [](const BushingParameters &bushing) {
                        return bushing.mesh.n_contact_nodes > 0;
                      });
        Multibody::DutyCycle first_cycle;
        if (needs_forces)
          first_cycle = dynamics.run(make_unworn_clearances(parameters),
                                     make_unworn_supports(parameters));
        for (const BushingParameters &bushing : parameters.bushings)
          {
            const Multibody::JointParameters &joint =
              parameters.joint(bushing.name);
            bushings.emplace_back(needs_forces
                                    ? resolve_contact_arc(bushing,
                                                          joint,
                                                          first_cycle.joint(
                                                            bushing.name))
                                    : bushing,
                                  joint,
                                  parameters.wear.compliance_update,
                                  communicator);
          }
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
      , bushings(make_bushings(parameters, dynamics, communicator))
      , supports(parameters.cycles == 0
                   ? make_unworn_supports(parameters)
                   : Multibody::CycleSimulation::Supports())
      , stop_conditions(bushings)
      , jump(make_jump(parameters.wear, bushings, stop_conditions))
    {
      state.totals.resize(bushings.size());
      std::size_t b = 0;
      for (const WearingBushing &bushing : bushings)
        state.totals[b++].depth_error =
          Eigen::VectorXd::Zero(bushing.depth().size());
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
            << name_of(bushing.bushing_parameters().pressure_model)
            << " pressure model, "
            << (bushing.has_elastic_pin() ? "elastic" : "rigid")
            << " pin (modulus "
            << significant_digits(
                 bushing.joint_parameters().pin_material.youngs_modulus /
                   bushing.joint_parameters().bushing_material.youngs_modulus,
                 3)
            << " times the bushing's)"
            << (bushing.wearing_pin() != nullptr ? ", which wears" : "")
            << std::endl;
    }



    void
    WearSimulation::run(Output::OutputDirectory &directory)
    {
      RunRecorder recorder(
        parameters, mechanism, directory, console, communicator);
      Ranks::run_together(communicator, [&]() { recorder.start(); });
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
      AssertThrow(!is_interrupted(),
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
          if (ours == nullptr)
            {
              // Perhaps on this rank only, which must not wait for others.
              write_summary(directory, recorder, "failed", message);
              return;
            }
          Ranks::run_together(communicator, [&]() {
            write_summary(directory, recorder, "failed", message);
          });
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
      RunSummary summary = make_run_summary(parameters, state, bushings);
      summary.status     = status;
      summary.message    = message;
      summary.wall_time  = recorder.wall_time();
      summary.cpu_time   = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
      dealii::Utilities::System::MemoryStats memory;
      dealii::Utilities::System::get_memory_stats(memory);
      summary.peak_memory_bytes = 1024. * memory.VmHWM;

      if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
        write_summary_json(directory.file("summary.json"), summary);
      print_results(console.out(), summary);
    }



    bool
    WearSimulation::is_interrupted() const
    {
      return dealii::Utilities::MPI::max(was_interrupted() ? 1 : 0,
                                         communicator) > 0;
    }



    void
    WearSimulation::record(RunRecorder &recorder)
    {
      recorder.record(state, bushings);
    }



    void
    WearSimulation::record_fields(RunRecorder &recorder)
    {
      recorder.record_fields(state, bushings);
    }



    std::string
    WearSimulation::run_cycles(RunRecorder &recorder)
    {
      run_dynamics();
      solve_contacts();
      start_coarse_run();
      record(recorder);

      while (state.cycles < parameters.cycles)
        {
          const int reached = take_wear_step(recorder.next_output());
          follow_on_coarse_meshes();
          if (reached >= 0 || state.cycles >= parameters.cycles ||
              dynamics_is_due())
            run_dynamics();
          solve_contacts();
          estimate_error();
          if (reached >= 0)
            {
              record_fields(recorder);
              return stop_conditions.describe(reached);
            }
          record(recorder);
          if (is_interrupted())
            {
              record_fields(recorder);
              return "interrupted by a signal";
            }
        }
      return "";
    }



    void
    WearSimulation::start_coarse_run()
    {
      if (parameters.wear.mesh_error_estimate == MeshErrorEstimate::none ||
          bushings.empty())
        return;
      on_coarse_meshes([this]() {
        coarse_run = std::make_unique<CoarseRun>(parameters.wear, bushings);
        coarse_run->start(state, bushings);
      });
    }



    void
    WearSimulation::follow_on_coarse_meshes()
    {
      if (coarse_run != nullptr)
        on_coarse_meshes(
          [this]() { coarse_run->follow(state.duty_cycle, state.cycles); });
    }



    void
    WearSimulation::on_coarse_meshes(const std::function<void()> &action)
    {
      dealii::TimerOutput::Scope scope(timer, "coarser meshes");
      try
        {
          action();
          state.mesh_errors = coarse_run->compare(bushings);
        }
      catch (const ExcRun &exception)
        {
          // The run itself does not need it.
          coarse_run.reset();
          state.mesh_errors.clear();
          console.out() << "WARNING: no estimate of the error of the mesh, as "
                           "the next coarser one fails: "
                        << message_of(exception) << std::endl;
        }
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
      cycles_kept = state.cycles - cycles_before;

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
    WearSimulation::estimate_error()
    {
      // Absolute values: an oscillation must not cancel in the sum.
      const std::vector<StepError> errors =
        jump->estimate_error(state.contacts, cycles_kept);
      for (std::size_t b = 0; b < state.totals.size(); ++b)
        {
          state.totals[b].depth_error += errors[b].depth.cwiseAbs();
          for (std::size_t i = 0; i < errors[b].volumes.size(); ++i)
            state.totals[b].surfaces[i].volume_error +=
              std::abs(errors[b].volumes[i]);
        }
    }



    void
    WearSimulation::run_dynamics()
    {
      dealii::TimerOutput::Scope scope(timer, "dynamics");

      auto clearances = make_unworn_clearances(parameters);
      for (const WearingBushing &bushing : bushings)
        {
          clearances.insert_or_assign(bushing.name(), bushing.clearance());
          if (bushing.joint_parameters().needs_support())
            supports[bushing.name()] = bushing.make_support();
        }
      Ranks::run_together(communicator, [&]() {
        state.duty_cycle = dynamics.run(clearances, supports);
      });
      take_forces_of_first_rank();

      cycles_kept        = state.cycles - cycles_at_dynamics;
      cycles_at_dynamics = state.cycles;
      depths_at_dynamics.clear();
      for (const WearingBushing &bushing : bushings)
        depths_at_dynamics.push_back(bushing.depth());

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
          const Eigen::VectorXd depth = bushing.depth();
          const double          change =
            (depth - depths_at_dynamics[b++]).lpNorm<Eigen::Infinity>();
          is_due = is_due || change > parameters.wear.dynamics_update *
                                        bushing.largest_clearance(depth);
        }
      return is_due;
    }



    void
    WearSimulation::take_forces_of_first_rank()
    {
      for (Multibody::JointDutyCycle &joint : state.duty_cycle.joints)
        for (Eigen::VectorXd *field : {&joint.normal_force,
                                       &joint.contact_angle_bushing,
                                       &joint.contact_angle_pin,
                                       &joint.sliding_increment,
                                       &joint.sliding_speed})
          Ranks::broadcast(*field, 0, communicator);
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
            bushing.compute_cycle_contact(bushing.depth(),
                                          cycle,
                                          is_first ? nullptr
                                                   : &state.contacts[b],
                                          state.totals[b].sliding_distance);
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

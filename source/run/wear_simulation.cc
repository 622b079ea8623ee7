// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/base/foreign_exceptions.h>
#include <tribody/base/interruption.h>
#include <tribody/base/ranks.h>
#include <tribody/base/significant_digits.h>
#include <tribody/bushing/memory_estimate.h>
#include <tribody/bushing/mesh_resolution.h>
#include <tribody/multibody/assembly/redundancy.h>
#include <tribody/results/printed_summary.h>
#include <tribody/results/summary_json.h>
#include <tribody/run/make_unworn_supports.h>
#include <tribody/run/wear_simulation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <new>
#include <sstream>
#include <string>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // What 'Energy balance = without wear', 'Joint motion = automatic',
      // 'Accuracy' and 'Sampling tolerance' mean here.
      Multibody::DynamicsParameters
      make_dynamics_parameters(const CaseParameters &parameters)
      {
        Multibody::DynamicsParameters dynamics = parameters.dynamics;
        if (dynamics.energy_balance == Multibody::EnergyBalance::without_wear)
          dynamics.energy_balance = parameters.cycles == 0
                                      ? Multibody::EnergyBalance::always
                                      : Multibody::EnergyBalance::never;
        // Energies ask more of the motion than wear does.
        if (dynamics.accuracy == 0. &&
            dynamics.energy_balance == Multibody::EnergyBalance::always)
          dynamics.accuracy = Multibody::DynamicsParameters().accuracy;
        if (parameters.cycles > 0)
          return dynamics;
        dynamics.sampling_tolerance = 0.;
        if (dynamics.accuracy == 0.)
          dynamics.accuracy = Multibody::DynamicsParameters().accuracy;
        if (dynamics.joint_motion == Multibody::JointMotion::automatic)
          dynamics.joint_motion = Multibody::JointMotion::dynamic;
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

      // What the contacts need of the duty cycle, so that no rounding lets the
      // ranks drift apart.
      void
      take_forces_of_first_rank(Multibody::DutyCycle &cycle,
                                const MPI_Comm       &communicator)
      {
        for (Multibody::JointDutyCycle &joint : cycle.joints)
          for (Eigen::VectorXd *field : {&joint.normal_force,
                                         &joint.contact_angle_bushing,
                                         &joint.contact_angle_pin,
                                         &joint.sliding_increment,
                                         &joint.sliding_speed,
                                         &joint.force_between,
                                         &joint.angle_between,
                                         &joint.sliding_halves,
                                         &joint.eccentricity,
                                         &joint.penetration})
            Ranks::broadcast(*field, 0, communicator);
        for (Multibody::WatchedPath &path : cycle.watched_paths)
          Ranks::broadcast(path.deviation, 0, communicator);
      }



      // Unworn. If a mesh is to be as fine as the contact wants it, a cycle of
      // the dynamics says how large that is.
      std::deque<WearingBushing>
      make_bushings(const CaseParameters             &parameters,
                    const Multibody::CycleSimulation &dynamics,
                    const MPI_Comm                   &communicator)
      {
        std::deque<WearingBushing> bushings;
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
          {
            Ranks::run_together(communicator, [&]() {
              first_cycle = dynamics.run(make_unworn_clearances(parameters),
                                         make_unworn_supports(parameters));
            });
            take_forces_of_first_rank(first_cycle, communicator);
          }
        for (const BushingParameters &bushing : parameters.bushings)
          {
            const Multibody::JointParameters &joint =
              parameters.joint(bushing.name);
            const BushingParameters resolved =
              needs_forces
                ? resolve_contact_arc(bushing,
                                      joint,
                                      first_cycle.joint(bushing.name))
                : bushing;
            try
              {
                bushings.emplace_back(resolved,
                                      joint,
                                      parameters.wear.compliance_update,
                                      communicator);
              }
            catch (const std::bad_alloc &)
              {
                throw ExcRun("Bushing " + bushing.name +
                             ": there is not enough memory for its mesh and "
                             "its compliance, about " +
                             describe_memory(estimate_memory(resolved, joint)) +
                             ". Fewer 'Mesh/Bore cells' need less.");
              }
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
      , mechanism(Multibody::count_redundant_constraints(parameters.mechanism))
      , dynamics(mechanism, make_dynamics_parameters(parameters))
      , process(parameters.wear,
                make_bushings(parameters, dynamics, communicator))
      , deviation_limits(parameters.mechanism.watched_markers)
    {}



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
      for (const WearingBushing &bushing : process.bushings())
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
    WearSimulation::start()
    {
      run_dynamics();
      solve_contacts();
      if (needs_more_samples())
        {
          // Now the arcs of contact are known.
          run_dynamics();
          solve_contacts();
        }
      if (!process.bushings().empty())
        deviation_limits.check_start(state().duty_cycle);
      if (parameters.wear.mesh_error_estimate != MeshErrorEstimate::none &&
          !process.bushings().empty())
        on_coarse_meshes([this]() {
          coarse_run = make_coarse_run();
          coarse_run->start(process);
        });
    }



    bool
    WearSimulation::needs_more_samples() const
    {
      for (std::size_t j = 0; j < state().joints.size(); ++j)
        if (state()
              .duty_cycle.joint(process.bushings()[j].name())
              .sampling_error(reach_of(state().joints[j].contact)) >
            parameters.dynamics.sampling_tolerance)
          return parameters.dynamics.sampling_tolerance > 0.;
      return false;
    }



    bool
    WearSimulation::is_over() const
    {
      return state().cycles >= parameters.cycles || !state().stopped_by.empty();
    }



    void
    WearSimulation::advance(const double end)
    {
      if (!deviation_limits.are_set())
        {
          take_step(end);
          return;
        }
      const RunState before = state();
      take_step(end);
      if (deviation_limits.excess(state().duty_cycle) >= 0.)
        stop_at_deviation(before);
    }



    void
    WearSimulation::stop_at_deviation(const RunState &before)
    {
      // Of the limit, and of the cycles: what a life need not be known better.
      constexpr double tolerance = 1e-4;
      RunState         reached   = state();
      const double excess_before = deviation_limits.excess(before.duty_cycle);
      const double excess_after  = deviation_limits.excess(reached.duty_cycle);
      // Zero where that is near enough, which ends the search.
      const auto excess_after_wear_to = [&](const double cycles) {
        restore(before);
        while (state().cycles < cycles && state().stopped_by.empty())
          take_step(cycles);
        const double excess  = deviation_limits.excess(state().duty_cycle);
        const bool   is_near = std::abs(excess) <= tolerance;
        if (is_near || (excess > 0. && state().cycles < reached.cycles))
          reached = state();
        return is_near ? 0. : excess;
      };
      if (excess_after > tolerance)
        {
          boost::uintmax_t max_iterations = 50;
          boost::math::tools::toms748_solve(
            excess_after_wear_to,
            before.cycles,
            reached.cycles,
            excess_before,
            excess_after,
            [&](const double a, const double b) {
              return std::abs(b - a) <= tolerance * std::abs(b);
            },
            max_iterations);
          restore(reached);
        }
      process.set_stopped_by(deviation_limits.describe(state().duty_cycle));
    }



    void
    WearSimulation::take_step(const double end)
    {
      double kept_since = state().cycles;
      {
        dealii::TimerOutput::Scope scope(timer, "wear step");
        process.take_step(end);
        warn_of_unstable_step();
      }
      if (coarse_run != nullptr)
        on_coarse_meshes([this]() { coarse_run->follow(process); });
      if (is_over() || process.duty_cycle_is_outdated() ||
          deviation_limits.are_set())
        {
          kept_since = state().cycles_at_dynamics;
          run_dynamics();
        }
      dealii::TimerOutput::Scope scope(timer, "contact");
      process.complete_step(kept_since);
    }



    void
    WearSimulation::restore(const RunState &state)
    {
      process.restore(state);
      coarse_run.reset();
      if (!state.twin.empty())
        {
          coarse_run = make_coarse_run();
          coarse_run->restore(state.twin.front(), state.mesh_errors);
        }
    }



    std::unique_ptr<CoarseRun>
    WearSimulation::make_coarse_run() const
    {
      return std::make_unique<CoarseRun>(parameters.wear, process.bushings());
    }



    RunResults
    WearSimulation::results() const
    {
      RunResults results = make_run_results(process);
      if (is_over())
        results.status = state().stopped_by.empty() ? RunStatus::completed
                                                    : RunStatus::stopped;
      results.message = state().stopped_by;
      return results;
    }



    std::map<std::string, double>
    WearSimulation::times_of_parts() const
    {
      return timer.get_summary_data(dealii::TimerOutput::total_wall_time);
    }



    RunResults
    WearSimulation::run(Output::OutputDirectory &directory)
    {
      RunRecorder recorder(
        parameters, mechanism, directory, console, communicator);
      Ranks::run_together(communicator, [&]() { recorder.start(); });
      RunResults results;
      try
        {
          run_cycles(recorder);
          const RunResults reached = this->results();
          Ranks::run_together(communicator, [&]() {
            check_results(reached);
            check_files(directory);
          });
          Ranks::run_together(communicator, [&]() {
            results =
              conclude(directory, recorder, reached.status, reached.message);
            check_files(directory);
          });
        }
      catch (const std::exception &exception)
        {
          keep_results(directory, recorder, exception);
          throw;
        }
      if (parameters.cycles > 0)
        timer.print_summary();
      return results;
    }



    void
    WearSimulation::run_cycles(RunRecorder &recorder)
    {
      // A state that was restored has its motion and contacts.
      if (state().duty_cycle.joints.empty())
        start();
      recorder.record(state(), process.bushings());
      while (!is_over())
        {
          advance(recorder.next_output());
          recorder.record(state(), process.bushings());
          if (!state().stopped_by.empty())
            recorder.record_fields(state(), process.bushings());
          if (!is_over())
            stop_if_interrupted_anywhere();
        }
    }



    void
    WearSimulation::keep_results(const Output::OutputDirectory &directory,
                                 RunRecorder                   &recorder,
                                 const std::exception          &exception)
    {
      const RunStatus status =
        dynamic_cast<const ExcInterrupted *>(&exception) != nullptr
          ? RunStatus::stopped
          : RunStatus::failed;
      const auto *ours =
        dynamic_cast<const dealii::ExceptionBase *>(&exception);
      const std::string message =
        ours != nullptr ? message_of(*ours) : describe_foreign(exception);
      // What made the run fail may make this fail too, a full disk for example;
      // the first failure is the one to report.
      try
        {
          if (ours == nullptr)
            {
              // Perhaps on this rank only, which must not wait for others.
              conclude(directory, recorder, status, message);
              return;
            }
          Ranks::run_together(communicator, [&]() {
            conclude(directory, recorder, status, message);
          });
          recorder.record_fields(state(), process.bushings());
        }
      catch (const std::exception &)
        {}
    }



    RunResults
    WearSimulation::conclude(const Output::OutputDirectory &directory,
                             const RunRecorder             &recorder,
                             const RunStatus                status,
                             const std::string             &message)
    {
      RunResults results = make_run_results(process);
      results.status     = status;
      results.message    = message;
      results.wall_time  = recorder.wall_time();
      results.cpu_time   = recorder.cpu_time();
      dealii::Utilities::System::MemoryStats memory;
      dealii::Utilities::System::get_memory_stats(memory);
      results.peak_memory_bytes = 1024. * memory.VmHWM;

      if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
        {
          directory.release_reserve();
          write_summary_json(directory.file("summary.json"),
                             parameters,
                             results);
        }
      print_results(console.out(), parameters, results);
      return results;
    }



    void
    WearSimulation::stop_if_interrupted_anywhere() const
    {
      const int signal =
        dealii::Utilities::MPI::max(interrupting_signal(), communicator);
      if (signal != 0)
        throw ExcInterrupted(signal);
    }



    void
    WearSimulation::check_files(const Output::OutputDirectory &directory) const
    {
      directory.check_complete();
      AssertThrow(console.log_error().empty(), ExcRun(console.log_error()));
    }



    void
    WearSimulation::on_coarse_meshes(const std::function<void()> &action)
    {
      dealii::TimerOutput::Scope scope(timer, "coarser meshes");
      try
        {
          action();
          process.set_mesh_errors(coarse_run->mesh_errors());
          process.set_twin(coarse_run->state());
        }
      catch (const ExcRun &exception)
        {
          // The run itself does not need it.
          coarse_run.reset();
          process.set_mesh_errors({});
          process.set_twin({});
          console.out() << "WARNING: no estimate of the error of the mesh, as "
                           "the next coarser one fails: "
                        << message_of(exception) << std::endl;
        }
    }



    void
    WearSimulation::warn_of_unstable_step()
    {
      const double max_stable_step = state().stepper.max_stable_step;
      if (state().unstable_step_reported || max_stable_step == 0. ||
          parameters.wear.cycles_per_step <= max_stable_step)
        return;
      process.set_unstable_step_reported();
      console.out() << "WARNING: 'Wear/Cycles per step' = "
                    << parameters.wear.cycles_per_step
                    << " is longer than explicit steps are stable for on this "
                       "mesh, about "
                    << max_stable_step
                    << ": pressure and depth will oscillate from node to node. "
                       "Choose shorter steps, a coarser mesh, or 'set "
                       "Extrapolation = implicit'."
                    << std::endl;
    }



    void
    WearSimulation::run_dynamics()
    {
      dealii::TimerOutput::Scope scope(timer, "dynamics");

      auto clearances = make_unworn_clearances(parameters);
      auto supports   = parameters.cycles == 0
                          ? make_unworn_supports(parameters)
                          : Multibody::CycleSimulation::Supports();
      for (const WearingBushing &bushing : process.bushings())
        {
          clearances.insert_or_assign(bushing.name(), bushing.clearance());
          if (bushing.joint_parameters().needs_support())
            supports[bushing.name()] = bushing.make_support();
        }
      Multibody::CycleSimulation::Arcs arcs;
      for (std::size_t j = 0; j < state().joints.size(); ++j)
        if (!state().joints[j].contact.samples.empty())
          arcs[process.bushings()[j].name()] =
            reach_of(state().joints[j].contact);
      Multibody::DutyCycle cycle;
      Ranks::run_together(communicator, [&]() {
        cycle = dynamics.run(clearances, supports, arcs, &state().duty_cycle);
      });
      take_forces_of_first_rank(cycle, communicator);

      const std::string told = state().dynamics.settling_message;
      process.renew_duty_cycle(cycle);
      const std::string &message = state().dynamics.settling_message;
      if (parameters.cycles > 0 && message != told)
        console.out() << (state().dynamics.all_settled ? "Note: the dynamics "
                                                       : "WARNING: dynamics ")
                      << message << "." << std::endl;
    }



    void
    WearSimulation::solve_contacts()
    {
      dealii::TimerOutput::Scope scope(timer, "contact");
      process.solve_contacts();
    }
  } // namespace Coupling
} // namespace Tribody

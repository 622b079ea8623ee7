// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/base/foreign_exceptions.h>
#include <tribody/base/interruption.h>
#include <tribody/base/ranks.h>
#include <tribody/base/significant_digits.h>
#include <tribody/base/units.h>
#include <tribody/case/memory_estimate.h>
#include <tribody/results/printed_summary.h>
#include <tribody/results/summary_json.h>
#include <tribody/run/make_unworn_supports.h>
#include <tribody/run/mesh_resolution.h>
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
                                         &joint.friction_force,
                                         &joint.force_between,
                                         &joint.angle_between,
                                         &joint.sliding_halves,
                                         &joint.eccentricity,
                                         &joint.penetration})
            Ranks::broadcast(*field, 0, communicator);
        for (Multibody::WatchedPath &path : cycle.watched_paths)
          Ranks::broadcast(path.deviation, 0, communicator);
      }



      void
      print_load_cases(std::ostream &out, const CaseParameters &parameters)
      {
        const Spectrum &spectrum = parameters.spectrum;
        for (std::size_t i = 0; i < spectrum.n_cases(); ++i)
          if (const LoadCase &load_case = parameters.load_cases[i];
              !load_case.name.empty())
            out << load_case.subsection() << ": "
                << significant_digits(100. * spectrum.cycles[i] /
                                        spectrum.n_cycles(),
                                      3)
                << " % of the cycles, "
                << significant_digits(load_case.period, 4) << " s each"
                << std::endl;
      }



      std::deque<OperatingCase>
      make_operating_cases(const CaseParameters &parameters)
      {
        std::deque<OperatingCase> cases;
        for (const LoadCase &load_case : parameters.load_cases)
          cases.emplace_back(parameters, load_case);
        return cases;
      }



      std::vector<double>
      wear_factors(const CaseParameters &parameters)
      {
        std::vector<double> factors;
        for (const LoadCase &load_case : parameters.load_cases)
          factors.push_back(load_case.wear_factor);
        return factors;
      }



      std::vector<double>
      ambient_temperatures(const CaseParameters &parameters)
      {
        std::vector<double> temperatures;
        for (const LoadCase &load_case : parameters.load_cases)
          temperatures.push_back(load_case.ambient_temperature);
        return temperatures;
      }



      // A duty cycle of each load case, of unworn joints.
      std::vector<Multibody::DutyCycle>
      run_unworn(const CaseParameters            &parameters,
                 const std::deque<OperatingCase> &cases,
                 const MPI_Comm                  &communicator)
      {
        std::vector<Multibody::DutyCycle> cycles(cases.size());
        Ranks::run_together(communicator, [&]() {
          for (std::size_t i = 0; i < cases.size(); ++i)
            cycles[i] = cases[i].run(make_unworn_clearances(parameters),
                                     make_unworn_supports(parameters),
                                     {},
                                     nullptr);
        });
        for (Multibody::DutyCycle &cycle : cycles)
          take_forces_of_first_rank(cycle, communicator);
        return cycles;
      }



      // Unworn. If a mesh is to be as fine as the contact wants it, a cycle of
      // the dynamics says how large that is.
      std::deque<WearingBushing>
      make_bushings(const CaseParameters            &parameters,
                    const std::deque<OperatingCase> &cases,
                    const MPI_Comm                  &communicator)
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
        std::vector<Multibody::DutyCycle> first_cycles;
        if (needs_forces)
          first_cycles = run_unworn(parameters, cases, communicator);
        for (const BushingParameters &bushing : parameters.bushings)
          {
            const Multibody::JointParameters &joint =
              parameters.joint(bushing.name);
            BushingParameters resolved = bushing;
            for (const Multibody::DutyCycle &cycle : first_cycles)
              {
                // As fine as the load case with the narrowest contact wants it.
                const BushingParameters for_case =
                  resolve_contact_arc(bushing,
                                      joint,
                                      cycle.joint(bushing.name));
                if (&cycle == &first_cycles.front() ||
                    for_case.mesh.n_bore_cells > resolved.mesh.n_bore_cells)
                  resolved = for_case;
              }
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
      , cases(make_operating_cases(parameters))
      , process(parameters.wear,
                make_bushings(parameters, cases, communicator),
                wear_factors(parameters),
                ambient_temperatures(parameters))
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
      if (cases.front().mechanism() == nullptr)
        out << "Loads from files, no mechanism";
      else
        {
          out << "Mechanism: ";
          count(parameters.mechanism.bodies.size(), "body, ", "bodies, ");
          count(parameters.mechanism.joints.size(), "joint, ", "joints, ");
          count(cases.front().mechanism()->n_degrees_of_freedom(),
                "degree of freedom",
                "degrees of freedom");
        }
      out << std::endl;
      print_load_cases(out, parameters);
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
      run_dynamics(parameters.spectrum.shares(state().cycles));
      solve_contacts();
      if (needs_more_samples())
        {
          // Now the arcs of contact are known.
          run_dynamics(parameters.spectrum.shares(state().cycles));
          solve_contacts();
        }
      else if (cases.size() > 1)
        {
          process.thin_out_loads();
          solve_contacts();
        }
      settle_temperatures();
      if (!process.bushings().empty())
        deviation_limits.check_start(state().duty_cycles);
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
      for (std::size_t i = 0; i < cases.size(); ++i)
        {
          const double tolerance =
            cases[i].mechanism() == nullptr
              ? 0.
              : parameters.load_cases[i].dynamics.sampling_tolerance;
          for (std::size_t j = 0; j < state().joints.size(); ++j)
            if (tolerance > 0. && state().shares[i] > 0. &&
                state()
                    .duty_cycles[i]
                    .joint(process.bushings()[j].name())
                    .sampling_error(reach_of(state().joints[j].contact)) >
                  tolerance)
              return true;
        }
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
      if (deviation_limits.excess(state().duty_cycles) >= 0.)
        stop_at_deviation(before);
    }



    void
    WearSimulation::stop_at_deviation(const RunState &before)
    {
      // Of the limit, and of the cycles: what a life need not be known better.
      constexpr double tolerance = 1e-4;
      RunState         reached   = state();
      const double excess_before = deviation_limits.excess(before.duty_cycles);
      const double excess_after  = deviation_limits.excess(reached.duty_cycles);
      // Zero where that is near enough, which ends the search.
      const auto excess_after_wear_to = [&](const double cycles) {
        // What the search costs counts, too.
        RunState trial = before;
        trial.counts   = state().counts;
        restore(trial);
        while (state().cycles < cycles && state().stopped_by.empty())
          take_step(cycles);
        const double excess  = deviation_limits.excess(state().duty_cycles);
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
          reached.counts = state().counts;
          restore(reached);
        }
      process.set_stopped_by(deviation_limits.describe(state().duty_cycles));
    }



    void
    WearSimulation::take_step(const double end)
    {
      double kept_since = state().cycles;
      {
        dealii::TimerOutput::Scope scope(timer, "wear step");
        process.take_step(
          std::min(end, parameters.spectrum.next_change(state().cycles)));
        warn_of_unstable_step();
      }
      if (coarse_run != nullptr)
        on_coarse_meshes([this]() { coarse_run->follow(process); });
      const double renewed_before = state().cycles_at_dynamics;
      if (process.gets_warm())
        {
          solve_contacts();
          settle_temperatures();
        }
      if (is_over() || process.duty_cycle_is_outdated() ||
          deviation_limits.are_set())
        run_dynamics(state().shares);
      if (state().cycles_at_dynamics != renewed_before)
        kept_since = renewed_before;
      {
        dealii::TimerOutput::Scope scope(timer, "contact");
        process.complete_step(kept_since);
      }
      if (!is_over() &&
          parameters.spectrum.shares(state().cycles) != state().shares)
        {
          // The next load case has another motion.
          run_dynamics(parameters.spectrum.shares(state().cycles));
          solve_contacts();
          settle_temperatures();
        }
    }



    void
    WearSimulation::settle_temperatures()
    {
      if (!process.gets_warm())
        return;
      dealii::TimerOutput::Scope scope(timer, "temperature");
      process.settle_warmth([this]() { run_dynamics(state().shares); });
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
      return std::make_unique<CoarseRun>(parameters.wear,
                                         process,
                                         communicator);
    }



    RunResults
    WearSimulation::results() const
    {
      RunResults results = make_run_results(process);
      if (is_over())
        results.status = state().stopped_by.empty() ? RunStatus::completed
                                                    : RunStatus::stopped;
      results.message = state().stopped_by;
      if (is_over() && parameters.ends_by_time && results.message.empty())
        {
          results.status = RunStatus::stopped;
          results.message =
            "time " + Units::to_string(parameters.stop_at_time, "s", "h");
        }
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
      std::vector<const Multibody::Mechanism *> mechanisms;
      for (const OperatingCase &operating_case : cases)
        mechanisms.push_back(operating_case.mechanism());
      RunRecorder recorder(
        parameters, mechanisms, directory, console, communicator);
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
      if (state().duty_cycles.empty())
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
    WearSimulation::run_dynamics(const Eigen::VectorXd &shares)
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
      std::vector<Multibody::DutyCycle> cycles = state().duty_cycles;
      cycles.resize(cases.size());
      for (std::size_t i = 0; i < cases.size(); ++i)
        if (shares[i] > 0. || cycles[i].joints.empty())
          {
            const Multibody::DutyCycle before = cycles[i];
            Ranks::run_together(communicator, [&]() {
              cycles[i] = run_case(i, clearances, supports, arcs, &before);
            });
            take_forces_of_first_rank(cycles[i], communicator);
            if (shares[i] > 0.)
              in_load_case(parameters.load_cases[i],
                           [&]() { process.check_duty_cycle(cycles[i]); });
          }

      const std::string told = state().dynamics.settling_message;
      process.renew_duty_cycles(cycles, shares);
      const std::string &message = state().dynamics.settling_message;
      if (parameters.cycles > 0 && message != told)
        console.out() << (state().dynamics.all_settled ? "Note: the dynamics "
                                                       : "WARNING: dynamics ")
                      << message << "." << std::endl;
    }



    Multibody::DutyCycle
    WearSimulation::run_case(
      const std::size_t                             i,
      const Multibody::CycleSimulation::Clearances &clearances,
      const Multibody::CycleSimulation::Supports   &supports,
      const Multibody::CycleSimulation::Arcs       &arcs,
      const Multibody::DutyCycle                   *before) const
    {
      std::map<std::string, double> friction_factors;
      for (const WearingBushing &bushing : process.bushings())
        if (const WarmBushing *heat = bushing.warm_bushing())
          if (const double factor = heat->friction_factor(bushing.warmth());
              factor != 1.)
            friction_factors.emplace(bushing.name(), factor);
      if (friction_factors.empty())
        return cases[i].run(clearances, supports, arcs, before);
      const LoadCase warm =
        with_friction_factors(parameters.load_cases[i], friction_factors);
      return OperatingCase(parameters, warm)
        .run(clearances, supports, arcs, before);
    }



    void
    WearSimulation::solve_contacts()
    {
      dealii::TimerOutput::Scope scope(timer, "contact");
      process.solve_contacts();
    }
  } // namespace Coupling
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/ranks.h>
#include <tribody/base/units.h>
#include <tribody/base/whole_file.h>
#include <tribody/output/bushing_vtu.h>
#include <tribody/output/mechanism_vtu.h>
#include <tribody/results/cycle_tables.h>
#include <tribody/results/mechanism_picture.h>
#include <tribody/results/run_recorder.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // Progress lines: not more often than this [s].
      constexpr double progress_interval = 2.;

      double
      seconds_since(const std::chrono::steady_clock::time_point &start)
      {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                             start)
          .count();
      }



      // Over the sliding in all load cases [N].
      double
      mean_normal_force(const RunState &state, const std::string &joint)
      {
        double force = 0., weight = 0.;
        for (std::size_t i = 0; i < state.duty_cycles.size(); ++i)
          if (state.shares[i] > 0.)
            {
              const Multibody::JointDutyCycle &cycle =
                state.duty_cycles[i].joint(joint);
              const double mean = cycle.mean_normal_force();
              if (state.shares[i] == 1.)
                return mean;
              const double distance =
                state.shares[i] * cycle.sliding_distance();
              force += distance * mean;
              weight += distance;
            }
        return weight > 0. ? force / weight : 0.;
      }



      // The largest of all load cases that have a share [N].
      double
      peak_force(const RunState &state, const std::string &joint)
      {
        double largest = 0.;
        for (std::size_t i = 0; i < state.duty_cycles.size(); ++i)
          if (state.shares[i] > 0.)
            largest =
              std::max(largest, state.duty_cycles[i].joint(joint).peak_force());
        return largest;
      }



      std::string
      clock_time(const double seconds)
      {
        const auto         whole = static_cast<long>(std::lround(seconds));
        std::ostringstream out;
        if (whole >= 3600)
          out << whole / 3600 << ':' << std::setfill('0') << std::setw(2);
        out << (whole / 60) % 60 << ':' << std::setfill('0') << std::setw(2)
            << whole % 60;
        return out.str();
      }
    } // namespace



    RunRecorder::RunRecorder(
      const CaseParameters                            &parameters,
      const std::vector<const Multibody::Mechanism *> &mechanisms,
      Output::OutputDirectory                         &directory,
      Console                                         &console,
      const MPI_Comm                                  &communicator)
      : parameters(parameters)
      , mechanisms(mechanisms)
      , directory(directory)
      , console(console)
      , communicator(communicator)
      , writes(dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      , vtu_files(parameters.bushings.size())
    {}



    void
    RunRecorder::start()
    {
      started_at           = std::chrono::steady_clock::now();
      progress_printed_at  = started_at;
      processor_started_at = std::clock();
      if (!writes)
        return;

      const std::string message = directory.create();
      write_whole_file(directory.file("parameters.prm"),
                       [this](std::ostream &file) { file << parameters.text; });

      console.open_log(directory.file("log.txt"));
      if (!message.empty())
        console.out() << message << std::endl;
      console.out() << "Results go to '" << directory.path() << "'."
                    << std::endl;
    }



    double
    RunRecorder::wall_time() const
    {
      return seconds_since(started_at);
    }



    double
    RunRecorder::cpu_time() const
    {
      return static_cast<double>(std::clock() - processor_started_at) /
             CLOCKS_PER_SEC;
    }



    void
    RunRecorder::record(const RunState                   &state,
                        const std::deque<WearingBushing> &bushings)
    {
      Ranks::run_together(communicator, [&]() {
        if (writes)
          write_history_row(state, bushings);
      });

      if (state.cycles >= next_output())
        record_fields(state, bushings);

      if (!writes)
        return;
      const bool is_last = state.cycles >= parameters.cycles;
      if (parameters.cycles > 0 &&
          (is_last || seconds_since(progress_printed_at) > progress_interval))
        print_progress(state, bushings);
    }



    double
    RunRecorder::next_output() const
    {
      // With more outputs than cycles some of them coincide.
      const double interval =
        static_cast<double>(parameters.cycles) / (parameters.n_outputs - 1);
      for (unsigned int n = n_outputs; n + 1 < parameters.n_outputs; ++n)
        if (const double at = std::round(n * interval); at > last_output_at)
          return at;
      return parameters.cycles;
    }



    void
    RunRecorder::record_fields(const RunState                   &state,
                               const std::deque<WearingBushing> &bushings)
    {
      const bool contacts_are_known =
        std::none_of(state.joints.begin(),
                     state.joints.end(),
                     [](const JointState &joint) {
                       return joint.contact.samples.empty();
                     });
      if (last_output_at == state.cycles || !contacts_are_known)
        return;
      for (std::size_t j = 0; j < bushings.size(); ++j)
        {
          std::string file_name;
          Ranks::run_together(communicator, [&]() {
            file_name = directory.joint_file(bushings[j].name(), vtu_name());
          });
          bushings[j].write_vtu(file_name, state.joints[j].contact);
        }
      Ranks::run_together(communicator, [&]() {
        if (writes)
          write_fields(state, bushings);
      });
      // The next output is the same on all ranks.
      last_output_at = state.cycles;
      ++n_outputs;
    }



    std::string
    RunRecorder::vtu_name() const
    {
      return Output::numbered_name("bushing", n_outputs, "vtu");
    }



    void
    RunRecorder::write_fields(const RunState                   &state,
                              const std::deque<WearingBushing> &bushings)
    {
      // At first all; those that have had their turn do not change any more.
      for (std::size_t i = 0; i < state.duty_cycles.size(); ++i)
        if (n_outputs == 0 || state.shares[i] > 0.)
          {
            const LoadCase &load_case = parameters.load_cases[i];
            write_cycle_tables(directory,
                               load_case.mechanism,
                               state.duty_cycles[i],
                               load_case.name,
                               n_outputs);
            if (mechanisms[i] != nullptr)
              write_mechanism(i, state.duty_cycles[i]);
          }
      for (std::size_t j = 0; j < bushings.size(); ++j)
        {
          write_bushing(state, bushings[j], state.joints[j].contact);
          vtu_files[j].emplace_back(state.cycles, vtu_name());
          Output::write_pvd(directory.joint_file(bushings[j].name(),
                                                 "bushing.pvd"),
                            vtu_files[j]);
        }
    }



    void
    RunRecorder::open_history(const std::string &file_name)
    {
      std::vector<std::string>       columns  = {"cycles [-]",
                                                 "wear_step [-]",
                                                 "operating_time [s]"};
      const std::vector<std::string> comments = {
        "A row per wear step. Depth: largest of the bore. Volume: measured "
        "on the worn mesh. Forces: largest total and mean normal force of "
        "the cycle, with load cases of all together.",
        "Pressure: largest of the cycle. Clearance: largest, bore radius "
        "minus pin radius plus depths. Pin: what wear has taken from its "
        "radius and from its volume. Sliding: since the first cycle."};
      for (const BushingParameters &bushing : parameters.bushings)
        for (const char *column : {"max_wear_depth [m]",
                                   "worn_volume [m^3]",
                                   "peak_force [N]",
                                   "mean_normal_force [N]",
                                   "max_pressure [Pa]",
                                   "clearance [m]",
                                   "pin_max_wear_depth [m]",
                                   "pin_worn_volume [m^3]",
                                   "sliding_distance [m]"})
          columns.push_back(bushing.name + " " + column);
      for (const BushingParameters &bushing : parameters.bushings)
        if (bushing.heat.is_on())
          for (const char *column : {"contact_temperature [K]",
                                     "max_temperature [K]",
                                     "closing [m]"})
            columns.push_back(bushing.name + " " + column);
      for (const auto &marker : parameters.mechanism.watched_markers)
        for (const char *column :
             {"largest_deviation [m]", "rms_deviation [m]"})
          columns.push_back(marker.name + " " + column);
      history = std::make_unique<TableWriter>(file_name,
                                              comments,
                                              columns,
                                              TableKind::growing);
    }



    void
    RunRecorder::write_history_row(const RunState                   &state,
                                   const std::deque<WearingBushing> &bushings)
    {
      if (bushings.empty())
        return;
      // A directory that is gone is told now, not at the next output.
      const std::string file_name = directory.file("history.csv");
      if (history == nullptr)
        open_history(file_name);

      std::vector<double> row = {state.cycles,
                                 static_cast<double>(state.counts.wear_steps),
                                 state.operating_time};
      for (std::size_t j = 0; j < bushings.size(); ++j)
        {
          const WearingBushing &bushing = bushings[j];
          row.insert(row.end(),
                     {bushing.profile().max_depth(),
                      bushing.worn_volume(),
                      peak_force(state, bushing.name()),
                      mean_normal_force(state, bushing.name()),
                      state.joints[j].contact.max_pressure,
                      bushing.largest_clearance(bushing.depth()),
                      bushing.wearing_pin() != nullptr
                        ? bushing.wearing_pin()->profile().max_depth()
                        : 0.,
                      bushing.pin_worn_volume(),
                      state.joints[j].totals.sliding_distance});
        }
      for (std::size_t j = 0; j < bushings.size(); ++j)
        if (bushings[j].bushing_parameters().heat.is_on())
          {
            const Warmth &warmth = state.joints[j].warmth;
            row.insert(row.end(),
                       {warmth.contact_temperature,
                        warmth.max_temperature,
                        warmth.closing});
          }
      // The largest of all load cases.
      for (std::size_t m = 0; m < parameters.mechanism.watched_markers.size();
           ++m)
        {
          double largest = 0., rms = 0.;
          for (std::size_t i = 0; i < state.duty_cycles.size(); ++i)
            if (state.shares[i] > 0.)
              {
                const Multibody::WatchedPath &path =
                  state.duty_cycles[i].watched_paths[m];
                largest = std::max(largest, path.largest_deviation());
                rms     = std::max(rms, path.rms_deviation());
              }
          row.insert(row.end(), {largest, rms});
        }
      history->write_row(row);
    }



    void
    RunRecorder::write_mechanism(const std::size_t           load_case,
                                 const Multibody::DutyCycle &cycle) const
    {
      // More would only make the film slower.
      constexpr Eigen::Index max_frames = 180;

      const std::string &name = parameters.load_cases[load_case].name;
      const std::string stem = name.empty() ? "mechanism" : "mechanism_" + name;
      const MechanismPicture picture(*mechanisms[load_case], cycle);
      const Eigen::Index     n      = cycle.time.size();
      const Eigen::Index     stride = (n + max_frames - 1) / max_frames;
      std::vector<std::pair<double, std::string>> frames;
      for (Eigen::Index s = 0; s < n; s += stride)
        {
          const std::string frame =
            Output::numbered_name(stem, frames.size(), "vtu");
          Output::write_mechanism_vtu(directory.joint_file("mechanism", frame),
                                      picture.draw(s));
          frames.emplace_back(cycle.time[s], "mechanism/" + frame);
        }
      Output::write_pvd(directory.file(stem + ".pvd"), frames);

      write_whole_file(directory.joint_file("mechanism", "legend.txt"),
                       [&](std::ostream &file) { file << picture.legend(); });
    }



    void
    RunRecorder::write_bushing(const RunState       &state,
                               const WearingBushing &bushing,
                               const CycleContact   &contact)
    {
      TableWriter table(
        directory.joint_file(
          bushing.name(), Output::numbered_name("profile", n_outputs, "csv")),
        {"Bushing '" + bushing.name() + "' after " +
           std::to_string(std::lround(state.cycles)) + " cycles.",
         "Angle: of the bore node in the bushing's frame, counter-clockwise. "
         "Depth: along the as-manufactured normal. Pressure: largest of the "
         "cycle at that node."},
        {"angle [deg]", "bushing_wear_depth [m]", "peak_pressure [Pa]"});
      for (Eigen::Index i = 0; i < bushing.profile().depth.size(); ++i)
        table.write_row({Units::degrees(bushing.node_angles()[i]),
                         bushing.profile().depth[i],
                         contact.peak_pressure[i]});
      table.finish();

      if (bushing.wearing_pin() != nullptr)
        write_pin(state, bushing);
    }



    void
    RunRecorder::write_pin(const RunState       &state,
                           const WearingBushing &bushing) const
    {
      const WearingPin &pin = *bushing.wearing_pin();
      TableWriter       table(
        directory.joint_file(
          bushing.name(),
          Output::numbered_name("pin_profile", n_outputs, "csv")),
        {"Pin of '" + bushing.name() + "' after " +
                 std::to_string(std::lround(state.cycles)) + " cycles.",
               "Angle: of the node in the pin's frame, counter-clockwise. Depth: "
                     "what wear has taken from the pin's radius."},
        {"angle [deg]", "pin_wear_depth [m]"});
      for (Eigen::Index i = 0; i < pin.node_angles().size(); ++i)
        table.write_row(
          {Units::degrees(pin.node_angles()[i]), pin.profile().depth[i]});
      table.finish();
    }



    void
    RunRecorder::print_progress(const RunState                   &state,
                                const std::deque<WearingBushing> &bushings)
    {
      const double elapsed = seconds_since(started_at);
      const double remaining =
        elapsed * (parameters.cycles / std::max(state.cycles, 1.) - 1.);

      std::ostringstream line;
      line << std::fixed << std::setprecision(0) << std::setw(9) << state.cycles
           << " of " << parameters.cycles << " cycles";
      for (std::size_t j = 0; j < bushings.size(); ++j)
        {
          line << "   " << bushings[j].name() << ' ' << std::setprecision(4)
               << bushings[j].profile().max_depth() * 1e3 << " mm, "
               << std::setprecision(2)
               << state.joints[j].contact.max_pressure * 1e-6 << " MPa";
        }
      line << "   " << clock_time(elapsed) << " passed, "
           << clock_time(remaining) << " to go";
      console.out() << line.str() << std::endl;
      progress_printed_at = std::chrono::steady_clock::now();
    }
  } // namespace Coupling
} // namespace Tribody

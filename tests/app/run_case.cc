// SPDX-License-Identifier: LGPL-2.1-or-later

// Runs a parameter file as the program does and prints what the tests of this
// directory compare: results in scaled units, beside closed forms and, if
// reference/<name of the test>.csv exists, beside the joint forces tabulated
// there (columns crank_angle [deg] and force [N]); likewise with the peak and
// the mean of the force in reference/<name of the test>_peak_mean.csv and the
// parts of the wear in reference/<name of the test>_lobes.csv. If
// reference/<name of the test>_forces.csv exists, the forces of all joints are
// compared with an earlier run's there, instead of printed. If
// beside/<name of the test>.prm exists, that is run too, and the differences of
// the crank pin's results are compared with what beside/<name of the test>.csv
// expects; reference/<name of the test>_peak_pressure.csv has the largest
// pressure of a closed form, reference/<name of the test>_depth.csv the depth
// of one. A run of one cycle tells its pressure instead of its wear.

#include <deal.II/base/mpi.h>

#include <tribody/base/console.h>
#include <tribody/base/exceptions.h>
#include <tribody/base/ranks.h>
#include <tribody/base/units.h>
#include <tribody/case/case_parameters.h>
#include <tribody/output/output_directory.h>
#include <tribody/results/run_results.h>
#include <tribody/run/wear_simulation.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>

using namespace Tribody;
using namespace Tribody::Coupling;

// The column @p name of a CSV file, its comment lines skipped; empty if there
// is none.
std::vector<double>
read_column(const std::string &file_name, const std::string &name)
{
  std::ifstream            file(file_name);
  std::string              line;
  std::vector<double>      values;
  std::vector<std::string> header;
  while (std::getline(file, line))
    {
      if (line.empty() || line[0] == '#')
        continue;
      std::vector<std::string> cells;
      std::istringstream       stream(line);
      for (std::string cell; std::getline(stream, cell, ',');)
        cells.push_back(cell);
      if (header.empty())
        {
          header = cells;
          continue;
        }
      const auto column = std::find(header.begin(), header.end(), name);
      if (column == header.end())
        return {};
      values.push_back(std::stod(cells.at(column - header.begin())));
    }
  return values;
}

void
compare_forces(const std::string &reference,
               const std::string &duty_cycle,
               const bool         ideal)
{
  const auto            phases = read_column(duty_cycle, "phase [deg]");
  const auto            forces = read_column(duty_cycle, "force [N]");
  std::map<int, double> force_at;
  for (std::size_t i = 0; i < phases.size(); ++i)
    force_at[static_cast<int>(std::lround(1000. * phases[i]))] = forces[i];

  const auto angles   = read_column(reference, "crank_angle [deg]");
  const auto expected = read_column(reference, "force [N]");
  double     largest  = 0.;
  for (std::size_t i = 0; i < angles.size(); ++i)
    largest = std::max(largest,
                       std::abs(force_at.at(static_cast<int>(std::lround(
                                  1000. * std::fmod(angles[i], 360.)))) /
                                  expected[i] -
                                1.));
  std::cout << "  reference: " << angles.size()
            << " angles; forces right to 1e-2: " << (largest < 1e-2);
  if (ideal)
    std::cout << ", to 1e-6: " << (largest < 1e-6);
  std::cout << std::endl;
}

// Beside row @p number of @p recorded, if there is that file. A whole run, wear
// included, hands rounding errors on to the integrator's steps. Among runs
// whose tolerances differ by 1e-11 the mean of the steel case differs by up to
// 0.7 %, the peak of the four-bar's joint D, which lies between two samples, by
// 0.6 %, so that the last of three digits need not stay.
void
print_forces(const Multibody::JointDutyCycle &joint,
             const std::string               &recorded,
             const std::size_t                number)
{
  const double peak = joint.peak_force();
  const double mean = joint.mean_force();
  std::cout << std::defaultfloat << std::setprecision(3) << joint.name;
  if (std::filesystem::exists(recorded))
    std::cout
      << ": forces within 1 % of those recorded: "
      << (std::abs(peak / read_column(recorded, "peak_force [N]").at(number) -
                   1.) < 1e-2 &&
          std::abs(mean / read_column(recorded, "mean_force [N]").at(number) -
                   1.) < 1e-2);
  else
    std::cout << ": largest force " << peak << " N, mean " << mean << " N";
  std::cout << std::fixed << std::endl;
}

void
compare_peak_and_mean(const std::string               &reference,
                      const Multibody::JointDutyCycle &joint)
{
  const double peak = read_column(reference, "peak_force [N]").at(0);
  const double mean = read_column(reference, "mean_force [N]").at(0);
  std::cout << "  reference: peak right to 2e-3: "
            << (std::abs(joint.peak_force() / peak - 1.) < 2e-3)
            << ", mean right to 2e-3: "
            << (std::abs(joint.mean_force() / mean - 1.) < 2e-3) << std::endl;
}

// The parts of the wear between angles, beside those that the file expects.
void
compare_lobes(const std::string &reference, const std::string &profile)
{
  const auto from   = read_column(reference, "from [deg]");
  const auto to     = read_column(reference, "to [deg]");
  const auto shares = read_column(reference, "share [%]");
  const auto angles = read_column(profile, "angle [deg]");
  const auto depths = read_column(profile, "bushing_wear_depth [m]");
  double     total  = 0.;
  for (const double depth : depths)
    total += depth;
  for (std::size_t i = 0; i < from.size(); ++i)
    {
      double part = 0.;
      for (std::size_t k = 0; k < angles.size(); ++k)
        if (std::fmod(angles[k] - from[i] + 360., 360.) <=
            std::fmod(to[i] - from[i] + 360., 360.))
          part += depths[k];
      const double share = 100. * part / total;
      std::cout << std::setprecision(0) << "  wear between " << from[i]
                << " and " << to[i] << " deg: " << share
                << " %, expected within 5 points: "
                << (std::abs(share - shares[i]) < 5.) << std::endl;
    }
}

void
print_bushing(const BushingResults &results,
              const RunState       &state,
              const unsigned int    contact_losses,
              const std::string    &depth_reference)
{
  const SurfaceResults &bushing = results.bushing;
  const CycleContact   &contact = state.joints[results.number].contact;
  std::cout << std::setprecision(1) << "  depth "
            << bushing.max_wear_depth * 1e6 << " um, volume "
            << bushing.worn_volume * 1e9 << " mm^3, ";
  // Where a bore wears alike all round, rounding decides where most.
  const Eigen::VectorXd &depth = state.joints[results.number].depth;
  if (depth.minCoeff() > 0.99 * depth.maxCoeff())
    std::cout << "all round";
  else
    std::cout << "at " << Units::degrees(bushing.max_wear_angle) << " deg";
  std::cout << ", half-angle " << std::setprecision(0)
            << Units::degrees(contact.at_peak_force().half_angle) << " deg"
            << std::endl;
  if (results.crescent)
    std::cout
      << std::setprecision(1) << "  over crescent: depth "
      << 100. * (bushing.max_wear_depth / results.crescent->max_wear_depth - 1.)
      << " %, volume "
      << 100. * (bushing.worn_volume / results.crescent->worn_volume - 1.)
      << " %" << std::endl;
  const double balance = bushing.volume_balance_relative_error;
  std::cout << "  volume balance below 1e-3: " << (balance < 1e-3)
            << ", below 1e-6: " << (balance < 1e-6)
            << ", oscillation below 1e-2: " << (results.mesh_oscillation < 1e-2)
            << ", losses of contact: " << contact_losses << std::endl;
  if (!std::filesystem::exists(depth_reference))
    return;
  const double expected  = read_column(depth_reference, "depth [um]").at(0);
  const double tolerance = read_column(depth_reference, "tolerance [-]").at(0);
  std::cout << "  reference: depth within its tolerance "
            << (std::abs(1e6 * bushing.max_wear_depth / expected - 1.) <
                tolerance)
            << std::endl;
}

// Of a run of one cycle, beside a closed form if there is one.
void
print_pressure(const CycleContact &contact, const std::string &reference)
{
  const double pressure = 1e-6 * contact.max_pressure;
  std::cout << std::setprecision(3) << "  largest pressure " << pressure
            << " MPa, half-angle " << std::setprecision(0)
            << Units::degrees(contact.at_peak_force().half_angle) << " deg"
            << std::endl;
  if (!std::filesystem::exists(reference))
    return;
  const double expected  = read_column(reference, "pressure [MPa]").at(0);
  const double tolerance = read_column(reference, "tolerance [-]").at(0);
  std::cout << "  closed form: within its tolerance "
            << (std::abs(pressure / expected - 1.) < tolerance) << std::endl;
}

// How much a quantity differs from that of the run beside, relative to it,
// against what @p expectations have.
void
compare_difference(const char        *quantity,
                   const double       value,
                   const double       beside,
                   const std::string &expectations)
{
  const std::string name = quantity;
  const auto difference  = read_column(expectations, name + "_difference [-]");
  if (difference.empty())
    return;
  const double tolerance =
    read_column(expectations, name + "_tolerance [-]").at(0);
  std::cout << "  beside: difference of " << name << " as expected "
            << (std::abs(value / beside - 1. - difference.at(0)) <= tolerance)
            << std::endl;
}

void
compare_beside(const RunResults  &results,
               const RunResults  &other,
               const std::string &expectations)
{
  // Of the joint that wears first, or of the crank pin.
  const std::string joint =
    results.bushings.empty() ? "crank_pin" : results.bushings[0].name;
  const Multibody::JointDutyCycle &a =
    results.state.duty_cycles.front().joint(joint);
  const Multibody::JointDutyCycle &b =
    other.state.duty_cycles.front().joint(joint);
  compare_difference("peak_force",
                     a.peak_force(),
                     b.peak_force(),
                     expectations);
  compare_difference("mean_force",
                     a.mean_force(),
                     b.mean_force(),
                     expectations);
  if (!results.bushings.empty())
    compare_difference("pressure",
                       results.state.joints[0].contact.max_pressure,
                       other.state.joints[0].contact.max_pressure,
                       expectations);
  for (std::size_t i = 0; i < results.bushings.size(); ++i)
    compare_difference("depth",
                       results.bushings[i].bushing.max_wear_depth,
                       other.bushings[i].bushing.max_wear_depth,
                       expectations);
}

// Of a pin that wears, beside its last profile.
void
print_pin(const SurfaceResults &pin,
          const SurfaceResults &bushing,
          const std::string    &directory)
{
  std::string profile;
  for (const auto &entry : std::filesystem::directory_iterator(directory))
    if (entry.path().filename().string().rfind("pin_profile_", 0) == 0)
      profile = std::max(profile, entry.path().string());
  const auto angles  = read_column(profile, "angle [deg]");
  const auto depths  = read_column(profile, "pin_wear_depth [m]");
  const auto deepest = std::max_element(depths.begin(), depths.end());
  std::cout << std::setprecision(1) << "  pin: depth "
            << pin.max_wear_depth * 1e6 << " um, volume over the bushing's "
            << std::setprecision(4) << pin.worn_volume / bushing.worn_volume
            << ", volume balance below 1e-6: "
            << (pin.volume_balance_relative_error < 1e-6)
            << "\n  its profile: " << depths.size()
            << " nodes, depth and angle those of the summary: "
            << (std::abs(*deepest / pin.max_wear_depth - 1.) < 1e-6 &&
                std::abs(angles[deepest - depths.begin()] -
                         Units::degrees(pin.max_wear_angle)) < 1e-6)
            << std::endl;
}

// Of a run without wear.
void
print_energy_balance(const double error)
{
  constexpr double bound = 1e-4;
  std::cout << "energy balance in the recorded cycle below 1e-4: ";
  if (error < bound)
    std::cout << "yes" << std::endl;
  else
    std::cout << "no, " << std::scientific << std::setprecision(1) << error
              << std::fixed << std::endl;
}

void
print_joint(const std::size_t  j,
            const std::size_t  row,
            const RunResults  &results,
            const std::string &reference,
            const std::string &directory)
{
  const Multibody::JointDutyCycle &joint =
    results.state.duty_cycles.front().joints[j];
  const auto is_given = [&](const std::string &file_name) {
    return joint.name == "crank_pin" && std::filesystem::exists(file_name);
  };
  print_forces(joint, reference + "_forces.csv", row);
  if (is_given(reference + ".csv"))
    compare_forces(reference + ".csv",
                   directory + "/crank_pin/duty_cycle_0000.csv",
                   !joint.has_gap);
  if (is_given(reference + "_peak_mean.csv"))
    compare_peak_and_mean(reference + "_peak_mean.csv", joint);
  if (const BushingResults *bushing = results.bushing(joint.name))
    {
      if (results.state.cycles > 1.)
        print_bushing(*bushing,
                      results.state,
                      results.state.dynamics.contact_losses[j],
                      reference + "_depth.csv");
      else
        print_pressure(results.state.joints[bushing->number].contact,
                       reference + "_peak_pressure.csv");
      if (bushing->pin)
        print_pin(*bushing->pin,
                  bushing->bushing,
                  directory + "/" + joint.name);
    }
  if (is_given(reference + "_lobes.csv"))
    compare_lobes(reference + "_lobes.csv",
                  directory + "/crank_pin/profile_0002.csv");
}

// The program's own words carry times; they are not compared.
RunResults
run(const std::string &prm, const std::string &directory)
{
  // All ranks run the case, the first one tells.
  const bool is_first_rank =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  if (is_first_rank)
    std::filesystem::remove_all(directory);
  std::ostringstream      screen;
  Console                 console(screen, is_first_rank);
  const CaseParameters    parameters = read_case(prm, {});
  WearSimulation          simulation(parameters, console, MPI_COMM_WORLD);
  Output::OutputDirectory output(directory, MPI_COMM_WORLD);
  return simulation.run(output);
}

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string name      = std::filesystem::path(argv[1]).stem();
  const std::string directory = name + ".results";
  const std::string beside    = std::string(SOURCE_DIR) + "/beside/" + name;
  RunResults        results, other;
  const bool        has_other = std::filesystem::exists(beside + ".prm");
  try
    {
      results = run(argv[1], directory);
      if (has_other)
        other = run(beside + ".prm", name + ".beside");
    }
  catch (const dealii::ExceptionBase &exception)
    {
      return Ranks::fail(message_of(exception), 1, MPI_COMM_WORLD);
    }
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) > 0)
    return 0;

  const RunState &state = results.state;
  std::cout << std::fixed << std::setprecision(1) << name_of(results.status)
            << " " << state.cycles << " cycles in " << state.counts.wear_steps
            << " wear steps; drift below "
            << "1e-8 m: " << (state.dynamics.constraint_drift < 1e-8)
            << ", settled: " << std::boolalpha << state.dynamics.all_settled
            << std::noboolalpha << std::endl;
  if (state.duty_cycles.front().energy.cycle.has_work)
    print_energy_balance(state.duty_cycles.front().energy.relative_error);
  // In the order of their names.
  std::map<std::string, std::size_t> number_of;
  for (std::size_t j = 0; j < state.duty_cycles.front().joints.size(); ++j)
    number_of[state.duty_cycles.front().joints[j].name] = j;
  std::size_t n_printed = 0;
  for (const auto &[joint_name, j] : number_of)
    print_joint(j,
                n_printed++,
                results,
                std::string(SOURCE_DIR) + "/reference/" + name,
                directory);
  for (const Multibody::WatchedPath &path :
       state.duty_cycles.front().watched_paths)
    std::cout << std::setprecision(1) << path.name << ": deviation "
              << 1e6 * path.largest_deviation() << " um, rms "
              << 1e6 * path.rms_deviation() << " um" << std::endl;
  if (has_other)
    compare_beside(results, other, beside + ".csv");
}

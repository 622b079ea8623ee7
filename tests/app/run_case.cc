// SPDX-License-Identifier: LGPL-2.1-or-later

// Runs a parameter file as the program does and prints what the tests of this
// directory compare: results in scaled units, beside closed forms and, if
// reference/<name of the test>.csv exists, beside the joint forces tabulated
// there (columns crank_angle [deg] and force [N]); likewise with the peak and
// the mean of the force in reference/<name of the test>_peak_mean.csv and the
// parts of the wear in reference/<name of the test>_lobes.csv. If
// reference/<name of the test>_forces.csv exists, the forces of all joints are
// compared with an earlier run's there, instead of printed.

#include <deal.II/base/mpi.h>

#include <nlohmann/json.hpp>

#include <tribody/base/console.h>
#include <tribody/base/exceptions.h>
#include <tribody/base/ranks.h>
#include <tribody/case/case_parameters.h>
#include <tribody/output/output_directory.h>
#include <tribody/run/wear_simulation.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>

using nlohmann::json;

// The column @p name of a CSV file, its comment lines skipped.
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
      values.push_back(std::stod(cells.at(column - header.begin())));
    }
  return values;
}

void
compare_forces(const std::string &reference, const std::string &duty_cycle)
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
            << " angles; forces right to 1e-2: " << (largest < 1e-2)
            << ", to 1e-6: " << (largest < 1e-6) << std::endl;
}

// Beside row @p number of @p recorded, if there is that file. A whole run, wear
// included, hands rounding errors on to the integrator's steps. Among runs
// whose tolerances differ by 1e-11 the mean of the steel case differs by up to
// 0.7 %, the peak of the four-bar's joint D, which lies between two samples, by
// 0.6 %, so that the last of three digits need not stay.
void
print_forces(const std::string &joint_name,
             const json        &joint,
             const std::string &recorded,
             const unsigned int number)
{
  const double peak = joint["peak_force_N"];
  const double mean = joint["mean_force_N"];
  std::cout << std::defaultfloat << std::setprecision(3) << joint_name;
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
compare_peak_and_mean(const std::string &reference, const json &joint)
{
  const double peak = read_column(reference, "peak_force [N]").at(0);
  const double mean = read_column(reference, "mean_force [N]").at(0);
  std::cout << "  reference: peak right to 2e-3: "
            << (std::abs(joint["peak_force_N"].get<double>() / peak - 1.) <
                2e-3)
            << ", mean right to 2e-3: "
            << (std::abs(joint["mean_force_N"].get<double>() / mean - 1.) <
                2e-3)
            << std::endl;
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
print_bushing(const json &joint)
{
  const json  &bushing = joint["bushing"];
  const double depth   = bushing["max_wear_depth_m"];
  const double volume  = bushing["worn_volume_m3"];
  std::cout << std::setprecision(1) << "  depth " << depth * 1e6
            << " um, volume " << volume * 1e9 << " mm^3, at "
            << bushing["max_wear_angle_deg"].get<double>()
            << " deg, half-angle " << std::setprecision(0)
            << joint["contact_half_angle_deg"].get<double>() << " deg"
            << std::endl;
  if (bushing.contains("crescent_closed_form"))
    {
      const json &crescent = bushing["crescent_closed_form"];
      std::cout << std::setprecision(1) << "  over crescent: depth "
                << 100. *
                     (depth / crescent["max_wear_depth_m"].get<double>() - 1.)
                << " %, volume "
                << 100. *
                     (volume / crescent["worn_volume_m3"].get<double>() - 1.)
                << " %" << std::endl;
    }
  std::cout << "  volume balance below 1e-3: "
            << (joint["volume_balance_relative_error"] < 1e-3)
            << ", below 1e-6: "
            << (joint["volume_balance_relative_error"] < 1e-6)
            << ", oscillation below 1e-2: "
            << (bushing["wear_rate_mesh_oscillation"] < 1e-2)
            << ", losses of contact: " << joint["contact_losses"] << std::endl;
}

// Of a pin that wears, beside its last profile.
void
print_pin(const json &joint, const std::string &directory)
{
  const json  &pin    = joint["pin"];
  const double depth  = pin["max_wear_depth_m"];
  const double volume = pin["worn_volume_m3"];
  std::string  profile;
  for (const auto &entry : std::filesystem::directory_iterator(directory))
    if (entry.path().filename().string().rfind("pin_profile_", 0) == 0)
      profile = std::max(profile, entry.path().string());
  const auto angles  = read_column(profile, "angle [deg]");
  const auto depths  = read_column(profile, "pin_wear_depth [m]");
  const auto deepest = std::max_element(depths.begin(), depths.end());
  std::cout << std::setprecision(1) << "  pin: depth " << depth * 1e6
            << " um, volume over the bushing's " << std::setprecision(4)
            << volume / joint["bushing"]["worn_volume_m3"].get<double>()
            << ", volume balance below 1e-6: "
            << (pin["volume_balance_relative_error"] < 1e-6)
            << "\n  its profile: " << depths.size()
            << " nodes, depth and angle those of the summary: "
            << (std::abs(*deepest / depth - 1.) < 1e-6 &&
                std::abs(angles[deepest - depths.begin()] -
                         pin["max_wear_angle_deg"].get<double>()) < 1e-6)
            << std::endl;
}

// Of a run without wear.
void
print_energy_balance(const json &dynamics)
{
  const double     error = dynamics["energy_balance_relative_error"];
  constexpr double bound = 1e-4;
  std::cout << "energy balance in the recorded cycle below 1e-4: ";
  if (error < bound)
    std::cout << "yes" << std::endl;
  else
    std::cout << "no, " << std::scientific << std::setprecision(1) << error
              << std::fixed << std::endl;
}

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  using namespace Tribody;

  const std::string name      = std::filesystem::path(argv[1]).stem();
  const std::string directory = name + ".results";
  // All ranks run the case, the first one tells.
  const bool is_first_rank =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  if (is_first_rank)
    std::filesystem::remove_all(directory);

  // The program's own words carry times; they are not compared.
  std::ostringstream screen;
  std::streambuf    *to_screen = std::cout.rdbuf(screen.rdbuf());
  try
    {
      Console                  console(is_first_rank);
      Coupling::CaseParameters parameters = Coupling::read_case(argv[1], {});
      Coupling::WearSimulation simulation(parameters, console, MPI_COMM_WORLD);
      Output::OutputDirectory  output(directory, MPI_COMM_WORLD);
      simulation.run(output);
    }
  catch (const dealii::ExceptionBase &exception)
    {
      std::cout.rdbuf(to_screen);
      return Ranks::fail(message_of(exception), 1, MPI_COMM_WORLD);
    }
  std::cout.rdbuf(to_screen);
  if (!is_first_rank)
    return 0;

  const json summary = json::parse(std::ifstream(directory + "/summary.json"));
  std::cout << std::fixed << std::setprecision(1)
            << summary["status"].get<std::string>() << " "
            << summary["cycles"].get<double>() << " cycles in "
            << summary["counts"]["wear_steps"] << " wear steps; drift below "
            << "1e-8 m: " << (summary["dynamics"]["constraint_drift_m"] < 1e-8)
            << ", settled: " << summary["dynamics"]["settled"] << std::endl;
  if (summary["dynamics"].contains("energy_balance_relative_error"))
    print_energy_balance(summary["dynamics"]);
  unsigned int n_printed = 0;
  for (const auto &[joint_name, joint] : summary["joints"].items())
    {
      const std::string reference =
        std::string(SOURCE_DIR) + "/reference/" + name;
      print_forces(joint_name, joint, reference + "_forces.csv", n_printed++);
      if (joint_name == "crank_pin" &&
          std::filesystem::exists(reference + ".csv"))
        compare_forces(reference + ".csv",
                       directory + "/crank_pin/duty_cycle_0000.csv");
      if (joint_name == "crank_pin" &&
          std::filesystem::exists(reference + "_peak_mean.csv"))
        compare_peak_and_mean(reference + "_peak_mean.csv", joint);
      if (joint.contains("bushing"))
        {
          print_bushing(joint);
          if (joint["pin"].contains("volume_balance_relative_error"))
            print_pin(joint, directory + "/" + joint_name);
        }
      if (joint_name == "crank_pin" &&
          std::filesystem::exists(reference + "_lobes.csv"))
        compare_lobes(reference + "_lobes.csv",
                      directory + "/crank_pin/profile_0002.csv");
    }
}

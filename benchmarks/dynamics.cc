// SPDX-License-Identifier: LGPL-2.1-or-later

// What the dynamics costs at a measured accuracy.
//
// Usage: benchmark_dynamics DIRECTORY_WITH_PRM_FILES [--json] [CASE ...]
//
// For each case and each 'Dynamics/Accuracy': integration steps, residual and
// Jacobian evaluations and milliseconds per cycle of the motion (the median of
// several runs), beside the rms error of the joint force over the second cycle,
// relative to the mean force. The error is that against a run of the same
// cycles 1000 times tighter than the default accuracy.
//
// With --json, mechanism, start, results and the reference are written as JSON
// instead of a table: radau.py integrates the same equations.

#include <nlohmann/json.hpp>

#include <tribody/case/case_parameters.h>
#include <tribody/multibody/cycle/cycle_simulation.h>
#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/multibody/following/slow_motion_start.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <string>
#include <vector>

using namespace Tribody;
using namespace Tribody::Multibody;
using nlohmann::json;

constexpr unsigned int n_samples = 72;
// 1000 times below the default.
constexpr double tightest_accuracy = 3e-7;

struct Case
{
  std::string         name;
  MechanismParameters mechanism;
  DynamicsParameters  dynamics;
  // The joint whose force is compared.
  std::string joint;
};

struct Result
{
  DutyCycle cycle;
  // Of the whole run over its cycles [s].
  double seconds_per_cycle = 0.;
};

// A row of n four-bar linkages: n + 1 bars of different lengths hang from the
// ground, their ends joined by n couplers; one degree of freedom, which swings.
MechanismParameters
make_chain(const unsigned int n)
{
  MechanismParameters p;
  p.gravity = {0., -9.81};
  const auto bar =
    [](const std::string &name, const double length, const double mass) {
      BodyParameters body;
      body.name              = name;
      body.mass              = mass;
      body.moment_of_inertia = mass * length * length / 12;
      body.markers = {{"A", {-length / 2, 0.}}, {"B", {length / 2, 0.}}};
      return body;
    };
  const auto revolute = [&p](const std::string &name,
                             const std::string &pin,
                             const std::string &bushing) {
    JointParameters joint;
    joint.name           = name;
    joint.pin_marker     = pin;
    joint.bushing_marker = bushing;
    p.joints.push_back(joint);
  };
  // Released with the first bar at 30 degrees from the vertical.
  const double tilt = M_PI / 6;
  for (unsigned int i = 0; i <= n; ++i)
    {
      const std::string number       = std::to_string(i);
      p.ground.markers["O" + number] = {1. * i, 0.};
      BodyParameters hanging   = bar("bar" + number, i % 2 == 0 ? 1. : 1.1, 1.);
      hanging.initial_angle    = -M_PI / 2 + tilt;
      const double half        = 0.5 * (i % 2 == 0 ? 1. : 1.1);
      hanging.initial_position = {i + half * std::sin(tilt),
                                  -half * std::cos(tilt)};
      p.bodies.push_back(hanging);
      revolute("pivot" + number, "ground.O" + number, "bar" + number + ".A");
    }
  for (unsigned int i = 0; i < n; ++i)
    {
      const std::string number  = std::to_string(i);
      BodyParameters    coupler = bar("coupler" + number, 1., 1.);
      coupler.initial_position  = {i + 0.5 + std::sin(tilt), -std::cos(tilt)};
      p.bodies.push_back(coupler);
      revolute("left" + number,
               "coupler" + number + ".A",
               "bar" + number + ".B");
      revolute("right" + number,
               "coupler" + number + ".B",
               "bar" + std::to_string(i + 1) + ".B");
    }
  return p;
}

// "validation", "0.5um", "5mm" or "chain<number of four-bars>".
Case
make_case(const std::string &directory, const std::string &name)
{
  Case result;
  result.name = name;
  if (name.rfind("chain", 0) == 0)
    {
      result.mechanism = make_chain(std::stoi(name.substr(5)));
      // About the time of one swing.
      result.dynamics.cycle_duration = 2.;
      result.joint                   = "pivot0";
      return result;
    }
  const std::map<std::string, std::string> files = {
    {"validation", "mukras2010_validation.prm"},
    {"0.5um", "mukras2010_steel_0.5um_literal.prm"},
    {"5mm", "mukras2010_steel_5mm_literal.prm"}};
  const Coupling::CaseParameters parameters =
    Coupling::read_case(directory + "/" + files.at(name), {"Cycles=0"});
  result.mechanism = parameters.mechanism;
  result.dynamics  = parameters.dynamics;
  result.joint     = "crank_pin";
  return result;
}

// Two cycles, or more, whether they agree or not.
Result
run(const Case        &benchmark,
    const double       accuracy,
    const unsigned int n_cycles = 2)
{
  DynamicsParameters dynamics      = benchmark.dynamics;
  dynamics.accuracy                = accuracy;
  dynamics.samples_per_cycle       = n_samples;
  dynamics.settling_tolerance      = 1e-300;
  dynamics.maximum_settling_cycles = n_cycles - 1;
  dynamics.averaged_cycles         = 1;
  dynamics.maximum_steps_per_cycle = 100000000;
  const Mechanism       mechanism(benchmark.mechanism);
  const CycleSimulation simulation(mechanism, dynamics);
  const auto            begin = std::chrono::steady_clock::now();
  Result                result;
  result.cycle = simulation.run();
  result.seconds_per_cycle =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
      .count() /
    result.cycle.settling.n_cycles;
  return result;
}

double
relative_rms_error(const JointDutyCycle &joint, const JointDutyCycle &reference)
{
  const double squares = (joint.force_x - reference.force_x).squaredNorm() +
                         (joint.force_y - reference.force_y).squaredNorm();
  return std::sqrt(squares / joint.force_x.size()) / reference.mean_force();
}

json
to_json(const Eigen::VectorXd &x)
{
  return std::vector<double>(x.begin(), x.end());
}

// What radau.py needs: bodies, constraints in the form of markers, springs and
// the joint with clearance, with everything in SI units.
json
describe(const Case &benchmark)
{
  const Mechanism mechanism(benchmark.mechanism);
  json            result;
  result["name"]                    = benchmark.name;
  result["period"]                  = benchmark.dynamics.cycle_duration > 0
                                        ? benchmark.dynamics.cycle_duration
                                        : mechanism.period();
  result["samples"]                 = n_samples;
  result["masses"]                  = to_json(mechanism.masses());
  result["weights"]                 = to_json(mechanism.weights());
  const MechanismParameters &p      = mechanism.parameters();
  const auto                 marker = [&](const std::string &name) {
    const auto dot     = name.find('.');
    const auto body    = name.substr(0, dot);
    int        index   = ground_body;
    auto       markers = p.ground.markers;
    for (unsigned int i = 0; i < p.bodies.size(); ++i)
      if (p.bodies[i].name == body)
        {
          index   = i;
          markers = p.bodies[i].markers;
        }
    const auto point = markers.at(name.substr(dot + 1));
    return json{{"body", index}, {"x", point[0]}, {"y", point[1]}};
  };
  for (const JointParameters &j : p.joints)
    if (j.is_revolute())
      {
        json joint = {{"name", j.name},
                      {"type", j.has_contact_law() ? "clearance" : "revolute"},
                      {"pin", marker(j.pin_marker)},
                      {"bushing", marker(j.bushing_marker)}};
        if (j.has_contact_law())
          joint["contact"] = {{"pin_radius", j.pin_radius},
                              {"clearance", j.clearance()},
                              {"stiffness",
                               compute_hertz_stiffness(j.pin_radius,
                                                       j.bushing_radius,
                                                       j.pin_material,
                                                       j.bushing_material,
                                                       j.radii_combination)},
                              {"restitution", j.restitution_coefficient},
                              {"minimum_approach_speed",
                               j.minimum_approach_speed},
                              {"friction", j.friction_coefficient},
                              {"v_0", j.friction_regularisation_speed}};
        result["joints"].push_back(joint);
      }
    else
      result["joints"].push_back({{"name", j.name},
                                  {"type", "translational"},
                                  {"pin", marker(j.first_marker)},
                                  {"bushing", marker(j.second_marker)},
                                  {"axis", j.axis_angle}});
  for (const DriverParameters &d : p.drivers)
    result["joints"].push_back({{"name", d.name},
                                {"type", "driver"},
                                {"speed", d.speed},
                                {"angle", d.initial_angle}});
  for (const SpringParameters &k : p.springs)
    result["springs"].push_back({{"first", marker(k.first_marker)},
                                 {"second", marker(k.second_marker)},
                                 {"stiffness", k.stiffness},
                                 {"length", k.reference_length},
                                 {"force", k.force_at_reference_length}});

  // The state from which CycleSimulation starts too.
  const EquationsOfMotion equations(mechanism, nominal_clearances(mechanism));
  const Mechanism closed_mechanism(with_ideal_joints(benchmark.mechanism));
  const EquationsOfMotion closed(closed_mechanism, {});
  StartingState           start = compute_centred_start(equations, closed, 0.);
  if (benchmark.dynamics.start == MotionStart::slow_motion &&
      !mechanism.clearance_joints().empty())
    start = compute_slow_motion_start(equations,
                                      closed,
                                      0.,
                                      mechanism.period() / 360);
  result["q"] = to_json(start.state.q);
  result["v"] = to_json(start.state.v);
  return result;
}

// Runs that are timed, of which the median counts.
constexpr unsigned int n_runs = 9;

double
median(std::vector<double> values)
{
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void
measure(const Case &benchmark, json *results)
{
  const DutyCycle       reference = run(benchmark, tightest_accuracy).cycle;
  const JointDutyCycle &exact     = reference.joint(benchmark.joint);
  if (results != nullptr)
    {
      *results              = describe(benchmark);
      (*results)["joint"]   = benchmark.joint;
      (*results)["force_x"] = to_json(exact.force_x);
      (*results)["force_y"] = to_json(exact.force_y);
      (*results)["mean"]    = exact.mean_force();
    }
  else
    std::printf("%s\n  %9s %9s %9s %9s %10s %10s %10s\n",
                benchmark.name.c_str(),
                "accuracy",
                "steps",
                "residuals",
                "Jacobians",
                "us/step",
                "ms/cycle",
                "rms error");
  for (const double accuracy : {1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5})
    {
      std::vector<double> seconds, seconds_per_step;
      Result              result;
      while (seconds.size() < n_runs)
        {
          result = run(benchmark, accuracy);
          seconds.push_back(result.seconds_per_cycle);
          // Without what comes before the first step.
          const Result longer = run(benchmark, accuracy, 4);
          seconds_per_step.push_back(
            (4 * longer.seconds_per_cycle - 2 * result.seconds_per_cycle) /
            (longer.cycle.statistics.n_steps -
             result.cycle.statistics.n_steps));
        }
      const Sundials::IntegratorStatistics &n = result.cycle.statistics;
      const double cycles                     = result.cycle.settling.n_cycles;
      const double error =
        relative_rms_error(result.cycle.joint(benchmark.joint), exact);
      if (results != nullptr)
        (*results)["runs"].push_back({{"accuracy", accuracy},
                                      {"steps", n.n_steps / cycles},
                                      {"residuals", n.n_residuals / cycles},
                                      {"jacobians", n.n_jacobians / cycles},
                                      {"seconds", median(seconds)},
                                      {"error", error}});
      else
        std::printf("  %9.0e %9.0f %9.0f %9.0f %10.2f %10.2f %10.1e\n",
                    accuracy,
                    n.n_steps / cycles,
                    n.n_residuals / cycles,
                    n.n_jacobians / cycles,
                    1e6 * median(seconds_per_step),
                    1e3 * median(seconds),
                    error);
    }
}

int
main(int argc, char **argv)
{
  try
    {
      std::vector<std::string> arguments(argv + 1, argv + argc);
      const auto flag = std::find(arguments.begin(), arguments.end(), "--json");
      const bool as_json = flag != arguments.end();
      if (as_json)
        arguments.erase(flag);
      const std::string directory = arguments.empty() ? "prm" : arguments[0];
      std::vector<std::string> names(arguments.begin() + !arguments.empty(),
                                     arguments.end());
      if (names.empty())
        names = {"validation", "0.5um", "5mm", "chain2", "chain10", "chain40"};
      json all = json::array();
      for (const std::string &name : names)
        {
          json results;
          measure(make_case(directory, name), as_json ? &results : nullptr);
          all.push_back(results);
        }
      if (as_json)
        std::printf("%s\n", all.dump().c_str());
    }
  catch (const std::exception &error)
    {
      std::fprintf(stderr, "%s\n", error.what());
      return 1;
    }
}

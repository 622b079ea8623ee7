// What the dynamics costs at a measured accuracy.
//
// Usage: dynamics DIRECTORY_WITH_PRM_FILES [CASE ...]
//
// For each case and each 'Dynamics/Accuracy': integration steps, residual and
// Jacobian evaluations and milliseconds per cycle of the motion (the median of
// several runs), beside the rms error of the joint force over the last cycle,
// relative to the mean force. The error is that against a run of the same
// cycles 1000 times tighter than the default accuracy.

#include <tribody/coupling/case_parameters.h>
#include <tribody/multibody/cycle_simulation.h>
#include <tribody/multibody/duty_cycle.h>
#include <tribody/multibody/mechanism.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <vector>

using namespace Tribody;
using namespace Tribody::Multibody;

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

Case
read(const std::string &directory,
     const std::string &file,
     const std::string &name)
{
  const Coupling::CaseParameters parameters =
    Coupling::read_case(directory + "/" + file, {"Cycles=0"});
  return {name, parameters.mechanism, parameters.dynamics, "crank_pin"};
}

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

Result
run(const Case &benchmark, const double accuracy)
{
  DynamicsParameters dynamics = benchmark.dynamics;
  dynamics.accuracy           = accuracy;
  dynamics.samples_per_cycle  = 72;
  // Two cycles, whether they agree or not.
  dynamics.settling_tolerance      = 1e-300;
  dynamics.maximum_settling_cycles = 1;
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

void
measure(const Case &benchmark)
{
  std::printf("%s\n", benchmark.name.c_str());
  const double    tightest  = 1e-3 * benchmark.dynamics.accuracy;
  const DutyCycle reference = run(benchmark, tightest).cycle;
  std::printf("  %9s %9s %9s %9s %10s %10s %10s\n",
              "accuracy",
              "steps",
              "residuals",
              "Jacobians",
              "us/step",
              "ms/cycle",
              "rms error");
  for (const double accuracy : {1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5})
    {
      std::vector<double> seconds;
      Result              result;
      do
        {
          result = run(benchmark, accuracy);
          seconds.push_back(result.seconds_per_cycle);
      } while (seconds.size() < 9);
      std::nth_element(seconds.begin(),
                       seconds.begin() + seconds.size() / 2,
                       seconds.end());
      const double                median = seconds[seconds.size() / 2];
      const IntegratorStatistics &n      = result.cycle.statistics;
      const double                cycles = result.cycle.settling.n_cycles;
      std::printf("  %9.0e %9.0f %9.0f %9.0f %10.2f %10.2f %10.1e\n",
                  accuracy,
                  n.n_steps / cycles,
                  n.n_residuals / cycles,
                  n.n_jacobians / cycles,
                  1e6 * median * cycles / n.n_steps,
                  1e3 * median,
                  relative_rms_error(result.cycle.joint(benchmark.joint),
                                     reference.joint(benchmark.joint)));
    }
}

int
main(int argc, char **argv)
{
  try
    {
      const std::string directory = argc > 1 ? argv[1] : "prm";
      std::vector<Case> cases     = {
            read(directory, "mukras2010_validation.prm", "validation"),
            read(directory, "mukras2010_steel_0.5um_literal.prm", "0.5um"),
            read(directory, "mukras2010_steel_5mm_literal.prm", "5mm")};
      for (const Case &benchmark : cases)
        if (argc < 3 ||
            std::find(argv + 2, argv + argc, benchmark.name) != argv + argc)
          measure(benchmark);
    }
  catch (const std::exception &error)
    {
      std::fprintf(stderr, "%s\n", error.what());
      return 1;
    }
}

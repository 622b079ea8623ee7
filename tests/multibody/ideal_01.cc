// SPDX-License-Identifier: LGPL-2.1-or-later

// The slider-crank with ideal joints has no degree of freedom: positions by
// Newton's method, forces by inverse dynamics. Known: the joint force of both
// of the paper's mechanisms in both readings of "length", in closed form
// (reference/ideal_slider_crank_*.csv), to 1e-6 of the largest force. Where the
// input makes no mechanism, the message says which joint or marker is wrong.

#include "report.h"
#include "slider_crank.h"
#include <tribody/base/exceptions.h>

using namespace SliderCrank;

void
compare(const std::string &name, const MechanismParameters &parameters)
{
  const Mechanism mechanism(parameters);
  const DutyCycle cycle =
    CycleSimulation(mechanism, DynamicsParameters()).run();
  const JointDutyCycle &joint = cycle.joint("crank_pin");
  const auto            table = read_table(
    std::string(SOURCE_DIR) + "/reference/ideal_slider_crank_" + name + ".csv");

  std::cout << name << ": " << table.size() << " rows" << std::endl;
  double error = 0., largest = 0.;
  for (unsigned int i = 0; i < table.size(); ++i)
    {
      // The last row is the first one, a revolution later.
      const unsigned int s = i % cycle.phase.size();
      error                = std::max(error,
                       std::hypot(table[i][1] - joint.force_x(s),
                                  table[i][2] - joint.force_y(s)));
      error                = std::max(error, std::abs(cycle.phase(s) - 5. * s));
      largest              = std::max(largest, table[i][3]);
    }
  report_below("  relative error of the force", error / largest, 1e-6);
  report_value("  peak force [N]", joint.peak_force(), 3);
  // Once around, plus nothing: the crank turns by 2 pi against the follower.
  report_below("  error of the sliding distance [mm]",
               1e3 * std::abs(joint.sliding_distance() -
                              joint_radius(mechanism, 1) * 2 * M_PI),
               1e-9);
  report_below("  constraint drift [nm]", 1e9 * cycle.constraint_drift, 1e-3);
}

template <typename Function>
void
expect_error(const std::string &what, const Function &function)
{
  std::cout << what << ": ";
  try
    {
      function();
      std::cout << "accepted" << std::endl;
    }
  catch (const ExcParameter &error)
    {
      std::cout << error.path << ": " << error.problem << std::endl;
    }
}

void
simulate(const MechanismParameters &parameters)
{
  const Mechanism mechanism(parameters);
  CycleSimulation(mechanism, DynamicsParameters());
}

int
main()
{
  compare("validation_literal", validation(1));
  compare("validation_half_length", validation(2));
  compare("steel_literal", steel(1));
  compare("steel_half_length", steel(2));

  expect_error("wrong marker", []() {
    MechanismParameters p  = steel(1);
    p.joints[1].pin_marker = "crank.B";
    simulate(p);
  });
  expect_error("wrong body", []() {
    MechanismParameters p = steel(1);
    p.drivers[0].body     = "krank";
    simulate(p);
  });
  expect_error("follower too short", []() {
    MechanismParameters p    = steel(1);
    p.bodies[1].markers["B"] = {-0.8, 0.};
    // 0.075 m cannot reach from the crank to an axis 1 m away.
    p.ground.markers["G"]    = {0., 2.};
    p.joints[3].first_marker = "ground.G";
    try
      {
        simulate(p);
      }
    catch (const ExcParameter &error)
      {
        throw ExcParameter(error.path.substr(0, 5),
                           error.problem.substr(0, 28));
      }
  });
  expect_error("a joint twice", []() {
    MechanismParameters p = steel(1);
    p.joints.push_back(p.joints[1]);
    p.joints.back().name = "crank_pin_2";
    simulate(p);
  });
  expect_error("no driver", []() {
    MechanismParameters p = steel(1);
    p.drivers.clear();
    simulate(p);
  });
  expect_error("negative mass", []() {
    MechanismParameters p = steel(1);
    p.bodies[2].mass      = -1.;
    simulate(p);
  });
  expect_error("pin too large", []() {
    MechanismParameters p = steel(1);
    add_steel_clearance(p, 1, 19.9e-3);
    simulate(p);
  });
}

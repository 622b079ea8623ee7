// SPDX-License-Identifier: LGPL-2.1-or-later

// A mechanism read from a parameter file in the syntax of the manual: what
// stands there in millimetres, degrees and rpm arrives in SI units. Checks name
// the parameter. The mechanism that was read is the paper's validation
// mechanism, so it gives the closed-form force at a crank angle of 50 degrees
// (reference/ideal_slider_crank_validation_literal.csv: -80.801867 N and
// 23.989130 N).

#include <deal.II/base/parameter_handler.h>

#include "report.h"
#include "slider_crank.h"
#include <tribody/base/exceptions.h>

using namespace SliderCrank;

const char *text = R"(
subsection Ground
  set Markers = O: 0 mm, 0 mm; W: 1 m, 0 m
end
subsection Body crank
  set Mass              = 0.4045 kg
  set Moment of inertia = 204e-6 kg m^2
  set Markers           = O: -19.05 mm, 0 mm; A: 19.05 mm, 0 mm
  set Initial position  = 19.05 mm, 0 mm
end
subsection Body follower
  set Mass              = 817.5 g
  set Moment of inertia = 5500e-6 kg m^2
  set Markers           = A: -50.8 mm, 0 mm; B: 50.8 mm, 0 mm
  set Initial position  = 90 mm, 1 mm
  set Initial angle     = 2 deg
end
subsection Body slider
  set Mass             = 5.5487 kg
  set Markers          = B: 0 mm, 0 mm
  set Initial position = 139.7 mm, 0 mm
end
subsection Joint ground_pin
  set Pin marker     = ground.O
  set Bushing marker = crank.O
end
subsection Joint crank_pin
  set Type                          = revolute
  set Model                         = ideal
  set Pin marker                    = crank.A
  set Bushing marker                = follower.A
  set Pin radius                    = 9.525 mm
  set Bushing radius                = 9.535 mm
  set Contact force law             = Hertz
  set Restitution coefficient       = 0.7
  set Friction law                  = none
  set Friction coefficient          = 0.2
  set Friction regularisation speed = 2 mm/s
  set Minimum approach speed        = 3 mm/s
  set Tangential damping            = 4 N s/m
end
subsection Joint wrist_pin
  set Pin marker     = slider.B
  set Bushing marker = follower.B
end
subsection Joint guide
  set Type           = translational
  set First marker   = ground.O
  set Second marker  = slider.B
  set Axis           = 0 deg
  set Relative angle = 0 deg
end
subsection Spring spring
  set First marker              = slider.B
  set Second marker             = ground.W
  set Stiffness                 = 525.4 N/m
  set Reference length          = 898.4 mm
  set Force at reference length = 90 N
  set Damping                   = 0 N s/m
end
subsection Driver motor
  set Body           = crank
  set Reference body = ground
  set Speed          = 30 rpm
  set Initial angle  = 0 deg
end
subsection Dynamics
  set Accuracy                = 1e-4
  set Maximum order           = 3
  set Samples per cycle       = 36
  set Settling tolerance      = 0.02
  set Maximum settling cycles = 7
  set Start                   = centred
end
)";

template <typename Entry>
void
declare(dealii::ParameterHandler       &prm,
        const std::string              &kind,
        std::vector<Entry>             &entries,
        const std::vector<std::string> &names)
{
  for (const std::string &name : names)
    {
      entries.emplace_back();
      entries.back().name = name;
    }
  for (Entry &entry : entries)
    {
      prm.enter_subsection(kind + " " + entry.name);
      entry.add_parameters(prm);
      prm.leave_subsection();
    }
}

template <typename Parameters>
void
expect_error(const Parameters &parameters)
{
  try
    {
      parameters.check();
      std::cout << "accepted" << std::endl;
    }
  catch (const ExcParameter &error)
    {
      std::cout << error.path << ": " << error.problem << std::endl;
    }
}

// What CycleSimulation's constructor, and so --check, has to say.
void
expect_simulation_error(const MechanismParameters &p)
{
  try
    {
      const Mechanism       mechanism(p);
      const CycleSimulation simulation(mechanism, DynamicsParameters());
      std::cout << "accepted" << std::endl;
    }
  catch (const ExcParameter &error)
    {
      // Where Newton's method does not converge, what it leaves is a matter of
      // rounding.
      const std::string::size_type hint = error.problem.find("Are the markers");
      if (hint == std::string::npos)
        std::cout << error.path << ": " << error.problem << std::endl;
      else
        std::cout << error.problem.substr(hint) << std::endl;
    }
}

// A slider-crank with ideal joints makes a full turn only if its follower is
// longer than its crank. With lengths a > l it locks where the follower stands
// upright, at arcsin(l/a): 33.4 degrees for l = 0.55 a. A second joint beside
// an ideal one determines nothing anew, with clearance or without.
void
check_simulation_errors()
{
  MechanismParameters p = validation(2);
  p.joints.push_back(p.joints[1]);
  p.joints.back().name = "second_crank_pin";
  expect_simulation_error(p);
  add_ptfe_clearance(p, 4);
  expect_simulation_error(p);

  Numbers x = {0.2, 0.11, 1., 1., 1., 1e-3, 1e-3, 0., 0.};
  expect_simulation_error(make(x, 1.));
  expect_simulation_error(make(x, 1., -M_PI));
  p = make(x, 1.);
  add_ptfe_clearance(p, 1);
  expect_simulation_error(p);
  p.drivers[0].initial_angle = M_PI / 2;
  expect_simulation_error(p);
  x.follower_length = 0.201;
  expect_simulation_error(make(x, 1.));
}

// A run that takes too long names the parameter and its value.
void
expect_too_many_steps()
{
  MechanismParameters p = validation(2);
  add_ptfe_clearance(p, 1);
  DynamicsParameters dynamics;
  dynamics.maximum_steps_per_cycle = 60;
  const Mechanism mechanism(p);
  try
    {
      CycleSimulation(mechanism, dynamics).run();
      std::cout << "accepted" << std::endl;
    }
  catch (const ExcRun &error)
    {
      const std::string message = message_of(error);
      std::cout << message.substr(0, message.find(" and has only reached"))
                << std::endl;
    }
}

int
main()
{
  MechanismParameters      p;
  DynamicsParameters       dynamics;
  dealii::ParameterHandler prm;
  prm.enter_subsection("Ground");
  p.ground.add_parameters(prm);
  prm.leave_subsection();
  declare(prm, "Body", p.bodies, {"crank", "follower", "slider"});
  declare(prm,
          "Joint",
          p.joints,
          {"ground_pin", "crank_pin", "wrist_pin", "guide"});
  declare(prm, "Spring", p.springs, {"spring"});
  declare(prm, "Driver", p.drivers, {"motor"});
  prm.enter_subsection("Dynamics");
  dynamics.add_parameters(prm);
  prm.leave_subsection();
  prm.parse_input_from_string(text);

  const JointParameters &joint = p.joints[1];
  std::cout << joint.pin_radius * 1e3 << ' ' << joint.bushing_radius * 1e3
            << ' ' << joint.contact_force_law << ' '
            << joint.restitution_coefficient << ' ' << joint.friction_law << ' '
            << joint.friction_coefficient << ' '
            << joint.friction_regularisation_speed * 1e3 << ' '
            << joint.minimum_approach_speed * 1e3 << ' '
            << joint.tangential_damping << std::endl
            << dynamics.accuracy << ' ' << dynamics.maximum_order << ' '
            << dynamics.samples_per_cycle << ' ' << dynamics.settling_tolerance
            << ' ' << dynamics.maximum_settling_cycles << ' ' << dynamics.start
            << std::endl
            << p.drivers[0].speed / M_PI << ' '
            << p.bodies[1].initial_angle * 180 / M_PI << std::endl;

  const DutyCycle cycle = CycleSimulation(Mechanism(p), dynamics).run();
  // 36 samples: every 10 degrees.
  report_value("force at 50 degrees, x [N]",
               cycle.joint("crank_pin").force_x(5),
               4);
  report_value("force at 50 degrees, y [N]",
               cycle.joint("crank_pin").force_y(5),
               4);

  JointParameters wrong         = joint;
  wrong.model                   = JointModel::clearance;
  wrong.restitution_coefficient = 0.;
  expect_error(wrong);
  wrong                               = joint;
  wrong.model                         = JointModel::clearance;
  wrong.friction_regularisation_speed = 0.;
  expect_error(wrong);
  SpringParameters spring = p.springs[0];
  spring.stiffness        = -1.;
  expect_error(spring);
  DriverParameters driver = p.drivers[0];
  driver.reference_body   = "crank";
  expect_error(driver);
  p.bodies[1].name = "crank";
  expect_error(p);
  p.bodies[1].name = "ground";
  expect_error(p);
  dynamics.accuracy = 1.;
  expect_error(dynamics);
  check_simulation_errors();
  expect_too_many_steps();
}

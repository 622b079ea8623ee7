// SPDX-License-Identifier: LGPL-2.1-or-later

// Where pins are when a motion starts, for every model of a joint.
//
// An arm, its centre of mass at the distance L from its bushing, that a motor
// turns at omega around a pin on the ground, without friction: pin and arm turn
// together, the centre of mass at the distance L + |e| from the pin, so that
// it moves at omega (L + |e|) and the force is m omega^2 (L + |e|).
//
// A bar that is let go from the horizontal, hung at its end: the force there is
// m g/4, its length l in the mechanism being as good as the clearance is small
// beside it; the pin is above the middle of the bore by the clearance, and the
// bar at rest.
//
// A mass that a motor moves as sin(omega t): the force reverses at the start,
// and no pin can follow that. It rests, and the start says so.
//
// A four-bar with three joints that have clearance: velocities and forces of
// ideal joints, to the clearance over the crank, 0.005, and what friction and
// the mechanism make of it: 3 %.
//
// The motion that begins so goes on: after a hundredth of a cycle joints have
// the forces of ideal ones.

#include "report.h"
#include <tribody/multibody/cycle/cycle_simulation.h>
#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/multibody/following/slow_motion_start.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>

#include <cmath>
#include <string>

using namespace Tribody;
using namespace Tribody::Multibody;

constexpr double clearance = 1e-3, g = 10., mass = 2.;

BodyParameters
bar(const std::string &name, const double length, const double x)
{
  BodyParameters body;
  body.name              = name;
  body.mass              = mass;
  body.moment_of_inertia = mass * length * length / 12.;
  body.markers           = {{"l", {-length / 2, 0.}}, {"r", {length / 2, 0.}}};
  body.initial_position  = {x, 0.};
  return body;
}

JointParameters
make_joint(const std::string &name,
           const std::string &pin,
           const std::string &bushing,
           const JointModel   model,
           const double       mu)
{
  JointParameters joint;
  joint.name                 = name;
  joint.pin_marker           = pin;
  joint.bushing_marker       = bushing;
  joint.model                = model;
  joint.pin_radius           = 10e-3;
  joint.bushing_radius       = joint.pin_radius + clearance;
  joint.contact_force_law    = ContactForceLawChoice::of<SpringDamperLaw>();
  joint.contact_stiffness    = 1e8;
  joint.friction_coefficient = mu;
  joint.capture_speed        = 1e-2;
  return joint;
}

std::string
name(const JointModel model)
{
  return model == JointModel::clearance       ? "clearance"
         : model == JointModel::massless_link ? "massless link"
                                              : "impact";
}

struct Start
{
  Start(const MechanismParameters &p, const double cycle)
    : mechanism(p)
    , closed_mechanism(with_ideal_joints(p))
    , closed(closed_mechanism, {})
    , equations(mechanism, nominal_clearances(mechanism))
    , start(compute_slow_motion_start(equations, closed, 0., cycle / 360.))
  {}

  // Of the pin's centre from the bushing's.
  Eigen::Vector2d
  eccentricity(const unsigned int j) const
  {
    const JointEntry &joint = mechanism.joints()[j];
    const PairVector  q     = joint.bodies.gather(start.state.q);
    return q.head<2>() + turned(joint.first_position, q(2)) - q.segment<2>(3) -
           turned(joint.second_position, q(5));
  }

  const Mechanism         mechanism;
  const Mechanism         closed_mechanism;
  const EquationsOfMotion closed;
  const EquationsOfMotion equations;
  const StartingState     start;
};

// The force of joint number j a hundredth of a cycle after the start.
double
force_after(const MechanismParameters &p,
            const double               cycle,
            const unsigned int         j)
{
  DynamicsParameters dynamics;
  dynamics.joint_motion            = JointMotion::dynamic;
  dynamics.cycle_duration          = cycle;
  dynamics.samples_per_cycle       = 100;
  dynamics.maximum_settling_cycles = 0;
  const Mechanism mechanism(p);
  const DutyCycle motion = CycleSimulation(mechanism, dynamics).run();
  return motion.joints[j].force()(1);
}

void
turning_arm(const JointModel model)
{
  constexpr double    length = 0.5, omega = 8.;
  MechanismParameters p;
  p.ground.markers = {{"O", {0., 0.}}};
  p.bodies         = {bar("arm", 2 * length, length)};
  p.joints         = {make_joint("pivot", "ground.O", "arm.l", model, 0.)};
  DriverParameters motor;
  motor.name  = "motor";
  motor.body  = "arm";
  motor.speed = omega;
  p.drivers   = {motor};
  const Start  s(p, 2 * M_PI / omega);
  const double e = s.eccentricity(0).norm();
  std::cout << "turning arm, " << name(model) << ": " << s.start.report.message
            << std::endl;
  report_below("  |e|/c - 1", std::abs(e / clearance - 1.), 1e-3);
  report_below("  speed, relative error",
               std::abs(s.start.state.v(1) / (omega * (length + e)) - 1.),
               1e-8);
  report_below("  speed along the arm over that",
               std::abs(s.start.state.v(0) / s.start.state.v(1)),
               1e-8);
  report_below("  force later, relative error",
               std::abs(force_after(p, 2 * M_PI / omega, 0) /
                          (mass * omega * omega * (length + e)) -
                        1.),
               1e-3);
}

void
pendulum(const JointModel model)
{
  constexpr double    length = 1.;
  MechanismParameters p;
  p.gravity        = {0., -g};
  p.ground.markers = {{"O", {0., 0.}}};
  p.bodies         = {bar("bar", length, length / 2)};
  p.joints         = {make_joint("pivot", "ground.O", "bar.l", model, 0.)};
  const Start s(p, 1.);
  std::cout << "pendulum, " << name(model) << ": " << s.start.report.message
            << std::endl;
  report_below(
    "  place of the pin over c, error",
    (s.eccentricity(0) / clearance - Eigen::Vector2d::UnitY()).norm(),
    3.3 * clearance / length);
  report_below("  speed [m/s]", s.start.state.v.norm(), 1e-12);
  if (model == JointModel::clearance)
    report_below("  force over m g/4, error",
                 std::abs(
                   s.equations.compute_contact(0, s.start.state).normal_force /
                     (mass * g / 4.) -
                   1.),
                 1e-2);
  // It has fallen by 1/2 3/2 g/l t^2 = 7.5e-4 rad.
  report_below("  force later over m g/4, error",
               std::abs(force_after(p, 1., 0) / (mass * g / 4.) - 1.),
               5e-2);
}

void
reversing_force(const JointModel model)
{
  MechanismParameters p;
  p.ground.markers = {{"O", {0., 0.}}};
  p.bodies         = {bar("ram", 0.2, 0.), bar("load", 0.2, 0.2)};
  p.joints         = {make_joint("pin", "ram.r", "load.l", model, 0.1)};
  JointParameters guide;
  guide.type          = JointType::translational;
  guide.first_marker  = "ground.O";
  guide.second_marker = "ram.l";
  guide.name          = "guide of the ram";
  p.joints.push_back(guide);
  guide.name          = "guide of the load";
  guide.type          = JointType::point_on_line;
  guide.second_marker = "load.r";
  p.joints.push_back(guide);
  p.ground.markers["E"] = {-1., 0.};
  DriverParameters motor;
  motor.name               = "motor";
  motor.type               = DriverType::distance;
  motor.first_marker       = "ground.E";
  motor.second_marker      = "ram.l";
  motor.initial_distance   = 0.9;
  motor.distance_amplitude = 0.1;
  motor.time_function      = "sin(2*pi*t)";
  p.drivers                = {motor};
  const Start        s(p, 1.);
  const std::string &message = s.start.report.message;
  std::cout << "reversing force, " << name(model)
            << ": says that the pin is at rest: "
            << (message.find("at rest in their bores") != std::string::npos)
            << std::endl;
  report_below("  |e|/c - 1",
               std::abs(s.eccentricity(0).norm() / clearance - 1.),
               1e-6);
  report_below("  speeds of ram and load differ by",
               std::abs(s.start.state.v(0) - s.start.state.v(3)),
               1e-12);
}

void
four_bar(const JointModel model)
{
  MechanismParameters p;
  p.gravity                    = {0., -g};
  p.ground.markers             = {{"O", {0., 0.}}, {"D", {0.7, 0.}}};
  p.bodies                     = {bar("crank", 0.2, 0.),
                                  bar("coupler", 0.6, 0.),
                                  bar("rocker", 0.5, 0.)};
  p.bodies[0].initial_position = {0.1, 0.};
  p.bodies[1].initial_position = {0.45, 0.2};
  p.bodies[1].initial_angle    = 1.;
  p.bodies[2].initial_position = {0.65, 0.25};
  p.bodies[2].initial_angle    = 1.7;
  p.joints = {make_joint("O", "ground.O", "crank.l", JointModel::ideal, 0.1),
              make_joint("A", "crank.r", "coupler.l", model, 0.1),
              make_joint("B", "coupler.r", "rocker.r", model, 0.1),
              make_joint("D", "ground.D", "rocker.l", model, 0.1)};
  DriverParameters motor;
  motor.name  = "motor";
  motor.body  = "crank";
  motor.speed = 10.;
  p.drivers   = {motor};
  const Start  s(p, 2 * M_PI / 10.);
  const Motion ideal =
    solve_motion(s.closed,
                 0.,
                 ConstraintOffsets(s.closed_mechanism.n_constraints()),
                 Eigen::VectorXd::Zero(9),
                 assemble_configuration(s.closed, 0.));
  std::cout << "four-bar, " << name(model) << std::endl;
  report_below("  velocities, relative difference",
               (s.start.state.v - ideal.v).norm() / ideal.v.norm(),
               2e-2);
  const DutyCycle ideal_cycle =
    CycleSimulation(s.closed_mechanism, DynamicsParameters()).run();
  for (const unsigned int j : {1, 2, 3})
    {
      DynamicsParameters dynamics;
      dynamics.maximum_settling_cycles = 0;
      const DutyCycle cycle = CycleSimulation(s.mechanism, dynamics).run();
      report_below("  first force of " + s.mechanism.joints()[j].name +
                     ", relative difference",
                   std::abs(cycle.joints[j].force()(0) /
                              ideal_cycle.joints[j].force()(0) -
                            1.),
                   3e-2);
    }
}

int
main()
{
  for (const JointModel model :
       {JointModel::clearance, JointModel::massless_link, JointModel::impact})
    {
      turning_arm(model);
      pendulum(model);
      reversing_force(model);
      four_bar(model);
    }
}

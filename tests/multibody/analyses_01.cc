// SPDX-License-Identifier: LGPL-2.1-or-later

// Analyses and elements against closed forms.
//
// Scotch yoke: x = r cos(w t); force in the slot -m r w^2 cos(w t). Four-bar:
// the rocker's angle from the loop's triangle, its rates by the linear
// equations of the loop (positions, velocities and accelerations do not depend
// on masses, which a kinematic analysis may leave out). The integrated motion
// of the fully driven four-bar has the same forces as inverse dynamics.
//
// Actuators that follow an expression: a mass on a slide pushed by a distance
// driver L_0 + a sin(w t) needs the force -m a w^2 sin(w t); a pendulum swung
// by phi = a sin(w t) loads its pin with m (l phi'^2 + g cos(phi)) along the
// bar and m (l phi'' + g sin(phi)) across it. The derivatives of the expression
// are known to 1e-10, so are the forces.
//
// Static equilibrium: the slider force that balances a crank torque, from the
// virtual work; pendulum with rotational spring, from a scalar equation; it
// falls from the upright position and rests where it leans; the ground carries
// the weight of a four-bar; a pin that hangs in its bushing presses
// itself in until Hertz' force is the weight. A wheel that a torque turns has
// no equilibrium.
//
// Start: an initial angular velocity is projected onto the joints; the pendulum
// then rises to the height that its energy allows. Rough guesses, turned by 60
// deg and moved by a link's length, close to the same four-bar.

#include "report.h"
#include <tribody/base/exceptions.h>
#include <tribody/multibody/cycle/cycle_simulation.h>
#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/multibody/motion/motion_integrator.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>
#include <tribody/multibody/system/static_equilibrium.h>

#include <cmath>
#include <complex>

using namespace Tribody;
using namespace Tribody::Multibody;

constexpr double g = 9.81;

BodyParameters
body(const std::string                             &name,
     const double                                   mass,
     const double                                   moment_of_inertia,
     const std::map<std::string, dealii::Point<2>> &markers,
     const dealii::Point<2>                        &position = {},
     const double                                   angle    = 0.)
{
  BodyParameters b;
  b.name              = name;
  b.mass              = mass;
  b.moment_of_inertia = moment_of_inertia;
  b.markers           = markers;
  b.initial_position  = position;
  b.initial_angle     = angle;
  return b;
}

JointParameters
revolute(const std::string &name,
         const std::string &pin,
         const std::string &bushing)
{
  JointParameters j;
  j.name           = name;
  j.pin_marker     = pin;
  j.bushing_marker = bushing;
  return j;
}

JointParameters
joint(const std::string &name,
      const JointType    type,
      const std::string &first,
      const std::string &second,
      const double       axis = 0.)
{
  JointParameters j;
  j.name          = name;
  j.type          = type;
  j.first_marker  = first;
  j.second_marker = second;
  j.axis_angle    = axis;
  return j;
}

DriverParameters
motor(const std::string &name, const double speed)
{
  DriverParameters d;
  d.name  = "motor";
  d.body  = name;
  d.speed = speed;
  return d;
}

DutyCycle
run(const MechanismParameters &p,
    const Analysis             analysis,
    const double               duration = 0.,
    const double               accuracy = 3e-4)
{
  const Mechanism    mechanism(p);
  DynamicsParameters dynamics;
  dynamics.analysis                = analysis;
  dynamics.cycle_duration          = duration;
  dynamics.accuracy                = accuracy;
  dynamics.maximum_settling_cycles = 0;
  return CycleSimulation(mechanism, dynamics).run();
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
  catch (const ExcRun &error)
    {
      std::cout << "run: " << message_of(error) << std::endl;
    }
}

void
scotch_yoke()
{
  const double        r = 0.05, w = 20 * M_PI, m = 0.5;
  MechanismParameters p;
  p.bodies = {body("crank", 0.2, 1e-4, {{"O", {}}, {"A", {r, 0.}}}),
              body("yoke", m, 1e-3, {{"slot", {}}}, {r, 0.})};
  p.joints = {
    revolute("pin", "ground.O", "crank.O"),
    joint("slot", JointType::point_on_line, "yoke.slot", "crank.A", M_PI / 2),
    joint("guide", JointType::translational, "ground.O", "yoke.slot")};
  p.drivers = {motor("crank", w)};

  const DutyCycle cycle = run(p, Analysis::inverse_dynamics);
  double          x = 0., v = 0., a = 0., f = 0.;
  for (unsigned int s = 0; s < cycle.time.size(); ++s)
    {
      const double c = std::cos(w * cycle.time(s)),
                   n = std::sin(w * cycle.time(s));
      x              = std::max(x, std::abs(cycle.coordinates(3, s) - r * c));
      v = std::max(v, std::abs(cycle.velocities(3, s) + r * w * n));
      a = std::max(a, std::abs(cycle.accelerations(3, s) + r * w * w * c));
      // Of the yoke, the first body, on the crank.
      f =
        std::max(f,
                 std::abs(cycle.joint("slot").force_x(s) - m * r * w * w * c));
    }
  report_below("Scotch yoke: position", x / r, 1e-12);
  report_below("  velocity", v / (r * w), 1e-12);
  report_below("  acceleration", a / (r * w * w), 1e-12);
  report_below("  force in the slot", f / (m * r * w * w), 1e-12);
}

MechanismParameters
four_bar(const double masses = 1.)
{
  MechanismParameters p;
  p.gravity        = {0., -g};
  p.ground.markers = {{"A", {}}, {"D", {0.2, 0.}}};
  const double m   = masses;
  p.bodies         = {body("crank",
                   0.05 * m,
                   16e-6 * m,
                   {{"A", {-0.03, 0.}}, {"B", {0.03, 0.}}},
                   {0.03, 0.}),
                      body("coupler",
                   0.14 * m,
                   380e-6 * m,
                   {{"B", {-0.09, 0.}}, {"C", {0.09, 0.}}},
                   {0.12, 0.06},
                   0.8),
                      body("rocker",
                   0.11 * m,
                   178e-6 * m,
                   {{"D", {-0.07, 0.}}, {"C", {0.07, 0.}}},
                   {0.2, 0.07},
                   1.5)};
  p.joints         = {revolute("A", "ground.A", "crank.A"),
                      revolute("B", "crank.B", "coupler.B"),
                      revolute("C", "coupler.C", "rocker.C"),
                      revolute("D", "ground.D", "rocker.D")};
  p.drivers        = {motor("crank", 10 * M_PI)};
  return p;
}

// Angles, angular velocities and accelerations of coupler and rocker.
struct FourBarMotion
{
  std::complex<double> angles, rates, accelerations;
};

FourBarMotion
four_bar_motion(const double theta, const double w)
{
  using complex   = std::complex<double>;
  const double  a = 0.06, b = 0.18, c = 0.14, d = 0.2;
  const complex i(0., 1.);
  const complex crank = a * std::exp(i * theta);
  // Triangle B-C-D with C above.
  const complex diagonal = d - crank;
  const double  l        = std::abs(diagonal);
  const double  at_b     = std::acos((b * b + l * l - c * c) / (2 * b * l));
  const double  phi      = std::arg(diagonal) + at_b;
  const complex u        = b * std::exp(i * phi);
  const complex rocker   = crank + u - d;
  const double  psi      = std::arg(rocker);
  // crank + u - d - rocker = 0, differentiated: x i u - y i rocker = right.
  const auto solve = [&](const complex &right) {
    const complex p = i * u, q = -i * rocker;
    const double  det = p.real() * q.imag() - p.imag() * q.real();
    return complex((right.real() * q.imag() - right.imag() * q.real()) / det,
                   (p.real() * right.imag() - p.imag() * right.real()) / det);
  };
  const complex rates = solve(-i * w * crank);
  const complex accelerations =
    solve(w * w * crank + rates.real() * rates.real() * u -
          rates.imag() * rates.imag() * rocker);
  return {complex(phi, psi), rates, accelerations};
}

void
check_four_bar()
{
  const double    w     = 10 * M_PI;
  const DutyCycle cycle = run(four_bar(0.), Analysis::kinematic);
  double          x = 0., v = 0., a = 0.;
  for (unsigned int s = 0; s < cycle.time.size(); ++s)
    {
      const FourBarMotion exact = four_bar_motion(w * cycle.time(s), w);
      const auto          found = [s](const Eigen::MatrixXd &values) {
        return std::complex<double>(values(5, s), values(8, s));
      };
      x = std::max(x, std::abs(found(cycle.coordinates) - exact.angles));
      v = std::max(v, std::abs(found(cycle.velocities) - exact.rates) / w);
      a = std::max(a,
                   std::abs(found(cycle.accelerations) - exact.accelerations) /
                     (w * w));
    }
  report_below("four-bar without masses: angles", x, 1e-11);
  report_below("  angular velocities", v, 1e-11);
  report_below("  angular accelerations", a, 1e-11);
  report_value("  joint forces, not computed [N]",
               cycle.joint("B").peak_force(),
               1);

  const DutyCycle inverse    = run(four_bar(), Analysis::inverse_dynamics);
  const DutyCycle integrated = run(four_bar(), Analysis::dynamic);
  double          f          = 0.;
  for (const std::string name : {"A", "B", "C", "D"})
    f = std::max(f,
                 (inverse.joint(name).force() - integrated.joint(name).force())
                     .lpNorm<Eigen::Infinity>() /
                   inverse.joint(name).peak_force());
  report_below("four-bar integrated: relative error of the forces", f, 1e-6);

  // Without mass in the coupler, it is a member with two forces: the same along
  // it as at tiny masses.
  MechanismParameters light = four_bar();
  light.bodies[1].mass = light.bodies[1].moment_of_inertia = 0.;
  const DutyCycle massless = run(light, Analysis::inverse_dynamics);
  double          turn     = 0.;
  for (unsigned int s = 0; s < massless.time.size(); ++s)
    {
      const Eigen::Vector2d force(massless.joint("B").force_x(s),
                                  massless.joint("B").force_y(s));
      const double          phi = massless.coordinates(5, s);
      turn                      = std::max(turn,
                      std::abs(force.x() * std::sin(phi) -
                               force.y() * std::cos(phi)));
    }
  report_below("massless coupler: force across it",
               turn / massless.joint("B").peak_force(),
               1e-12);
  // The same while it moves freely: crank and rocker carry it along.
  light.drivers.clear();
  report_below("  free motion: constraint drift [nm]",
               1e9 * run(light, Analysis::dynamic, 0.5).constraint_drift,
               10.);

  MechanismParameters rough = four_bar();
  for (BodyParameters &b : rough.bodies)
    {
      b.initial_angle += M_PI / 3;
      b.initial_position += dealii::Point<2>(0.1, 0.15);
    }
  const Mechanism   near(four_bar()), far(rough);
  EquationsOfMotion near_equations(near, {}), far_equations(far, {});
  report_below("from rough guesses: difference",
               (assemble_configuration(near_equations, 0.) -
                assemble_configuration(far_equations, 0.))
                 .lpNorm<Eigen::Infinity>(),
               1e-12);
}

void
expressions()
{
  const double        m = 3., a = 0.02, w = 30.;
  MechanismParameters p;
  p.bodies = {body("mass", m, 1., {{"O", {}}}, {0.3, 0.})};
  p.joints = {joint("slide", JointType::translational, "ground.O", "mass.O")};
  DriverParameters push;
  push.name               = "push";
  push.type               = DriverType::distance;
  push.first_marker       = "ground.W";
  push.second_marker      = "mass.O";
  push.initial_distance   = 0.5;
  push.distance_amplitude = a;
  push.time_function      = "sin(30*t)";
  p.drivers               = {push};
  p.ground.markers        = {{"O", {}}, {"W", {-0.2, 0.}}};
  const Mechanism         mechanism(p);
  const EquationsOfMotion equations(mechanism, {});
  const double            t = 0.123;
  const Motion            motion =
    solve_motion(equations,
                 t,
                 ConstraintOffsets(mechanism.n_constraints()),
                 Eigen::VectorXd::Zero(3),
                 assemble_configuration(equations, t));
  const auto &[driver, row] = mechanism.constraints()[1];
  report_below("distance driver: relative error of its force",
               std::abs(
                 driver
                     ->reaction_force(driver->bodies.gather(motion.q),
                                      driver->gather(motion.multipliers, row))
                     .x() /
                   (-m * a * w * w * std::sin(w * t)) -
                 1),
               1e-9);

  MechanismParameters q;
  const double        l = 0.4, swing = 0.7;
  q.gravity = {0., -g};
  q.bodies  = {body("bar", m, 0.1, {{"O", {0., l}}}, {0., -l})};
  q.joints  = {revolute("pin", "ground.O", "bar.O")};
  q.drivers = {motor("bar", 0.)};
  q.drivers[0].angle_amplitude = swing;
  q.drivers[0].time_function   = "sin(30*t)";
  const DutyCycle cycle = run(q, Analysis::inverse_dynamics, 2 * M_PI / w);
  double          error = 0.;
  for (unsigned int s = 0; s < cycle.time.size(); ++s)
    {
      const double          phase  = w * cycle.time(s);
      const double          phi    = swing * std::sin(phase);
      const double          phi_t  = swing * w * std::cos(phase);
      const double          phi_tt = -swing * w * w * std::sin(phase);
      const Eigen::Vector2d force(cycle.joint("pin").force_x(s),
                                  cycle.joint("pin").force_y(s));
      // Of the ground on the bar: along towards the pin, across to the right.
      const Eigen::Vector2d expected =
        turned({m * (l * phi_tt + g * std::sin(phi)),
                m * (l * phi_t * phi_t + g * std::cos(phi))},
               phi);
      error = std::max(error, (force - expected).norm());
    }
  report_below("swung pendulum: relative error of the pin's force",
               error / (m * l * swing * w * w),
               1e-9);
  expect_error("unbalanced bracket", [&q]() {
    q.drivers[0].time_function = "sin(30*t";
    run(q, Analysis::inverse_dynamics, 1.);
  });
  expect_error("no cycle", [&q]() {
    q.drivers[0].time_function = "sin(30*t)";
    run(q, Analysis::inverse_dynamics);
  });
}

void
statics()
{
  // Slider-crank at 50 deg: M = F ds/dphi with s the slider's position.
  const double        a = 0.1, b = 0.25, torque = 2.;
  MechanismParameters p;
  const double        phi   = 0.9;
  const double        psi   = -std::asin(a / b * std::sin(phi));
  const double        x     = a * std::cos(phi) + b * std::cos(psi);
  const double        x_phi = -a * std::sin(phi) - a * a * std::sin(phi) *
                                              std::cos(phi) /
                                              (b * std::cos(psi));
  p.bodies = {body("crank", 1., 1., {{"O", {}}, {"A", {a, 0.}}}, {}, phi),
              body("rod",
                   1.,
                   1.,
                   {{"A", {}}, {"B", {b, 0.}}},
                   {a * std::cos(phi), a * std::sin(phi)},
                   psi),
              body("slider", 1., 1., {{"B", {}}}, {x, 0.})};
  p.joints = {revolute("O", "ground.O", "crank.O"),
              revolute("A", "crank.A", "rod.A"),
              revolute("B", "rod.B", "slider.B"),
              joint("guide", JointType::translational, "ground.O", "slider.B")};
  TorqueParameters drive;
  drive.name   = "drive";
  drive.body   = "crank";
  drive.torque = torque;
  p.torques    = {drive};
  SpringParameters spring;
  spring.name             = "spring";
  spring.first_marker     = "ground.O";
  spring.second_marker    = "slider.B";
  spring.stiffness        = 5000.;
  spring.reference_length = x;
  // Tension pulls the slider back: torque + (-tension) x_phi = 0.
  spring.force_at_reference_length = torque / x_phi;
  p.springs                        = {spring};
  // Off the equilibrium.
  p.bodies[0].initial_angle += 0.3;
  const DutyCycle still = run(p, Analysis::static_equilibrium);
  report_below("slider-crank: crank angle",
               std::abs(still.coordinates(2, 0) - phi),
               1e-9);
  report_value("  force of the spring [N]", -torque / x_phi, 3);
  report_value("  in the wrist pin, along x [N]",
               still.joint("B").force_x(0),
               3);

  // Pendulum from the upright position, 1e-3 N m/rad against 0.5 m g.
  MechanismParameters q;
  q.gravity        = {0., -g};
  q.bodies         = {body("bar", 2., 0.1, {{"O", {0., -0.5}}}, {0., 0.5})};
  q.joints         = {revolute("pin", "ground.O", "bar.O")};
  DutyCycle fallen = run(q, Analysis::static_equilibrium);
  report_below("pendulum: falls to the bottom",
               std::abs(fallen.coordinates(1, 0) + 0.5),
               1e-12);
  RotationalSpringParameters hold;
  hold.name            = "hold";
  hold.body            = "bar";
  hold.stiffness       = 30.;
  hold.reference_angle = -0.4;
  q.rotational_springs = {hold};
  fallen               = run(q, Analysis::static_equilibrium);
  const double angle   = fallen.coordinates(2, 0);
  report_below("  leans against its spring: torque left [N m]",
               std::abs(30 * (angle + 0.4) - 2 * g * 0.5 * std::sin(angle)),
               1e-8);
  report_value("  at [deg]", angle * 180 / M_PI, 2);

  // A motion that starts there stays there.
  DynamicsParameters rest;
  rest.cycle_duration          = 1.;
  rest.maximum_settling_cycles = 0;
  rest.start                   = MotionStart::static_equilibrium;
  q.bodies[0].initial_angle    = 0.5;
  const Mechanism at_rest(q);
  report_below("  started there: largest angular velocity",
               CycleSimulation(at_rest, rest)
                 .run()
                 .velocities.row(2)
                 .lpNorm<Eigen::Infinity>(),
               1e-8);

  // The ground's forces carry the weight of a four-bar in all positions of its
  // motor, whose moment they do not know.
  const DutyCycle turned_slowly = run(four_bar(), Analysis::static_equilibrium);
  const double    weight        = (0.05 + 0.14 + 0.11) * g;
  report_below("four-bar: relative error of the weight carried",
               ((turned_slowly.joint("A").force_y.array() +
                 turned_slowly.joint("D").force_y.array()) /
                  weight -
                1)
                 .abs()
                 .maxCoeff(),
               1e-12);
  report_below("  horizontal force left, over it",
               (turned_slowly.joint("A").force_x.array() +
                turned_slowly.joint("D").force_x.array())
                   .abs()
                   .maxCoeff() /
                 weight,
               1e-12);

  // A pin in a bushing above which it hangs.
  MechanismParameters h;
  h.gravity                         = {0., -g};
  h.bodies                          = {body("load", 20., 1., {{"O", {}}})};
  JointParameters loose             = revolute("joint", "load.O", "ground.O");
  loose.model                       = JointModel::clearance;
  loose.contact_force_law           = ContactForceLawChoice::of<HertzLaw>();
  loose.pin_radius                  = 19e-3;
  loose.bushing_radius              = 20e-3;
  loose.pin_material.youngs_modulus = 206.8e9;
  loose.pin_material.poissons_ratio = 0.29;
  loose.bushing_material            = loose.pin_material;
  h.joints                          = {loose};
  const DutyCycle hanging           = run(h, Analysis::static_equilibrium);
  report_below("loose pin: relative error of the contact force",
               std::abs(hanging.joint("joint").normal_force(0) / (20 * g) - 1),
               1e-8);
  report_value("  eccentricity [um]",
               1e6 * hanging.joint("joint").eccentricity(0),
               3);

  expect_error("wheel with a torque", []() {
    MechanismParameters wheel;
    wheel.bodies = {body("wheel", 1., 1., {{"O", {}}})};
    wheel.joints = {revolute("pin", "ground.O", "wheel.O")};
    TorqueParameters twist;
    twist.name    = "twist";
    twist.body    = "wheel";
    twist.torque  = 1.;
    wheel.torques = {twist};
    run(wheel, Analysis::static_equilibrium);
  });
}

void
starts()
{
  MechanismParameters p;
  const double        l = 0.5, m = 2., inertia = 0.1, rate = 3.;
  p.gravity = {0., -g};
  p.bodies  = {body("bar", m, inertia, {{"O", {0., l}}}, {0., -l})};
  p.joints  = {revolute("pin", "ground.O", "bar.O")};
  p.bodies[0].initial_velocity         = {l * rate, 0.};
  p.bodies[0].initial_angular_velocity = rate;
  const Mechanism         mechanism(p);
  const EquationsOfMotion equations(mechanism, {});
  const Eigen::VectorXd   q = assemble_configuration(equations, 0.);
  report_below("allowed initial velocities are kept",
               (compute_initial_velocities(equations, 0., q) -
                Eigen::Vector3d(l * rate, 0., rate))
                 .norm(),
               1e-12);
  // Those that are not allowed become so.
  p.bodies[0].initial_velocity = {-1., 0.7};
  const Mechanism         pushed(p);
  const EquationsOfMotion pushed_equations(pushed, {});
  const Eigen::VectorXd v = compute_initial_velocities(pushed_equations, 0., q);
  Eigen::MatrixXd       phi_q(2, 3);
  pushed_equations.assemble_constraint_jacobian(q, phi_q);
  report_below("others are projected", (phi_q * v).norm(), 1e-12);
  p.bodies[0].initial_velocity = {l * rate, 0.};
  // Period about 1.7 s: the highest point is in the first second.
  const DutyCycle cycle  = run(p, Analysis::dynamic, 1., 1e-5);
  double          error  = 0.;
  const double    energy = (m * l * l + inertia) * rate * rate / 2 - m * g * l;
  for (unsigned int s = 0; s < cycle.time.size(); ++s)
    {
      const double phi = cycle.coordinates(2, s), w = cycle.velocities(2, s);
      error = std::max(error,
                       std::abs((m * l * l + inertia) * w * w / 2 -
                                m * g * l * std::cos(phi) - energy));
    }
  report_below("pendulum: relative error of the energy",
               error / (energy + m * g * l),
               1e-6);
  report_value("  rises to [deg]",
               180 / M_PI * std::acos(1 - (energy + m * g * l) / (m * g * l)),
               2);
  report_value("  highest sample [deg]",
               180 / M_PI * cycle.coordinates.row(2).maxCoeff(),
               1);
}

void
errors()
{
  expect_error("kinematic with freedom", []() {
    MechanismParameters p = four_bar();
    p.drivers.clear();
    run(p, Analysis::kinematic, 1.);
  });
  expect_error("massless and free", []() {
    MechanismParameters p = four_bar();
    p.drivers.clear();
    p.joints.pop_back();
    p.bodies[2].moment_of_inertia = 0.;
    p.bodies[2].mass              = 0.;
    run(p, Analysis::dynamic, 1.);
  });
  expect_error("parallelogram through its change point", []() {
    MechanismParameters p     = four_bar();
    p.bodies[1].markers       = {{"B", {-0.1, 0.}}, {"C", {0.1, 0.}}};
    p.bodies[2].markers       = {{"D", {-0.03, 0.}}, {"C", {0.03, 0.}}};
    p.bodies[0].initial_angle = p.bodies[2].initial_angle = 1.;
    p.bodies[1].initial_angle                             = 0.;
    p.drivers[0].initial_angle                            = M_PI / 3;
    run(p, Analysis::inverse_dynamics);
  });
  // A bar of 0.3 m on a pin of the ground, its end held by a second bar of
  // 0.2 m, that an actuator pulls out of reach.
  expect_error("actuator too long during the motion", []() {
    MechanismParameters p;
    p.bodies = {
      body("bar", 1., 0.1, {{"O", {}}, {"A", {0.3, 0.}}}),
      body("end", 1., 0.1, {{"A", {}}, {"B", {0.2, 0.}}}, {0.3, 0.}, 1.)};
    p.joints = {revolute("O", "ground.O", "bar.O"),
                revolute("A", "bar.A", "end.A")};
    DriverParameters pull;
    pull.name             = "pull";
    pull.type             = DriverType::distance;
    pull.first_marker     = "ground.O";
    pull.second_marker    = "end.B";
    pull.initial_distance = 0.4;
    pull.distance_speed   = 0.2;
    p.drivers             = {pull};
    try
      {
        run(p, Analysis::dynamic, 1.);
      }
    catch (const ExcRun &error)
      {
        // The times and the gap depend on the integrator's last steps.
        const std::string message = message_of(error);
        const auto        begin   = message.find("there is no position");
        const auto        end     = message.find(" a gap");
        throw ExcRun(end == std::string::npos
                       ? message
                       : message.substr(begin, end - begin));
      }
  });
}

int
main()
{
  scotch_yoke();
  check_four_bar();
  expressions();
  statics();
  starts();
  errors();
}

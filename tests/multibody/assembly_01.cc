// SPDX-License-Identifier: LGPL-2.1-or-later

// Assembling mechanisms, of any size and with more constraints than needed.
//
// Size: kinematics do not know the unit of length, and with masses as its cube
// and times as its root neither do the forces: a driven four-bar from 10 um to
// 10 km has the same motion and forces, in its own units, at the origin and a
// hundred lengths away from it.
//
// Turns: initial angles that differ by whole turns are the same, in a weld, a
// slide and where a driver starts at another turn.
//
// Start: the crank of a rough four-bar without drivers keeps its angle, the
// rest closes around it; where it cannot, that is told.
//
// Redundancy: three parallel cranks. The motion is that of two of them; the
// middle of the coupler goes around in a circle. With clearance in its joint
// the mechanism has none too many, and the third crank carries no more than its
// weight and inertia. A guide that contradicts is refused, a link stretched to
// its change point too.
//
// Equilibrium: a rocking arm held by a stiff spring a hundred lengths from the
// origin.

#include "report.h"
#include <tribody/base/exceptions.h>
#include <tribody/multibody/assembly/assembly_checks.h>
#include <tribody/multibody/assembly/redundancy.h>
#include <tribody/multibody/cycle/cycle_simulation.h>
#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/multibody/system/given_start.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>
#include <tribody/multibody/system/static_equilibrium.h>

#include <cmath>

using namespace Tribody;
using namespace Tribody::Multibody;

constexpr double g = 9.81;

using Markers = std::map<std::string, dealii::Point<2>>;

BodyParameters
body(const std::string      &name,
     const double            mass,
     const double            moment_of_inertia,
     const Markers          &markers,
     const dealii::Point<2> &position,
     const double            angle = 0.)
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
joint(const JointType    type,
      const std::string &name,
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
motor(const std::string &body, const double speed, const double angle = 0.)
{
  DriverParameters d;
  d.name          = "motor";
  d.body          = body;
  d.speed         = speed;
  d.initial_angle = angle;
  return d;
}

DutyCycle
run(const MechanismParameters &p,
    const Analysis             analysis = Analysis::inverse_dynamics)
{
  DynamicsParameters dynamics;
  dynamics.analysis = analysis;
  const Mechanism mechanism(count_redundant_constraints(p));
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
}

// A ground link of 2 L, a crank of L/2, a coupler and a rocker of 2 L, at a
// distance from the origin.
MechanismParameters
four_bar(const double L, const double distance)
{
  const double           m = L * L * L, w = std::sqrt(g / L);
  const dealii::Point<2> o(distance, -distance);
  MechanismParameters    p;
  p.gravity        = {0., -g};
  p.ground.markers = {{"A", o}, {"D", o + dealii::Point<2>(2 * L, 0.)}};
  p.bodies         = {body("crank",
                   m,
                   m * L * L,
                   {{"A", {}}, {"B", {L / 2, 0.}}},
                   o + dealii::Point<2>(0.02 * L, 0.)),
                      body("coupler",
                   m,
                   m * L * L,
                   {{"B", {}}, {"C", {2 * L, 0.}}},
                   o + dealii::Point<2>(L / 2, 0.05 * L),
                   1.2),
                      body("rocker",
                   m,
                   m * L * L,
                   {{"D", {}}, {"C", {2 * L, 0.}}},
                   o + dealii::Point<2>(2 * L, 0.),
                   1.9)};
  p.joints         = {revolute("A", "ground.A", "crank.A"),
                      revolute("B", "crank.B", "coupler.B"),
                      revolute("C", "coupler.C", "rocker.C"),
                      revolute("D", "ground.D", "rocker.D")};
  p.drivers        = {motor("crank", w)};
  return p;
}

void
sizes()
{
  const DutyCycle one = run(four_bar(1., 0.));
  double          q = 0., f = 0.;
  for (const double distance : {0., 100.})
    for (const double L : {1e-5, 1e-4, 1e-3, 1., 1e3, 1e4})
      {
        const DutyCycle other = run(four_bar(L, distance * L));
        for (unsigned int s = 0; s < one.time.size(); ++s)
          {
            const auto there = [&](const int i) {
              const double shift = (i % 3 == 0 ? 1. : -1.) * distance;
              return i % 3 == 2 ? other.coordinates(i, s)
                                : other.coordinates(i, s) / L - shift;
            };
            for (int i = 0; i < 9; ++i)
              q = std::max(q, std::abs(there(i) - one.coordinates(i, s)));
            for (const char *name : {"A", "B", "C", "D"})
              f = std::max(f,
                           std::abs(other.joint(name).force_x(s) / (L * L * L) -
                                    one.joint(name).force_x(s)) /
                             one.joint("A").peak_force());
          }
      }
  report_below("Four-bars of all sizes: positions", q, 1e-11);
  report_below("  forces", f, 1e-10);
}

// Two rods welded, on a slide; the angles as given differ by turns.
Eigen::VectorXd
assemble_rods(const double turns_of_first, const double turns_of_second)
{
  const double        angle = 0.3, c = std::cos(angle), s = std::sin(angle);
  MechanismParameters p;
  p.bodies = {body("slider", 1., 1., {{"S", {}}}, {1., 0.}, 0.),
              body("a",
                   1.,
                   1.,
                   {{"l", {-1., 0.}}, {"r", {1., 0.}}},
                   {1. + c, s},
                   angle + 2 * M_PI * turns_of_first),
              body("b",
                   1.,
                   1.,
                   {{"l", {-1., 0.}}},
                   {1. + 3 * c, 3 * s},
                   angle + 2 * M_PI * turns_of_second)};
  p.joints = {joint(JointType::translational, "guide", "ground.O", "slider.S"),
              revolute("pin", "slider.S", "a.l"),
              joint(JointType::rigid, "weld", "a.r", "b.l")};
  p.bodies[0].initial_angle = 2 * M_PI * turns_of_first;
  const Mechanism mechanism(p);
  return assemble_configuration(EquationsOfMotion(mechanism, {}), 0.);
}

void
turns()
{
  const Eigen::VectorXd same  = assemble_rods(0., 0.);
  double                moved = 0.;
  for (const auto &[one, two] : {std::pair(1., 0.), std::pair(-1., 2.)})
    {
      Eigen::VectorXd q = assemble_rods(one, two) - same;
      for (int i = 2; i < 9; i += 3)
        q(i) = std::remainder(q(i), 2 * M_PI);
      moved = std::max(moved, q.lpNorm<Eigen::Infinity>());
    }
  report_below("Rods whose angles differ by turns: moved", moved, 1e-12);

  MechanismParameters   p = four_bar(1., 0.);
  const Mechanism       at_zero(p);
  const Eigen::VectorXd q =
    assemble_configuration(EquationsOfMotion(at_zero, {}), 0.);
  p.drivers[0].initial_angle = 4 * M_PI;
  const Mechanism       at_two(p);
  const Eigen::VectorXd q_two =
    assemble_configuration(EquationsOfMotion(at_two, {}), 0.);
  report_below("A driver that begins two turns on: rest moved",
               (q_two - q).tail<6>().lpNorm<Eigen::Infinity>(),
               1e-12);
  report_value("  turns of the crank", (q_two(2) - q(2)) / (2 * M_PI), 6);
}

void
start()
{
  MechanismParameters p = four_bar(1., 0.);
  p.drivers.clear();
  p.bodies[0].initial_angle = 1.;
  const Mechanism         mechanism(p);
  const EquationsOfMotion equations(mechanism, {});
  const Eigen::VectorXd   q = assemble_configuration(equations, 0.);
  report_below("Rough four-bar without drivers: turn of its crank",
               std::abs(q(2) - 1.),
               1e-9);
  std::cout << "  told: '" << explain_changed_start(equations, q) << "'"
            << std::endl;

  // A crank as long as the other links that is given where these cannot reach.
  p.bodies[0].markers["B"]  = {3., 0.};
  p.bodies[0].initial_angle = 2.9;
  const Mechanism         out_of_reach(p);
  const EquationsOfMotion equations_there(out_of_reach, {});
  std::cout << "  out of reach, told: '"
            << explain_changed_start(equations_there,
                                     assemble_configuration(equations_there,
                                                            0.))
            << "'" << std::endl;
}

// A coupler on three cranks of length one, two apart from each other.
MechanismParameters
three_cranks()
{
  MechanismParameters p;
  p.gravity = {0., -g};
  p.bodies  = {body("coupler",
                   2.,
                   1.,
                   {{"0", {-2., 0.}}, {"1", {}}, {"2", {2., 0.}}},
                   {2. + std::cos(1.), std::sin(1.)})};
  for (const char *k : {"0", "1", "2"})
    {
      const std::string name  = k;
      const double      place = 2. * std::stoi(name);
      p.ground.markers[name]  = {place, 0.};
      p.bodies.push_back(body("crank" + name,
                              1.,
                              0.1,
                              {{"O", {}}, {"A", {1., 0.}}},
                              {place, 0.},
                              1.));
      p.joints.push_back(
        revolute("foot" + name, "ground." + name, "crank" + name + ".O"));
      p.joints.push_back(
        revolute("head" + name, "crank" + name + ".A", "coupler." + name));
    }
  p.drivers = {motor("crank0", 2 * M_PI, 1.)};
  return p;
}

void
redundancy()
{
  const MechanismParameters p     = three_cranks();
  const DutyCycle           cycle = run(p);
  double                    error = 0., balance = 0.;
  for (unsigned int s = 0; s < cycle.time.size(); ++s)
    {
      const double angle = 1. + 2 * M_PI * cycle.time(s);
      error =
        std::max({error,
                  std::abs(cycle.coordinates(0, s) - 2. - std::cos(angle)),
                  std::abs(cycle.coordinates(1, s) - std::sin(angle)),
                  std::abs(cycle.coordinates(2, s))});
      double force = 2. * g - 2. * 4 * M_PI * M_PI * std::sin(angle);
      for (const char *name : {"head0", "head1", "head2"})
        force -= cycle.joint(name).force_y(s);
      balance = std::max(balance, std::abs(force));
    }
  report_below("Three cranks: place of the coupler", error, 1e-12);
  report_below("  its balance", balance, 1e-9);
  std::cout << "  it " << cycle.settling.message << std::endl;

  MechanismParameters loose = p;
  for (JointParameters &joint : loose.joints)
    if (joint.name == "head2")
      {
        joint.model          = JointModel::massless_link;
        joint.pin_radius     = 10e-3;
        joint.bushing_radius = 11e-3;
      }
  expect_error("with clearance in one joint", [&]() {
    const Mechanism mechanism(count_redundant_constraints(loose));
    CycleSimulation(mechanism, DynamicsParameters());
  });

  MechanismParameters wrong = p;
  wrong.ground.markers["2"] = {4., 0.01};
  expect_error("a foot too high", [&]() { run(wrong); });
  MechanismParameters flat        = four_bar(1., 0.);
  flat.bodies[0].markers["B"]     = {2., 0.};
  flat.bodies[2].initial_angle    = 0.;
  flat.bodies[1].initial_angle    = 0.;
  flat.bodies[1].initial_position = {2., 0.};
  expect_error("a parallelogram at its change point", [&]() { run(flat); });
}

void
equilibrium()
{
  const double        distance = 100., k = 1e9, reach = 1.;
  MechanismParameters p;
  p.gravity        = {0., -g};
  p.ground.markers = {{"O", {distance, 0.}}, {"S", {distance + reach, -1.}}};
  p.bodies         = {body("arm",
                   10.,
                   1.,
                   {{"O", {-0.5, 0.}}, {"S", {reach - 0.5, 0.}}},
                   {distance + 0.5, 0.})};
  p.joints         = {revolute("O", "ground.O", "arm.O")};
  SpringParameters spring;
  spring.name             = "stop";
  spring.first_marker     = "ground.S";
  spring.second_marker    = "arm.S";
  spring.stiffness        = k;
  spring.reference_length = 1.;
  p.springs               = {spring};
  const Mechanism         mechanism(p);
  const EquationsOfMotion equations(mechanism, {});
  const StaticEquilibrium rest =
    solve_static_equilibrium(equations,
                             0.,
                             assemble_configuration(equations, 0.));
  std::cout << "Arm on a stiff spring, far away: "
            << (rest.report.converged ? "found" : rest.report.message)
            << std::endl;
  // The spring carries half the weight.
  report_value("  deflection [nm]", -1e9 * rest.q(2) * reach, 3);
}

int
main()
{
  sizes();
  turns();
  start();
  redundancy();
  equilibrium();
}

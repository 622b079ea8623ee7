// SPDX-License-Identifier: LGPL-2.1-or-later

// Several joints with impacts, whose events meet.
//
// A bar lies on two pins, each in a bore of the ground, and falls from their
// middles: both pins hit at the same instant. By symmetry it stays level, and
// by Newton's restitution the n-th impact leaves with e^n of the first speed;
// the impacts end at t_1 (1 + 2 e/(1 - e)). With its inertia at the ends the
// bar is two masses that do not know of each other; of a uniform bar the end
// that is hit kicks the other one downwards.
//
// Chains of bars that swing from the horizontal in bores of 2 % of their
// lengths: a pin that is at its bore when another one hits must be hit in turn,
// or it passes through the wall. A pin is in its bore at every instant, however
// often they hit, to what the integration leaves; and the energy is never more
// than in the beginning. That ideal joints swing the same way is not asked:
// impacts take energy.
//
// A start in which a pin at its bore moves into it hits at once.

#include "report.h"
#include <tribody/multibody/motion/dynamics_parameters.h>
#include <tribody/multibody/motion/intermittent_motion.h>
#include <tribody/multibody/motion/reference_scales.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>

#include <cmath>
#include <string>
#include <vector>

using namespace Tribody;
using namespace Tribody::Multibody;

constexpr double g = 10.;
// Slower pins are caught: what their impacts would still have taken is missing
// at the end, at most 2 v / (g (1 - e)).
constexpr double capture_speed = 5e-3;

JointParameters
impact_joint(const std::string &name,
             const std::string &pin,
             const std::string &bushing,
             const double       clearance,
             const double       restitution,
             const double       mu)
{
  JointParameters joint;
  joint.name                    = name;
  joint.model                   = JointModel::impact;
  joint.pin_marker              = pin;
  joint.bushing_marker          = bushing;
  joint.pin_radius              = 30e-3;
  joint.bushing_radius          = 30e-3 + clearance;
  joint.restitution_coefficient = restitution;
  joint.friction_coefficient    = mu;
  joint.capture_speed           = capture_speed;
  return joint;
}

BodyParameters
bar(const std::string &name, const double length, const double inertia_share)
{
  BodyParameters body;
  body.name              = name;
  body.mass              = 2.;
  body.moment_of_inertia = inertia_share * body.mass * length * length;
  body.markers           = {{"l", {-length / 2, 0.}}, {"r", {length / 2, 0.}}};
  return body;
}

struct Flight
{
  Flight(const MechanismParameters &p, const double accuracy)
    : mechanism(p)
    , closed_mechanism(with_ideal_joints(p))
    , closed(closed_mechanism, {})
    , equations(mechanism, {})
    , motion(equations,
             make_tolerances(mechanism,
                             compute_reference_scales(mechanism, closed, 1.),
                             with(accuracy)))
  {}

  static DynamicsParameters
  with(const double accuracy)
  {
    DynamicsParameters dynamics;
    dynamics.accuracy = accuracy;
    return dynamics;
  }

  // Largest e/c of all joints.
  double
  largest_eccentricity(const MechanismState &state) const
  {
    double largest = 0.;
    for (const ImpactJoint &joint : mechanism.impact_joints())
      largest = std::max(largest,
                         1. + joint.compute_penetration(
                                joint.link->bodies.gather(state.q)) /
                                joint.link->length);
    return largest;
  }

  double
  energy(const MechanismState &state) const
  {
    const Energy energy = equations.compute_energy(state.q, state.v);
    return energy.kinetic + energy.potential;
  }

  const Mechanism         mechanism;
  const Mechanism         closed_mechanism;
  const EquationsOfMotion closed;
  const EquationsOfMotion equations;
  IntermittentMotion      motion;
};

void
fall_flat(const double e, const double inertia_share)
{
  const double        c = 5e-3;
  MechanismParameters p;
  p.gravity        = {0., -g};
  p.bodies         = {bar("bar", 1., inertia_share)};
  p.ground.markers = {{"l", {-0.5, 0.}}, {"r", {0.5, 0.}}};
  p.joints         = {impact_joint("left", "bar.l", "ground.l", c, e, 0.),
                      impact_joint("right", "bar.r", "ground.r", c, e, 0.)};
  Flight         flight(p, 1e-6);
  MechanismState state;
  state.q = Eigen::Vector3d::Zero();
  state.v = Eigen::Vector3d::Zero();
  flight.motion.start(state);
  const double t_1 = std::sqrt(2 * c / g), end = t_1 * (1 + 2 * e / (1 - e));
  double       tilt = 0., eccentricity = 0.;
  for (unsigned int i = 1; i <= 100; ++i)
    {
      const MechanismState &now =
        flight.motion.advance_to(1.1 * end * i / 100, 100000);
      tilt         = std::max(tilt, std::abs(now.q(2)));
      eccentricity = std::max(eccentricity, flight.largest_eccentricity(now));
    }
  std::cout << "falls flat, e " << e << ", inertia " << inertia_share
            << " m l^2: both follow at the end: "
            << (flight.motion.state().is_following[0] &&
                flight.motion.state().is_following[1])
            << std::endl;
  std::vector<double> speeds(2, g * t_1);
  double              error = 0., last = 0.;
  for (const ContactEvent &event : flight.motion.events())
    if (event.is_onset)
      {
        double &speed = speeds[event.joint];
        error = std::max(error, std::abs(event.penetration_rate / speed - 1));
        speed *= e;
        last = event.time;
      }
  report_below("  speeds e^n, relative error", error, 1e-3);
  report_below("  end of the impacts, relative error",
               std::abs(last / end - 1),
               1e-3 + 2. * capture_speed / (g * (1. - e)) / end);
  report_below("  tilt [urad]", 1e6 * tilt, 1e-3);
  report_below("  largest e/c - 1", eccentricity - 1., 1e-6);
}

void
swing(const unsigned int n_bars, const double e, const double mu)
{
  MechanismParameters p;
  p.gravity          = {0., -g};
  p.ground.markers   = {{"O", {0., 0.}}};
  std::string before = "ground.O";
  double      x      = 0.;
  for (unsigned int i = 0; i < n_bars; ++i)
    {
      const double      length = 0.25 * (1. + 0.3 * i);
      const std::string name   = std::string(1, 'a' + i);
      p.bodies.push_back(bar(name, length, 1. / 12.));
      p.bodies.back().initial_position = {x + length / 2, 0.};
      x += length;
      p.joints.push_back(
        impact_joint("J" + name, before, name + ".l", 5e-3, e, mu));
      before = name + ".r";
    }
  Flight         flight(p, 1e-4);
  MechanismState state;
  state.q = flight.mechanism.initial_coordinates();
  state.v = Eigen::VectorXd::Zero(state.q.size());
  flight.motion.start(state);
  const double start        = flight.energy(state);
  double       eccentricity = 0., energy = start;
  for (unsigned int i = 1; i <= 3000; ++i)
    {
      const MechanismState &now = flight.motion.advance_to(i * 1e-3, 100000);
      eccentricity = std::max(eccentricity, flight.largest_eccentricity(now));
      energy       = std::max(energy, flight.energy(now));
    }
  std::cout << n_bars << " bars, e " << e << ", mu " << mu
            << ": there are impacts: " << (flight.motion.events().size() > 5)
            << std::endl;
  report_below("  largest e/c - 1", eccentricity - 1., 1e-6);
  report_below("  energy gained [J]", energy - start, 1e-3);
}

void
start_outwards()
{
  const double        c = 5e-3;
  MechanismParameters p;
  p.bodies         = {bar("bar", 1., 0.25)};
  p.joints         = {impact_joint("joint", "bar.l", "ground.O", c, 0.5, 0.)};
  p.ground.markers = {{"O", {0., 0.}}};
  Flight         flight(p, 1e-6);
  MechanismState state;
  state.q = Eigen::Vector3d(0.5 + c, 0., 0.);
  state.v = Eigen::Vector3d(1., 0., 0.);
  flight.motion.start(state);
  std::cout << "start outwards: speed after it "
            << flight.motion.advance_to(1e-3, 1000).v(0) << " m/s" << std::endl;
}

int
main()
{
  fall_flat(0.5, 0.25);
  fall_flat(0.5, 1. / 12.);
  fall_flat(0.8, 1. / 12.);
  for (const double e : {0.05, 0.5, 0.9})
    for (const double mu : {0., 0.2})
      swing(2, e, mu);
  for (const double e : {0.1, 0.5, 0.8})
    swing(3, e, 0.1);
  start_outwards();
}

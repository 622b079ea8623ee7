// SPDX-License-Identifier: LGPL-2.1-or-later

// Paths of markers beside those with ideal joints.
//
// By hand: two samples whose deviations are 5 and 0, so that the rms is
// sqrt(12.5); the body of the second has turned by 90 degrees, and the marker
// with it.
//
// A rotor that a driver turns around a pin on the ground, under a constant
// force F: its bushing lies on the pin at the distance c + F/k from the middle,
// by the clearance and the penetration of the contact law, and as the angle is
// prescribed every marker of the rotor is off by as much, at all times.
// Likewise in static equilibrium; there without the driver, too, for a marker
// on the line of the force.
//
// A slider-crank with clearance in the crank pin. The follower's end is at A -
// e instead of A, with e of the pin from the bushing as the duty cycle has it,
// so that the slider is at x = A_x - e_x + sqrt(l^2 - (A_y - e_y)^2): with pins
// that follow, and integrated, after several cycles, where the integrator holds
// the constraints to 1e-8 m. A marker that no joint with clearance carries does
// not deviate, and none does with ideal joints.
//
// What is refused.

#include "report.h"
#include "slider_crank.h"
#include <tribody/base/exceptions.h>

#include <cmath>

using namespace SliderCrank;

namespace
{
  void
  by_hand()
  {
    Eigen::MatrixXd q(3, 2), ideal(3, 2);
    q.col(0) << 3., 4., 0.;
    q.col(1) << 1., 1., M_PI / 2;
    ideal.col(0) << 0., 0., 0.;
    ideal.col(1) << 1., 1., M_PI / 2;
    const WatchedPath path = compare_paths("b.M", {0, {1., 0.}}, q, ideal);
    std::cout << "by hand: " << path.name << ", deviations "
              << path.deviation.transpose() << ", largest in sample "
              << path.largest_sample() << ", second place "
              << path.position.col(1).transpose() << std::endl;
    report_below("  error of the rms",
                 std::abs(path.rms_deviation() - std::sqrt(12.5)),
                 1e-14);
  }

  constexpr double clearance = 50e-6, force = 100., stiffness = 1e7;

  MechanismParameters
  make_rotor()
  {
    MechanismParameters p;
    p.gravity        = {0., 0.};
    p.ground.markers = {{"O", {0.1, 0.2}}};
    BodyParameters rotor;
    rotor.name              = "rotor";
    rotor.mass              = 1.;
    rotor.moment_of_inertia = 0.01;
    rotor.markers = {{"O", {0., 0.}}, {"T", {0.3, 0.}}, {"U", {0., -0.2}}};
    rotor.initial_position = {0.1, 0.2};
    p.bodies               = {rotor};
    JointParameters pivot;
    pivot.name                 = "pivot";
    pivot.pin_marker           = "ground.O";
    pivot.bushing_marker       = "rotor.O";
    pivot.model                = JointModel::clearance;
    pivot.pin_radius           = 10e-3;
    pivot.bushing_radius       = pivot.pin_radius + clearance;
    pivot.contact_force_law    = ContactForceLawChoice::of<SpringDamperLaw>();
    pivot.contact_stiffness    = stiffness;
    pivot.friction_coefficient = 0.;
    p.joints                   = {pivot};
    ForceParameters load;
    load.name   = "load";
    load.marker = "rotor.O";
    load.vector = {0., -force};
    p.forces    = {load};
    DriverParameters motor;
    motor.name  = "motor";
    motor.body  = "rotor";
    motor.speed = 4.;
    p.drivers   = {motor};
    p.watched_markers.resize(2);
    p.watched_markers[0].name = "rotor.O";
    p.watched_markers[1].name = "rotor.T";
    return p;
  }

  double
  error_of_rotor(const DutyCycle &cycle)
  {
    const double known = clearance + force / stiffness;
    double       error = 0.;
    for (const WatchedPath &path : cycle.watched_paths)
      error = std::max({error,
                        (path.deviation.array() / known - 1.).abs().maxCoeff(),
                        std::abs(path.rms_deviation() / known - 1.)});
    return error;
  }

  void
  turning_rotor()
  {
    MechanismParameters p = make_rotor();
    DynamicsParameters  dynamics;
    dynamics.joint_motion = JointMotion::quasi_static;
    report_below("rotor, quasi-static: relative error of the deviation",
                 error_of_rotor(CycleSimulation(Mechanism(p), dynamics).run()),
                 1e-9);
    dynamics.joint_motion = JointMotion::automatic;
    dynamics.analysis     = Analysis::static_equilibrium;
    report_below("  in static equilibrium",
                 error_of_rotor(CycleSimulation(Mechanism(p), dynamics).run()),
                 1e-9);
    // Now the rotor hangs: marker U is below.
    p.drivers                 = {};
    p.forces[0].marker        = "rotor.U";
    p.watched_markers[1]      = p.watched_markers[0];
    p.watched_markers[1].name = "rotor.U";
    dynamics.cycle_duration   = 1.;
    report_below("  with the angle free",
                 error_of_rotor(CycleSimulation(Mechanism(p), dynamics).run()),
                 1e-6);
  }

  // Of the slider's deviation from the closed form [m].
  double
  error_of_slider(const MechanismParameters &p, const DutyCycle &cycle)
  {
    const double          a     = p.bodies[0].markers.at("A")[0] * 2.;
    const double          l     = p.bodies[1].markers.at("B")[0] * 2.;
    const JointDutyCycle &pin   = cycle.joint("crank_pin");
    const WatchedPath    &path  = cycle.watched_paths[0];
    double                error = 0.;
    for (Eigen::Index s = 0; s < cycle.time.size(); ++s)
      {
        const double angle =
          pin.contact_angle_bushing(s) + cycle.coordinates(5, s);
        const double e_x    = pin.eccentricity(s) * std::cos(angle);
        const double e_y    = pin.eccentricity(s) * std::sin(angle);
        const double theta  = p.drivers[0].speed * cycle.time(s);
        const double A_y    = a * std::sin(theta);
        const auto   behind = [l](const double y) {
          return std::sqrt(l * l - y * y);
        };
        const double known = std::abs(-e_x + behind(A_y - e_y) - behind(A_y));
        error = std::max(error, std::abs(path.deviation(s) - known));
      }
    return error;
  }

  void
  watch_slider_crank(MechanismParameters &p)
  {
    p.watched_markers.resize(2);
    p.watched_markers[0].name = "slider.B";
    p.watched_markers[1].name = "crank.A";
  }

  void
  slider_crank()
  {
    MechanismParameters p = validation(2.);
    add_ptfe_clearance(p, 1);
    watch_slider_crank(p);
    DynamicsParameters dynamics;
    dynamics.joint_motion = JointMotion::quasi_static;
    const DutyCycle still = CycleSimulation(Mechanism(p), dynamics).run();
    // FollowingPins finds the eccentricities, of some 0.4 mm, to 1e-8.
    report_below("slider-crank, quasi-static: error [m]",
                 error_of_slider(p, still),
                 1e-11);
    report_below("  deviation of the crank [m]",
                 still.watched_paths[1].largest_deviation(),
                 1e-12);
    dynamics.joint_motion = JointMotion::dynamic;
    const DutyCycle moved = CycleSimulation(Mechanism(p), dynamics).run();
    std::cout << "  integrated, after the first cycle: "
              << (moved.time(0) > 0.5 * moved.period) << std::endl;
    report_below("  error [m]", error_of_slider(p, moved), 1e-8);

    MechanismParameters ideal = validation(2.);
    watch_slider_crank(ideal);
    for (const Analysis analysis :
         {Analysis::kinematic, Analysis::inverse_dynamics})
      {
        dynamics.analysis = analysis;
        report_below("  with ideal joints, " + name_of(analysis) + " [m]",
                     CycleSimulation(Mechanism(ideal), dynamics)
                       .run()
                       .watched_paths[0]
                       .largest_deviation(),
                     1e-12);
      }
  }

  void
  refuse(const std::string &what, const MechanismParameters &p)
  {
    const Mechanism    mechanism(p);
    DynamicsParameters dynamics;
    dynamics.cycle_duration = 1.;
    std::string message     = "nothing";
    try
      {
        const CycleSimulation simulation(mechanism, dynamics);
      }
    catch (const ExcParameter &error)
      {
        message = error.path + ": " + error.problem;
      }
    std::cout << what << ": " << message << std::endl;
  }

  void
  refusals()
  {
    MechanismParameters p = make_rotor();
    p.drivers             = {};
    refuse("free", p);
    p                         = make_rotor();
    p.watched_markers[0].name = "ground.O";
    refuse("ground", p);
    p.watched_markers[0].name = "rotor.Q";
    refuse("no marker", p);
    p         = validation(2.);
    p.drivers = {};
    watch_slider_crank(p);
    refuse("free slider-crank", p);
  }
} // namespace

int
main()
{
  by_hand();
  turning_rotor();
  slider_crank();
  refusals();
}

// SPDX-License-Identifier: LGPL-2.1-or-later

// Motions with known answers.
//
// Free double pendulum: the energy is conserved; its drift over 100 swings
// falls with the tolerance and is below 1e-4 of the energy above the rest
// position at a relative tolerance of 1e-9.
//
// Point pendulum released from the horizontal: at the bottom, after
// K(1/sqrt 2) sqrt(l/g), the joint force is 3 m g.
//
// Free impact of a pin on its bushing: Lankarani and Nikravesh' law leaves with
// e_out, where d (1 + e_out) = ln[(1 + d)/(1 - d e_out)], d = 3 (1 - e_r^2)/4.
// Without loss the largest penetration is (5 m v^2/(4 K))^0.4.

#include "report.h"
#include <tribody/multibody/motion/dynamics_parameters.h>
#include <tribody/multibody/motion/motion_integrator.h>
#include <tribody/multibody/motion/reference_scales.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>

#include <cmath>

using namespace Tribody;
using namespace Tribody::Multibody;

constexpr double g = 9.81;

MechanismParameters
pendulum(const unsigned int n_bars, const double angle)
{
  MechanismParameters p;
  p.gravity = {0., -g};
  for (unsigned int i = 0; i < n_bars; ++i)
    {
      BodyParameters bar;
      bar.name              = "bar" + std::to_string(i);
      bar.mass              = 2.;
      bar.moment_of_inertia = 2. / 12;
      bar.markers           = {{"top", {0., 0.5}}, {"end", {0., -0.5}}};
      bar.initial_angle     = angle;
      bar.initial_position  = {(i + 0.5) * std::sin(angle),
                               -(i + 0.5) * std::cos(angle)};
      p.bodies.push_back(bar);
      JointParameters joint;
      joint.name = "joint" + std::to_string(i);
      joint.pin_marker =
        i == 0 ? std::string("ground.O") : p.bodies[i - 1].name + ".end";
      joint.bushing_marker = bar.name + ".top";
      p.joints.push_back(joint);
    }
  return p;
}

double
double_pendulum_drift(const double accuracy)
{
  const Mechanism         mechanism(pendulum(2, 0.7));
  const EquationsOfMotion equations(mechanism, {});
  DynamicsParameters      dynamics;
  dynamics.accuracy = accuracy;
  MotionIntegrator integrator(equations,
                              make_tolerances(mechanism, {}, dynamics));
  MechanismState   state;
  state.q = assemble_configuration(equations, 0.);
  state.v = Eigen::VectorXd::Zero(mechanism.n_coordinates());
  integrator.start(state);

  // Hanging straight down, the energy is -(0.5 + 1.5) m g l.
  const double rest    = -2. * 2. * g;
  const double initial = equations.compute_energy(state.q, state.v).total();
  // The slow mode swings in about 2.1 s.
  double drift = 0.;
  for (unsigned int i = 1; i <= 400; ++i)
    {
      const MechanismState &now = integrator.advance_to(i * 0.525, 1000000);
      drift                     = std::max(drift,
                       std::abs(equations.compute_energy(now.q, now.v).total() -
                                initial));
    }
  return drift / (initial - rest);
}

void
pendulum_force()
{
  MechanismParameters p         = pendulum(1, M_PI / 2);
  p.bodies[0].moment_of_inertia = 1e-12;
  const Mechanism         mechanism(p);
  const EquationsOfMotion equations(mechanism, {});
  DynamicsParameters      dynamics;
  dynamics.accuracy = 1e-5;
  MotionIntegrator integrator(equations,
                              make_tolerances(mechanism, {}, dynamics));
  MechanismState   state;
  state.q = assemble_configuration(equations, 0.);
  state.v = Eigen::VectorXd::Zero(mechanism.n_coordinates());
  integrator.start(state);
  // Length 0.5 m.
  const MechanismState &bottom =
    integrator.advance_to(1.8540746773013719 * std::sqrt(0.5 / g), 100000);
  Eigen::VectorXd forces(mechanism.n_coordinates());
  equations.assemble_forces(bottom.time, bottom.q, bottom.v, {}, forces);
  const Accelerations result =
    compute_accelerations(equations,
                          bottom.time,
                          ConstraintOffsets(mechanism.n_constraints()),
                          bottom.q,
                          bottom.v,
                          forces);
  report_value("bar force at the bottom over m g",
               result.multipliers.norm() / (2. * g),
               4);
}

MechanismParameters
loose_pin(const std::string &law, const double restitution)
{
  MechanismParameters p;
  BodyParameters      pin;
  pin.name              = "pin";
  pin.mass              = 3.;
  pin.moment_of_inertia = 1.;
  p.bodies              = {pin};
  JointParameters joint;
  joint.name           = "joint";
  joint.model          = JointModel::clearance;
  joint.pin_marker     = "pin.O";
  joint.bushing_marker = "ground.O";
  joint.pin_radius     = 19e-3;
  joint.bushing_radius = 20e-3;
  set_choice(joint.contact_force_law, law);
  joint.restitution_coefficient = restitution;
  p.joints                      = {joint};
  return p;
}

// Speed after one impact over the speed before; the largest force too.
double
impact(const std::string &law, const double restitution, double &peak_force)
{
  const Mechanism         mechanism(loose_pin(law, restitution));
  const Mechanism         closed(with_ideal_joints(mechanism.parameters()));
  const EquationsOfMotion equations(mechanism, nominal_clearances(mechanism));
  DynamicsParameters      dynamics;
  dynamics.accuracy      = 1e-3;
  dynamics.maximum_order = 5;
  MotionIntegrator integrator(
    equations,
    make_tolerances(mechanism,
                    compute_reference_scales(mechanism,
                                             EquationsOfMotion(closed, {})),
                    dynamics));
  MechanismState state;
  state.q = Eigen::Vector3d::Zero();
  state.v = Eigen::Vector3d(1.2, 0.9, 0.);
  integrator.start(state);
  const Eigen::VectorXd v = integrator.advance_to(2e-3, 100000).v;
  peak_force              = integrator.peak_forces()[0];
  std::cout << "  " << law << ": " << integrator.events().size() << " events"
            << std::endl;
  return v.head<2>().norm() / state.v.norm();
}

int
main()
{
  const double coarse = double_pendulum_drift(1e-2);
  const double medium = double_pendulum_drift(1e-4);
  const double fine   = double_pendulum_drift(1e-5);
  report_below("double pendulum, drift at 1e-9", fine, 1e-4);
  report_below("  that at 1e-8 over that at 1e-6", medium / coarse, 0.2);
  report_below("  that at 1e-9 over that at 1e-8", fine / medium, 0.5);
  pendulum_force();

  double force;
  for (const double e_r : {0.5, 0.7, 0.8, 0.9})
    {
      const double e_out = impact("Lankarani-Nikravesh", e_r, force);
      const double d     = 0.75 * (1 - e_r * e_r);
      report_value("free impact: leaves with", e_out, 3);
      report_below("  error in the closed form",
                   std::abs(d * (1 + e_out) -
                            std::log((1 + d) / (1 - d * e_out))),
                   1e-4);
    }
  const double e_out = impact("Hertz", 1., force);
  report_value("elastic impact: leaves with", e_out, 4);
  const Mechanism mechanism(loose_pin("Hertz", 1.));
  const double    stiffness =
    std::get<HertzLaw>(mechanism.clearance_joints()[0].contact_law).stiffness;
  const double v = 1.5, m = 3.;
  report_below("  relative error of the largest penetration",
               std::abs(std::pow(force / stiffness, 2. / 3) /
                          std::pow(5 * m * v * v / (4 * stiffness), 0.4) -
                        1),
               1e-3);
}

// SPDX-License-Identifier: LGPL-2.1-or-later

// Where the energy of a motion goes, and reactions with their moments.
//
// Known in closed form:
// - A pin that hits its bushing once under Lankarani and Nikravesh' law loses
//   m v^2 (1 - e_out^2)/2, where d (1 + e_out) = ln[(1 + d)/(1 - d e_out)],
//   d = 3 (1 - e_r^2)/4; it leaves with e_out v. Without loss, nothing stays.
// - A damped oscillator, x = x_0 exp(-z w t) (cos w_d t + z w/w_d sin w_d t).
// - A bar that a motor turns in the vertical plane takes m g s from it for a
//   quarter turn up from the horizontal, s from pivot to centre of mass, and
//   the motor's moment there is m g s.
// - A guide holds a body whose centre of mass is b beside its marker with the
//   moment m g b.
//
// In mechanisms with clearance the work of the motor must be what the kinetic
// energy gains and contacts and friction take, to 1e-4 of the largest of these
// in a settled cycle and since the start, impacts included. The friction loss
// is compared with the sum of friction times sliding over the samples: the
// midpoint rule, good to 1e-3.

#include "report.h"
#include "slider_crank.h"
#include <tribody/multibody/cycle/contact_interval.h>
#include <tribody/multibody/motion/energy_account.h>
#include <tribody/multibody/motion/motion_integrator.h>
#include <tribody/multibody/motion/reference_scales.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/reactions.h>

#include <cmath>

using namespace SliderCrank;

constexpr double g = 9.81;

JointParameters
joint_between(const std::string &name,
              const std::string &pin,
              const std::string &bushing)
{
  JointParameters joint;
  joint.name           = name;
  joint.pin_marker     = pin;
  joint.bushing_marker = bushing;
  return joint;
}

BodyParameters
bar(const std::string      &name,
    const double            length,
    const dealii::Point<2> &begin,
    const double            angle)
{
  BodyParameters body;
  body.name              = name;
  body.mass              = 20. * length;
  body.moment_of_inertia = body.mass * length * length / 12;
  body.markers           = {{"A", {-length / 2, 0.}}, {"B", {length / 2, 0.}}};
  body.initial_angle     = angle;
  body.initial_position  = {begin[0] + length / 2 * std::cos(angle),
                            begin[1] + length / 2 * std::sin(angle)};
  return body;
}

void
free_impact(const std::string &law, const double e_r)
{
  MechanismParameters p;
  BodyParameters      body;
  body.name              = "pin";
  body.mass              = 3.;
  body.moment_of_inertia = 1.;
  p.bodies               = {body};
  p.joints               = {joint_between("joint", "pin.O", "ground.O")};
  add_steel_clearance(p, 0, 21e-3);
  set_choice(p.joints[0].contact_force_law, law);
  p.joints[0].restitution_coefficient = e_r;
  p.joints[0].friction_law            = FrictionLawChoice::of<NoFriction>();
  const Mechanism         mechanism(p);
  const Mechanism         closed(with_ideal_joints(p));
  const EquationsOfMotion equations(mechanism, nominal_clearances(mechanism));
  DynamicsParameters      dynamics;
  dynamics.accuracy      = 1e-4;
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
  EnergyAccount account(equations);
  integrator.set_energy_account(&account);
  const EnergyRecord start = account.now();
  integrator.advance_to(2e-3, 100000);
  const EnergyRecord change = account.now().since(start);

  const std::vector<ContactInterval> contacts =
    list_contacts(integrator.events(), 0, {0., 2e-3, 0., 1e-3, false});
  std::cout << law << ": " << contacts.size() << " contact, an impact "
            << (contacts[0].state == ContactState::impact) << ", seen whole "
            << (contacts[0].has_onset && contacts[0].has_loss) << std::endl;
  report_value("  approach speed [mm/s]", 1e3 * contacts[0].approach_speed, 1);
  report_below("  difference of its peak force",
               std::abs(contacts[0].peak_force / integrator.peak_forces()[0] -
                        1),
               1e-12);
  const double e_out = contacts[0].separation_speed / 1.5;
  const double d     = 0.75 * (1 - e_r * e_r);
  if (e_r < 1)
    report_below("  error of the restitution in the closed form",
                 std::abs(d * (1 + e_out) -
                          std::log((1 + d) / (1 - d * e_out))),
                 1e-4);
  const double before = 3. * 1.5 * 1.5 / 2;
  report_below("  error of the loss relative to the energy",
               std::abs(change.normal_loss[0] - before * (1 - e_out * e_out)) /
                 before,
               1e-4);
  report_below("  energy left in the contact",
               std::abs(change.contact_energy[0]) / before,
               1e-4);
  report_below("  error of the balance", account.relative_error(), 1e-4);
}

void
oscillator()
{
  MechanismParameters p;
  p.ground.markers = {{"O", {0., 0.}}, {"W", {-1., 0.}}};
  BodyParameters body;
  body.name             = "slider";
  body.mass             = 2.;
  body.markers          = {{"O", {0., 0.}}, {"B", {-0.3, 0.}}};
  body.initial_position = {0.1, 0.};
  p.gravity             = {0., -g};
  p.bodies              = {body};
  JointParameters guide;
  guide.name          = "guide";
  guide.type          = JointType::translational;
  guide.first_marker  = "ground.O";
  guide.second_marker = "slider.B";
  p.joints            = {guide};
  SpringParameters spring;
  spring.name             = "spring";
  spring.first_marker     = "ground.W";
  spring.second_marker    = "slider.O";
  spring.stiffness        = 200.;
  spring.damping          = 4.;
  spring.reference_length = 1.;
  p.springs               = {spring};
  const Mechanism         mechanism(p);
  const EquationsOfMotion equations(mechanism, {});
  DynamicsParameters      dynamics;
  dynamics.accuracy = 1e-5;
  MotionIntegrator integrator(equations,
                              make_tolerances(mechanism, {}, dynamics));
  MechanismState   state;
  state.q = assemble_configuration(equations, 0.);
  state.v = Eigen::VectorXd::Zero(3);
  integrator.start(state);
  EnergyAccount account(equations);
  integrator.set_energy_account(&account);
  const MechanismState end = integrator.advance_to(0.7, 100000);

  const double w = 10., z = 0.1, t = 0.7, w_d = w * std::sqrt(1 - z * z);
  const double x = 0.1 * std::exp(-z * w * t) *
                   (std::cos(w_d * t) + z * w / w_d * std::sin(w_d * t));
  const double v =
    -0.1 * std::exp(-z * w * t) * w * w / w_d * std::sin(w_d * t);
  const double before = 200. * 0.1 * 0.1 / 2;
  const double loss   = before - 200. * x * x / 2 - 2. * v * v / 2;
  std::cout << "damped oscillator" << std::endl;
  report_below("  error of the damper's loss relative to the energy",
               std::abs(account.now().damper_loss - loss) / before,
               1e-4);
  report_below("  error of the balance", account.relative_error(), 1e-4);

  const Reactions reactions = compute_reactions(
    equations, end, compute_accelerations(equations, end), {});
  report_below("  error of the guide's moment",
               std::abs(reactions.joints(2, 0) / (2. * g * 0.3) - 1),
               1e-9);
  report_below("  error of the guide's force",
               std::abs(reactions.joints(1, 0) / (2. * g) - 1),
               1e-9);
}

void
driven_bar()
{
  MechanismParameters p;
  p.gravity = {0., -g};
  p.bodies  = {bar("bar", 0.8, {0., 0.}, 0.)};
  p.joints  = {joint_between("pivot", "ground.O", "bar.A")};
  DriverParameters motor;
  motor.name  = "motor";
  motor.body  = "bar";
  motor.speed = 2.;
  p.drivers   = {motor};
  DynamicsParameters dynamics;
  dynamics.energy_balance = EnergyBalance::always;
  const Mechanism mechanism(p);
  const DutyCycle cycle = CycleSimulation(mechanism, dynamics).run();
  const double    mgs   = 16. * g * 0.4;
  std::cout << "driven bar" << std::endl;
  report_below("  error of the motor's moment",
               std::abs(cycle.drivers[0].moment[0] / mgs - 1),
               1e-9);
  report_below("  error of its power",
               std::abs(cycle.drivers[0].power[0] / (2 * mgs) - 1),
               1e-9);
  // From the sample at 0 to that at 90 deg. Simpson's rule.
  report_below("  error of its work",
               std::abs((cycle.energy.samples[18].driver_work -
                         cycle.energy.samples[0].driver_work) /
                          mgs -
                        1),
               1e-6);
  // Towards the pivot, at the top.
  report_below("  error of the acceleration",
               std::abs(cycle.accelerations(1, 18) / (-0.4 * 4.) - 1),
               1e-9);
  report_below("  error of the balance", cycle.energy.relative_error, 1e-6);
}

void
balance(const std::string         &title,
        const MechanismParameters &p,
        const double               accuracy,
        const MotionStart          start = MotionStart::slow_motion,
        const unsigned int         order = 0)
{
  DynamicsParameters dynamics;
  dynamics.accuracy                = accuracy;
  dynamics.start                   = start;
  dynamics.maximum_order           = order;
  dynamics.maximum_settling_cycles = 4;
  dynamics.averaged_cycles         = 5;
  dynamics.energy_balance          = EnergyBalance::always;
  const Mechanism mechanism(p);
  const DutyCycle cycle = CycleSimulation(mechanism, dynamics).run();
  std::cout << title << std::endl;
  report_below("  error of the balance, cycle",
               cycle.energy.relative_error,
               1e-4);
  report_below("  since the start",
               cycle.energy.relative_error_since_start,
               1e-4);
  Eigen::Index n_clearance_joints = 0;
  for (const JointDutyCycle &joint : cycle.joints)
    if (joint.has_gap)
      {
        const double loss =
          cycle.energy.cycle.friction_loss[n_clearance_joints++];
        const double sum =
          joint.friction_force.cwiseAbs().dot(joint.sliding_increment);
        // The sliding is that of one cycle, the loss that of all recorded.
        if (joint.n_losses == 0)
          report_below("  " + joint.name + ": sum of friction times sliding",
                       std::abs(sum * cycle.settling.n_averaged_cycles / loss -
                                1),
                       5e-2);
        report_below("  " + joint.name + ": shares of the states minus one",
                     std::abs(joint.share_of(ContactState::free) +
                              joint.share_of(ContactState::impact) +
                              joint.share_of(ContactState::following) - 1),
                     1e-12);
      }
}

int
main()
{
  free_impact("Lankarani-Nikravesh", 0.8);
  free_impact("Hertz", 1.);
  oscillator();
  driven_bar();

  MechanismParameters p = steel(1);
  add_steel_clearance(p, 1, 20.0005e-3);
  balance("steel, 0.5 um", p, 1e-5);
  p = steel(1);
  add_steel_clearance(p, 1, 25e-3);
  balance(
    "steel, 5 mm, impacts at the start", p, 1e-5, MotionStart::centred, 5);
  p = steel(1);
  add_steel_clearance(p, 2, 25e-3);
  balance("steel, 5 mm in the wrist pin, impacts in each cycle", p, 1e-4);
  p = steel(1);
  add_steel_clearance(p, 1, 20.0005e-3);
  add_steel_clearance(p, 2, 20.0005e-3);
  balance("steel, 0.5 um in two joints", p, 1e-4);
  p = validation(2);
  add_ptfe_clearance(p, 1);
  balance("validation", p, 3e-5);
  add_ptfe_clearance(p, 2);
  balance("validation, two joints", p, 1e-4);

  // A crank-rocker with steel joints.
  p                = MechanismParameters();
  p.gravity        = {0., -g};
  p.ground.markers = {{"O", {0., 0.}}, {"C", {1., 0.}}};
  p.bodies         = {bar("crank", 0.3, {0., 0.}, 0.),
                      bar("coupler", 0.9, {0.3, 0.}, 0.862),
                      bar("rocker", 0.7, {1., 0.}, 1.787)};
  p.joints         = {joint_between("pivot", "ground.O", "crank.A"),
                      joint_between("crank_pin", "crank.B", "coupler.A"),
                      joint_between("coupler_pin", "coupler.B", "rocker.B"),
                      joint_between("rocker_pin", "ground.C", "rocker.A")};
  DriverParameters motor;
  motor.name  = "motor";
  motor.body  = "crank";
  motor.speed = M_PI;
  p.drivers   = {motor};
  for (const unsigned int j : {1, 2, 3})
    add_steel_clearance(p, j, 20.05e-3);
  balance("four-bar, 50 um in three joints", p, 1e-4);
}

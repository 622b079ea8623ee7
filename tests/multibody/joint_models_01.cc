// SPDX-License-Identifier: LGPL-2.1-or-later

// Every joint model in the crank pin of the steel slider-crank of Mukras et al.
// (2010), and impacts with known answers.
//
// Clearance 0.5 um: no law matters but that of friction. With friction the
// total force is known at 72 crank angles from an independent integration
// (reference/clearance_0.5um_literal.csv, Radau, rtol 1e-9); the sliding is 27
// mm/s and more, so that every law of friction has the ratio 0.15. It moves the
// force by 1.1e-3 of its peak from that of the ideal joint (a moment of 0.15 R
// F_N at each body); the normal force alone would be smaller by 1/sqrt(1 +
// 0.15^2), or 1.1e-2. Without friction, as have the massless link and the
// impact joint while the pin follows, the force is that of the ideal joint, but
// for the clearance, 5e-7 of the links. What is allowed, 3e-4 of the peak, is
// the accuracy that the integration is asked for; it tells friction from none.
//
// Clearance 5 mm, Lankarani-Nikravesh, from a centred start, second revolution:
// three independent codes agree on a peak of 975.33 N and a mean of 505.96 N of
// the total force; that is what five digits can show, 2e-4 with the peak
// between samples.
//
// A pin falls from the centre of its bore and bounces: with e the coefficient
// of restitution, the speed after impact n is e^n of that of the first, the
// impacts end at t_1 (1 + 2 e/(1 - e)), and from then on the pin follows, under
// its weight; the last flights are 1 nm high and have to be right to 0.1 %. A
// free disc that hits the bore at an angle, with friction: the
// change of its angular momentum about the point of contact is zero, and it
// slides or sticks as Coulomb's law says.

#include "report.h"
#include "slider_crank.h"
#include <tribody/multibody/motion/intermittent_motion.h>
#include <tribody/multibody/motion/reference_scales.h>
#include <tribody/multibody/system/kinematics.h>

#include <cmath>

using namespace SliderCrank;

MechanismParameters
steel_with(const JointModel   model,
           const double       clearance,
           const std::string &contact  = "Lankarani-Nikravesh",
           const std::string &friction = "Coulomb regularised")
{
  MechanismParameters p = steel(1);
  add_steel_clearance(p, 1, 20e-3 + clearance);
  JointParameters &joint = p.joints[1];
  joint.model            = model;
  set_choice(joint.contact_force_law, contact);
  set_choice(joint.friction_law, friction);
  // Near the slope of Hertz' law at 1 um; some losses.
  joint.contact_stiffness = 4e7;
  joint.contact_damping   = 4e3;
  // A layer as stiff as the massive parts.
  joint.foundation_length    = 20e-3;
  joint.foundation_thickness = 20e-3;
  return p;
}

/// Largest difference of the total force from @p known [N] at 72 crank angles,
/// over the largest of these.
void
compare(const std::string         &what,
        const MechanismParameters &p,
        const Eigen::VectorXd     &known)
{
  const Mechanism       mechanism(p);
  const DutyCycle       cycle = CycleSimulation(mechanism, {}).run();
  const JointDutyCycle &joint = cycle.joint("crank_pin");
  const double          error =
    (joint.force() - known).lpNorm<Eigen::Infinity>() / known.maxCoeff();
  std::cout << "0.5 um, " << what << ": settled " << cycle.settling.converged
            << ", ";
  report_below("difference of the force over peak", error, 3e-4);
}

/// Total forces of the joint with friction.
Eigen::VectorXd
read_forces_with_friction()
{
  const auto      table = read_table(std::string(SOURCE_DIR) +
                                "/reference/clearance_0.5um_literal.csv");
  Eigen::VectorXd forces(table.size());
  for (std::size_t i = 0; i < table.size(); ++i)
    forces[i] = table[i].at(3);
  return forces;
}

JointDutyCycle
five_millimetres()
{
  DynamicsParameters dynamics;
  dynamics.start                   = MotionStart::centred;
  dynamics.accuracy                = 1e-5;
  dynamics.samples_per_cycle       = 3600;
  dynamics.maximum_settling_cycles = 1;
  dynamics.averaged_cycles         = 1;
  const Mechanism       mechanism(steel_with(JointModel::clearance, 5e-3));
  const DutyCycle       cycle = CycleSimulation(mechanism, dynamics).run();
  const JointDutyCycle &joint = cycle.joint("crank_pin");
  std::cout << "5 mm, clearance: " << cycle.settling.n_cycles
            << " revolutions, following all the time: "
            << (joint.share_of(ContactState::following) == 1.) << std::endl;
  return joint;
}

MechanismParameters
loose_disc(const double clearance, const double restitution, const double mu)
{
  MechanismParameters p;
  BodyParameters      pin;
  pin.name              = "pin";
  pin.mass              = 2.;
  pin.moment_of_inertia = 1e-3;
  p.bodies              = {pin};
  JointParameters joint;
  joint.name                    = "joint";
  joint.model                   = JointModel::impact;
  joint.pin_marker              = "pin.O";
  joint.bushing_marker          = "ground.O";
  joint.pin_radius              = 30e-3;
  joint.bushing_radius          = 30e-3 + clearance;
  joint.restitution_coefficient = restitution;
  joint.friction_coefficient    = mu;
  joint.capture_speed           = 1e-4;
  p.joints                      = {joint};
  return p;
}

struct Flight
{
  Flight(const MechanismParameters &p)
    : mechanism(p)
    , closed_mechanism(with_ideal_joints(p))
    , closed(closed_mechanism, {})
    , equations(mechanism, {})
    , motion(equations,
             make_tolerances(mechanism,
                             compute_reference_scales(mechanism, closed),
                             accurate()))
  {}

  static DynamicsParameters
  accurate()
  {
    DynamicsParameters dynamics;
    dynamics.accuracy = 1e-6;
    return dynamics;
  }

  const Mechanism         mechanism;
  const Mechanism         closed_mechanism;
  const EquationsOfMotion closed;
  const EquationsOfMotion equations;
  IntermittentMotion      motion;
};

void
bounce()
{
  const double        g = 10., c = 5e-3, e = 0.5;
  MechanismParameters p = loose_disc(c, e, 0.);
  p.gravity             = {0., -g};
  Flight         flight(p);
  MechanismState state;
  state.q = Eigen::Vector3d::Zero();
  state.v = Eigen::Vector3d::Zero();
  flight.motion.start(state);
  const double t_1 = std::sqrt(2 * c / g), end = t_1 * (1 + 2 * e / (1 - e));
  flight.motion.advance_to(1.1 * end, 100000);

  double speed = g * t_1, error = 0., leaving = 0., momentum = 0., last = 0.;
  unsigned int n_onsets = 0, n_losses = 0;
  for (const ContactEvent &event : flight.motion.events())
    if (event.is_onset)
      {
        error = std::max(error, std::abs(event.penetration_rate / speed - 1));
        const bool   is_last = event.penetration_rate < 1e-4;
        const double change  = (is_last ? 1. : 1 + e) * 2. * speed;
        momentum = std::max(momentum, std::abs(event.impulse / change - 1));
        last     = event.time;
        speed *= e;
        ++n_onsets;
      }
    else
      {
        leaving =
          std::max(leaving, std::abs(event.penetration_rate / speed + 1));
        ++n_losses;
      }
  // 0.316 m/s halved until it is below 0.1 mm/s.
  std::cout << "bouncing pin: " << n_onsets << " impacts, " << n_losses
            << " flights after them, following at the end: "
            << flight.motion.state().is_following[0] << std::endl;
  report_below("  speeds e^n, relative error", error, 1e-3);
  report_below("  separation speeds, relative error", leaving, 1e-3);
  report_below("  impulses are changes of momentum, relative error",
               momentum,
               1e-3);
  report_below("  end of the impacts, relative error",
               std::abs(last / end - 1),
               1e-3);
  const MechanismState &rest = flight.motion.advance_to(2 * end, 100000);
  report_below("  rest at the bottom [um]",
               1e6 * (rest.q.head<2>() - Eigen::Vector2d(0., -c)).norm(),
               1e-2);
}

void
oblique(const double mu)
{
  const double   c = 5e-3, e = 0.7, m = 2., inertia = 1e-3, r = 30e-3;
  Flight         flight(loose_disc(c, e, mu));
  MechanismState state;
  state.q = Eigen::Vector3d::Zero();
  state.v = Eigen::Vector3d(1., 0., 20.);
  flight.motion.start(state);
  const Eigen::VectorXd v = flight.motion.advance_to(c * 1.5, 100000).v;
  // It hits at (c, 0); there the surface moves along y by v_y + r omega.
  const double sliding = v(1) + r * v(2);
  const double tangent = m * v(1), normal = m * (1 + e);
  // Sticks if the impulse that stops the sliding is in Coulomb's cone.
  const double sticking = r * 20. / (1 / m + r * r / inertia);
  const bool   sticks   = sticking <= mu * normal;
  std::cout << "oblique impact, mu " << mu << ": "
            << (sticks ? "sticks" : "slides") << std::endl;
  report_below("  normal speed over e v, error", std::abs(-v(0) / e - 1), 1e-9);
  report_below("  angular momentum about the contact, error",
               std::abs(inertia * (v(2) - 20.) - r * tangent) / (inertia * 20.),
               1e-9);
  if (sticks)
    report_below("  sliding afterwards over before",
                 std::abs(sliding / (20. * r)),
                 1e-9);
  else
    report_below("  tangential over normal impulse is mu, error",
                 std::abs(std::abs(tangent) / normal - mu),
                 1e-9);
}

int
main()
{
  const Mechanism       mechanism(steel(1));
  const DutyCycle       cycle         = CycleSimulation(mechanism, {}).run();
  const Eigen::VectorXd ideal         = cycle.joint("crank_pin").force();
  const Eigen::VectorXd with_friction = read_forces_with_friction();
  for (const std::string law : {"Hertz",
                                "Lankarani-Nikravesh",
                                "Hunt-Crossley",
                                "Flores",
                                "spring-damper",
                                "elastic foundation"})
    compare(law, steel_with(JointModel::clearance, 0.5e-6, law), with_friction);
  for (const std::string law : {"Ambrosio", "Stribeck", "LuGre"})
    compare(
      "friction " + law,
      steel_with(JointModel::clearance, 0.5e-6, "Lankarani-Nikravesh", law),
      with_friction);
  compare(
    "no friction",
    steel_with(JointModel::clearance, 0.5e-6, "Lankarani-Nikravesh", "none"),
    ideal);
  compare("massless link",
          steel_with(JointModel::massless_link, 0.5e-6),
          ideal);
  compare("impact", steel_with(JointModel::impact, 0.5e-6), ideal);

  const JointDutyCycle contact = five_millimetres();
  report_below("  peak of 975.33 N, relative error",
               std::abs(contact.peak_force() / 975.33 - 1),
               2e-4);
  report_below("  mean of 505.96 N, relative error",
               std::abs(contact.mean_force() / 505.96 - 1),
               2e-4);
  bounce();
  oblique(0.05);
  oblique(0.9);
}

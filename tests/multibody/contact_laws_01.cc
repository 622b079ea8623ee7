// SPDX-License-Identifier: LGPL-2.1-or-later

// Laws of contact and friction, each against something known.
//
// Free impact of a pin on its bushing, integrated as the program does. Whatever
// the elastic force, a hysteresis factor 1 + d delta'/delta'_minus leaves with
// e_out, where d (1 + e_out) = ln[(1 + d)/(1 - d e_out)]: d = 3 (1 - e_r^2)/4
// of Lankarani and Nikravesh (and of the elastic foundation), 3 (1 - e_r)/2 of
// Hunt and Crossley, 8 (1 - e_r)/(5 e_r) of Flores. The spring-damper that
// cannot pull leaves with exp(-2 zeta acos(zeta)/sqrt(1 - zeta^2)). The
// integration at accuracy 1e-5 is good to about 1e-5. Without loss, the work of
// the law up to the largest penetration is the kinetic energy before.
//
// Elastic foundation: the resultant is the integral of its pressure over the
// arc (composite Simpson rule with 2000 intervals), the slope that of
// differences; half-angle and force in closed form for c = 0.
//
// Derivatives of all laws against central differences (1e-6 relative), and
// penetrations found for a force give that force.
//
// Friction: values of the piecewise and of the Stribeck curves at points where
// they are known; LuGre: integrated at a constant speed, it ends on the steady
// curve; held below break-away, it is a spring of stiffness sigma_0.

#include "report.h"
#include <tribody/multibody/motion/dynamics_parameters.h>
#include <tribody/multibody/motion/motion_integrator.h>
#include <tribody/multibody/motion/reference_scales.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/mechanism.h>

#include <cmath>
#include <functional>

using namespace Tribody;
using namespace Tribody::Multibody;

constexpr double mass = 3., speed = 1.5;

MechanismParameters
loose_pin(const JointParameters &law)
{
  MechanismParameters p;
  BodyParameters      pin;
  pin.name              = "pin";
  pin.mass              = mass;
  pin.moment_of_inertia = 1.;
  p.bodies              = {pin};
  JointParameters joint = law;
  joint.name            = "joint";
  joint.model           = JointModel::clearance;
  joint.pin_marker      = "pin.O";
  joint.bushing_marker  = "ground.O";
  joint.pin_radius      = 19e-3;
  joint.bushing_radius  = 20e-3;
  p.joints              = {joint};
  return p;
}

struct Impact
{
  double          restitution;
  double          peak_force;
  ContactForceLaw law;
};

Impact
run_impact(const JointParameters &law)
{
  const Mechanism         mechanism(loose_pin(law));
  const Mechanism         closed(with_ideal_joints(mechanism.parameters()));
  const EquationsOfMotion equations(mechanism, nominal_clearances(mechanism));
  DynamicsParameters      dynamics;
  dynamics.accuracy      = 1e-5;
  dynamics.maximum_order = 5;
  MotionIntegrator integrator(
    equations,
    make_tolerances(mechanism,
                    compute_reference_scales(mechanism,
                                             EquationsOfMotion(closed, {})),
                    dynamics));
  MechanismState state;
  state.q = Eigen::Vector3d::Zero();
  state.v = speed * Eigen::Vector3d(0.8, 0.6, 0.);
  integrator.start(state);
  unsigned int i = 1;
  while (integrator.events().size() < 2 && i < 200)
    integrator.advance_to(1e-4 * i++, 1000000);
  const Eigen::VectorXd v = integrator.advance_to(1e-4 * i, 1000000).v;
  return {v.head<2>().norm() / speed,
          integrator.peak_forces()[0],
          mechanism.clearance_joints()[0].contact_law};
}

JointParameters
law_named(const std::string &name, const double restitution)
{
  JointParameters law;
  set_choice(law.contact_force_law, name);
  law.restitution_coefficient = restitution;
  law.contact_stiffness       = 1e8;
  return law;
}

// e_out of the hysteresis d, by bisection.
double
leaving_speed(const double d)
{
  double low = 0., high = std::min(1., 1 / d);
  for (unsigned int i = 0; i < 100; ++i)
    {
      const double e = (low + high) / 2;
      (d * (1 + e) > std::log((1 + d) / (1 - d * e)) ? low : high) = e;
    }
  return low;
}

void
check_impact(const std::string &name, const double e_r, const double e_out)
{
  const Impact impact = run_impact(law_named(name, e_r));
  std::cout << name << ", e_r " << e_r << ": leaves with " << e_out
            << "; relative ";
  report_below("error", std::abs(impact.restitution / e_out - 1), 1e-4);
}

void
check_spring_damper(const double zeta)
{
  JointParameters law = law_named("spring-damper", 1.);
  law.contact_damping = 2 * zeta * std::sqrt(law.contact_stiffness * mass);
  const double e_out =
    std::exp(-2 * zeta * std::acos(zeta) / std::sqrt(1 - zeta * zeta));
  std::cout << "spring-damper, zeta " << zeta << ": leaves with " << e_out
            << "; relative ";
  report_below("error",
               std::abs(run_impact(law).restitution / e_out - 1),
               1e-4);
}

double
integral(const std::function<double(double)> &f, const double a, const double b)
{
  constexpr int n   = 2000;
  double        sum = f(a) + f(b);
  for (int i = 1; i < n; ++i)
    sum += f(a + (b - a) * i / n) * (i % 2 == 0 ? 2 : 4);
  return sum * (b - a) / (3 * n);
}

// The largest force belongs to the penetration at which the law has taken all
// of the kinetic energy.
void
check_elastic(const std::string &name)
{
  const Impact impact = run_impact(law_named(name, 1.));
  const double depth =
    compute_penetration(impact.law, impact.peak_force, 0., 1.);
  const double work = integral(
    [&](const double x) {
      return compute_normal_force(impact.law, {x, 0., 1.}).value;
    },
    0.,
    depth);
  std::cout << name << ", no loss: ";
  report_below("relative error of the speed",
               std::abs(impact.restitution - 1),
               1e-4);
  report_below("  of the work up to the largest penetration",
               std::abs(work / (mass * speed * speed / 2) - 1),
               1e-3);
}

void
check_derivatives(const std::string &name, const ContactForceLaw &law)
{
  const ContactKinematics contact = {12e-6, 0.3, 0.8};
  const NormalForce       f       = compute_normal_force(law, contact);
  const auto              force   = [&](const double dx, const double dv) {
    return compute_normal_force(law,
                                {contact.penetration + dx,
                                 contact.penetration_rate + dv,
                                 contact.approach_speed})
      .value;
  };
  const double dx = 1e-9, dv = 1e-4;
  std::cout << name << ": ";
  report_below("derivative by penetration",
               std::abs((force(dx, 0) - force(-dx, 0)) / (2 * dx) -
                        f.d_penetration) /
                 f.d_penetration,
               1e-6);
  report_below("  by its rate over force",
               std::abs((force(0, dv) - force(0, -dv)) / (2 * dv) -
                        f.d_penetration_rate) /
                 f.value,
               1e-6);
  double error = 0.;
  for (const double load : {1e3, 1e4, 1e5})
    error =
      std::max(error,
               std::abs(
                 compute_normal_force(
                   law,
                   {compute_penetration(law, load, -3e-6, 0.01), -3e-6, 0.01})
                     .value /
                   load -
                 1));
  report_below("  inverse", error, 1e-10);
}

void
check_elastic_foundation()
{
  const ElasticFoundationLaw law = {0.1e-3, 20e-3, 30e-3, 4e13, 0.8};
  for (const double penetration : {1e-9, 1e-6, 1e-4, 1e-2})
    {
      const ContactKinematics contact = {penetration, 0.02, 0.1};
      const double            t_0     = law.half_angle(penetration);
      const double            force   = integral(
                             [&](const double t) {
                               return law.pressure(t, contact) * std::cos(t);
                             },
                             -t_0,
                             t_0) *
                           law.length * law.bore_radius;
      std::cout << "elastic foundation, " << 1e6 * penetration << " um: ";
      report_value("half-angle [deg]", t_0 * 180 / M_PI, 3);
      report_below("  resultant of the pressure, relative error",
                   std::abs(force / law.normal_force(contact).value - 1),
                   1e-6);
    }
  const ElasticFoundationLaw fitted = {0., 20e-3, 30e-3, 4e13, 1.};
  const NormalForce          f      = fitted.normal_force({1e-6, 0., 1.});
  report_below("no clearance: force over pi/2 k L R delta, error",
               std::abs(f.value / (M_PI / 2 * 4e13 * 30e-3 * 20e-3 * 1e-6) - 1),
               1e-12);
}

void
check_friction_values()
{
  const AmbrosioFriction ambrosio = {0.2, 1e-3, 3e-3};
  std::cout << "Ambrosio:";
  for (const double v : {-5e-3, -2e-3, -1e-3, 0., 0.5e-3, 1.5e-3, 3e-3, 1.})
    std::cout << " " << ambrosio.ratio(v).value;
  std::cout << std::endl;

  const StribeckCurve    curve    = {0.1, 0.3, 0.01};
  const StribeckFriction stribeck = {curve, 1e-5, 0.5};
  std::cout << "Stribeck:";
  // At rest; static, where the tanh has saturated; mu_k + (mu_s - mu_k)/e at
  // v_s; kinetic and viscous.
  for (const double v : {0., 1e-4, 1e-2, -1e-2, 1.})
    std::cout << " " << stribeck.ratio(v).value;
  std::cout << std::endl
            << "  expected: 0 " << 0.1 + 0.2 * std::exp(-1e-4) + 0.5e-4 << " "
            << 0.1 + 0.2 / M_E + 0.005 << " " << -0.1 - 0.2 / M_E - 0.005
            << " 0.6" << std::endl;

  double           error = 0.;
  constexpr double dv    = 1e-8;
  for (const double v : {-4e-3, -2e-3, 0.4e-3, 2.3e-3, 8e-3})
    for (const FrictionLaw &law :
         {FrictionLaw(RegularisedCoulombFriction{0.2, 1e-3}),
          FrictionLaw(ambrosio),
          FrictionLaw(StribeckFriction{curve, 1e-3, 0.5})})
      {
        const double slope = (compute_friction_ratio(law, v + dv).value -
                              compute_friction_ratio(law, v - dv).value) /
                             (2 * dv);
        error =
          std::max(error,
                   std::abs(slope -
                            compute_friction_ratio(law, v).d_sliding_speed));
      }
  report_below("derivatives of friction, error [s/m]", error, 1e-5);
}

// The state after @p time at the speed v(t), by Heun's method with many steps.
double
bristles(const LuGreFriction                 &law,
         const std::function<double(double)> &v,
         const double                         time)
{
  constexpr unsigned int n = 100000;
  const double           h = time / n;
  double                 z = 0.;
  for (unsigned int i = 0; i < n; ++i)
    {
      const double k1 = law.state_rate(v(i * h), z).value;
      const double k2 = law.state_rate(v((i + 1) * h), z + h * k1).value;
      z += h * (k1 + k2) / 2;
    }
  return z;
}

void
check_lugre()
{
  const StribeckCurve curve = {0.1, 0.3, 0.01};
  const LuGreFriction law   = {curve, 1e5, 20., 0.5};
  double              error = 0.;
  for (const double v : {-0.05, -0.01, 0.002, 0.01, 0.1})
    {
      // Long enough for 100 break-away displacements.
      const double z = bristles(
        law, [v](double) { return v; }, 3e-4 / std::abs(v));
      const double exact = std::copysign(curve.value(v), v) + 0.5 * v;
      error = std::max(error, std::abs(law.ratio(v, z).value / exact - 1));
      error = std::max(error, std::abs(law.steady_state(v) / z - 1));
    }
  report_below("LuGre, steady state, relative error", error, 1e-6);
  // To and fro by 1 nm, 1/3000 of the break-away displacement: a spring but for
  // that part.
  const double amplitude = 1e-9, frequency = 10.;
  const double z = bristles(
    law,
    [&](const double t) {
      return amplitude * frequency * std::cos(frequency * t);
    },
    M_PI / 2 / frequency);
  report_value("LuGre, presliding stiffness over sigma_0",
               law.ratio(0., z).value / amplitude / law.bristle_stiffness,
               3);
  error = 0.;
  for (const double v : {-0.02, -0.003, 0.004, 0.03})
    {
      const double            dv = 1e-8, dz = 1e-10, s = 1.1e-6;
      const FrictionRatio     f = law.ratio(v, s);
      const FrictionStateRate r = law.state_rate(v, s);
      const auto relative       = [](const double slope, const double exact) {
        return std::abs(slope / exact - 1);
      };
      error = std::max(
        {error,
         relative((law.ratio(v + dv, s).value - law.ratio(v - dv, s).value) /
                    (2 * dv),
                  f.d_sliding_speed),
         relative((law.ratio(v, s + dz).value - law.ratio(v, s - dz).value) /
                    (2 * dz),
                  f.d_state),
         relative((law.state_rate(v + dv, s).value -
                   law.state_rate(v - dv, s).value) /
                    (2 * dv),
                  r.d_sliding_speed),
         relative((law.state_rate(v, s + dz).value -
                   law.state_rate(v, s - dz).value) /
                    (2 * dz),
                  r.d_state)});
    }
  report_below("LuGre, derivatives, relative error", error, 1e-5);
}

int
main()
{
  // As in the literature.
  const double table[4][2] = {{0.5, 0.725241},
                              {0.7, 0.795973},
                              {0.8, 0.847102},
                              {0.9, 0.913177}};
  for (const auto &[e_r, e_out] : table)
    check_impact("Lankarani-Nikravesh", e_r, e_out);
  for (const double e_r : {0.5, 0.9})
    check_impact("Hunt-Crossley", e_r, leaving_speed(1.5 * (1 - e_r)));
  for (const double e_r : {0.2, 0.5, 0.9})
    check_impact("Flores", e_r, leaving_speed(1.6 * (1 - e_r) / e_r));
  check_impact("elastic foundation", 0.7, 0.795973);
  check_spring_damper(0.05);
  check_spring_damper(0.4);
  for (const std::string name :
       {"Hertz", "spring-damper", "elastic foundation"})
    check_elastic(name);

  check_derivatives("Hertz", HertzLaw{1.5e10});
  check_derivatives("Lankarani-Nikravesh", LankaraniNikraveshLaw{1.5e10, 0.8});
  check_derivatives("Hunt-Crossley", HuntCrossleyLaw{1.5e10, 0.8});
  check_derivatives("Flores", FloresLaw{1.5e10, 0.3});
  check_derivatives("spring-damper", SpringDamperLaw{1e8, 1e3});
  check_derivatives("elastic foundation",
                    ElasticFoundationLaw{1e-4, 20e-3, 30e-3, 4e13, 0.8});
  check_elastic_foundation();
  check_friction_values();
  check_lugre();
}

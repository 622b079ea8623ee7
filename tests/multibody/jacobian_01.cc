// SPDX-License-Identifier: LGPL-2.1-or-later

// Derivatives of all elements against central differences at a state without
// any symmetry: constraints (first and second derivatives, by coordinates and
// by time; the reaction is what Phi_q^T lambda does to the second body),
// springs with dampers, applied forces, and the clearance joint in contact with
// a bore that is not round and a sliding speed in the middle of the friction
// law's smooth part. Differences are of second order, so 1e-6 relative is what
// they can show; no entry may be wrong.
//
// The clearance profile meets its nodal values, is periodic, and its
// derivatives converge to those of the smooth function that it was made from.
// Derivatives of time functions against closed forms: as accurate as their
// documentation says, from the slow to the fast, a pulse between the points of
// the coarse differences included.
// Penetrations found for a force give that force.

#include "report.h"
#include <tribody/multibody/elements/angle_driver.h>
#include <tribody/multibody/elements/applied_force.h>
#include <tribody/multibody/elements/distance_driver.h>
#include <tribody/multibody/elements/massless_link_constraint.h>
#include <tribody/multibody/elements/rigid_constraint.h>
#include <tribody/multibody/elements/rotational_spring.h>
#include <tribody/multibody/elements/spring.h>
#include <tribody/multibody/elements/translational_constraint.h>
#include <tribody/multibody/joints/clearance_joint.h>
#include <tribody/surface/periodic_profile.h>

#include <functional>
#include <sstream>

using namespace Tribody;
using namespace Tribody::Multibody;

// Central differences of a vector function of six variables. Step per variable.
Eigen::MatrixXd
differences(const std::function<Eigen::VectorXd(const PairVector &)> &f,
            const PairVector                                         &x,
            const double                                              step)
{
  Eigen::MatrixXd result(f(x).size(), 6);
  for (int k = 0; k < 6; ++k)
    {
      const PairVector d = step * PairVector::Unit(k);
      result.col(k)      = (f(x + d) - f(x - d)) / (2 * step);
    }
  return result;
}

double
relative_error(const Eigen::MatrixXd &a, const Eigen::MatrixXd &b)
{
  return (a - b).lpNorm<Eigen::Infinity>() / b.lpNorm<Eigen::Infinity>();
}

void
check_constraint(const std::string &name, const Constraint &c)
{
  PairVector q;
  q << 0.3, -0.2, 0.7, 0.9, 0.4, -1.1;
  const Constraint::Values w(0.6, -1.7, 0.8);
  report_below(name + ", first derivative",
               relative_error(
                 c.jacobian(q),
                 differences([&](
                               const PairVector &x) { return c.value(0.3, x); },
                             q,
                             1e-5)),
               1e-8);
  report_below(name + ", second derivative",
               (c.weighted_hessian(q, w) - differences(
                                             [&](const PairVector &x) {
                                               return Eigen::VectorXd(
                                                 c.jacobian(x).transpose() * w);
                                             },
                                             q,
                                             1e-5))
                 .lpNorm<Eigen::Infinity>(),
               1e-8);
  report_below(name + ", reaction",
               (c.reaction_force(q, w) +
                (c.jacobian(q).transpose() * w).segment<2>(3))
                 .norm(),
               1e-14);
}

// A driver's derivatives by time.
void
check_time_derivatives(const std::string &name, const Constraint &c)
{
  const PairVector q = PairVector::LinSpaced(0.1, 0.9);
  const double     t = 0.3, step = 1e-4;
  const auto       differ = [&](const auto &f) {
    return ((f(t + step) - f(t - step)) / (2 * step)).eval();
  };
  report_below(name + ", derivative by time",
               (c.time_derivative(t) -
                differ([&](const double x) { return c.value(x, q); }))
                 .norm(),
               1e-6);
  report_below(name + ", second derivative by time",
               (c.second_time_derivative(t) -
                differ([&](const double x) { return c.time_derivative(x); }))
                 .norm(),
               1e-6);
}

void
check_rotational_spring()
{
  const RotationalSpring spring = {{0, 1}, 500., 7., 0.4, 30.};
  PairVector             q, v;
  q << 0.3, -0.2, 0.7, 0.9, 0.4, -1.1;
  v << 0.5, 0.1, -2., 0.3, -0.4, 1.3;
  const PairForce f = spring.compute_force(q, v);
  // 30 + 500 (1.8 - 0.4) - 7 * 3.3
  report_value("rotational spring: torque [N m]", f.force(5), 4);
  report_below("  derivative by position",
               relative_error(f.d_position,
                              differences(
                                [&](const PairVector &x) {
                                  return spring.compute_force(x, v).force;
                                },
                                q,
                                1e-5)),
               1e-8);
  report_below("  derivative by velocity",
               relative_error(f.d_velocity,
                              differences(
                                [&](const PairVector &x) {
                                  return spring.compute_force(q, x).force;
                                },
                                v,
                                1e-5)),
               1e-8);
  report_below("  force and potential energy",
               relative_error(
                 spring.compute_force(q, PairVector::Zero()).force.transpose(),
                 differences(
                   [&](const PairVector &x) {
                     return Eigen::VectorXd::Constant(
                       1, -spring.potential_energy(x));
                   },
                   q,
                   1e-5)),
               1e-8);
}

void
check_applied_force(const bool turns_with_body)
{
  const AppliedForce force = {{0, {0.1, 0.2}},
                              {3., -7.},
                              turns_with_body,
                              TimeFunction("f", "cos(2*t)")};
  PairVector         q     = PairVector::Zero();
  q.head<3>() << 0.3, -0.2, 0.7;
  const double    t = 0.3;
  Eigen::Matrix3d exact =
    differences(
      [&](const PairVector &x) {
        return Eigen::VectorXd(force.compute_force(t, x.head<3>()).force);
      },
      q,
      1e-5)
      .leftCols<3>();
  const BodyForce result = force.compute_force(t, q.head<3>());
  report_below("applied force, derivative by position",
               relative_error(result.d_position, exact),
               1e-8);
  // Power of the force in a motion of the body, by the way of its marker.
  const Eigen::Vector3d v(0.4, -1.1, 2.3);
  const double          step = 1e-6;
  const Eigen::Vector2d way =
    (marker_position(q.head<3>() + step * v, force.marker.position) -
     marker_position(q.head<3>() - step * v, force.marker.position)) /
    (2 * step);
  const Eigen::Vector2d global =
    std::cos(2 * t) *
    (turns_with_body ? turned(force.vector, q(2)) : force.vector);
  report_below("  power",
               std::abs(result.force.dot(v) / global.dot(way) - 1),
               1e-8);
}

void
check_time_function(const std::string &expression,
                    const double       t,
                    const double       size,
                    const double       frequency,
                    const double       first,
                    const double       second)
{
  const TimeFunction          function("f", expression);
  const std::array<double, 2> found = function.derivatives(t);
  report_below(expression + ", first derivative",
               std::abs(found[0] - first) / (size * frequency),
               2e-11);
  report_below(expression + ", second derivative",
               std::abs(found[1] - second) / (size * frequency * frequency),
               1e-9);
}

void
check_time_functions()
{
  for (const double w : {1., 30., 1000., 30000.})
    {
      std::ostringstream expression;
      expression << "3*sin(" << w << "*t)";
      const double t = std::min(0.7, 900 / w);
      check_time_function(expression.str(),
                          t,
                          3.,
                          w,
                          3 * w * std::cos(w * t),
                          -3 * w * w * std::sin(w * t));
    }
  // 1 ms wide, seen from its flank.
  const double x = 0.6, e = std::exp(-x * x);
  check_time_function("exp(-(1000*(t-1))^2)",
                      1 + 1e-3 * x,
                      1.,
                      1000.,
                      -2 * x * e * 1e3,
                      (4 * x * x - 2) * e * 1e6);
  check_time_function("0.5*t^2 - 3*t", -2., 1., 1., -5., 1.);
  check_time_function("7.5", 1., 1., 1., 0., 0.);
}

void
check_spring()
{
  Spring     spring = {{0, 1}, {0.1, 0.2}, {-0.3, 0.1}, 500., 7., 0.4, 30.};
  PairVector q, v;
  q << 0.3, -0.2, 0.7, 0.9, 0.4, -1.1;
  v << 0.5, 0.1, -2., 0.3, -0.4, 1.3;
  const PairForce f = spring.compute_force(q, v);
  report_below("spring, derivative by position",
               relative_error(f.d_position,
                              differences(
                                [&](const PairVector &x) {
                                  return spring.compute_force(x, v).force;
                                },
                                q,
                                1e-5)),
               1e-7);
  report_below("spring, derivative by velocity",
               relative_error(f.d_velocity,
                              differences(
                                [&](const PairVector &x) {
                                  return spring.compute_force(q, x).force;
                                },
                                v,
                                1e-5)),
               1e-7);
  // The conservative part is the gradient of the potential energy.
  spring.damping = 0.;
  report_below("spring, force and potential energy",
               relative_error(spring.compute_force(q, v).force.transpose(),
                              differences(
                                [&](const PairVector &x) {
                                  return Eigen::VectorXd::Constant(
                                    1, -spring.potential_energy(x));
                                },
                                q,
                                1e-5)),
               1e-7);
}

PeriodicProfile
worn_profile(const unsigned int n)
{
  const Eigen::VectorXd angles =
    Eigen::VectorXd::LinSpaced(n, 0., 2 * M_PI * (n - 1) / n);
  return PeriodicProfile(angles,
                         1e-5 * (1 + 0.3 * (2 * angles.array()).sin() +
                                 0.2 * angles.array().cos()));
}

// Worn by up to 0.4 mm about the angle 2.6.
PeriodicProfile
deeply_worn_profile()
{
  const int             n = 360;
  const Eigen::VectorXd angles =
    Eigen::VectorXd::LinSpaced(n, 0., 2 * M_PI * (n - 1) / n);
  return PeriodicProfile(angles,
                         1e-5 + 0.2e-3 * (1 + (angles.array() - 2.6).cos()));
}

// Springs all around the bore, which press where the pin overlaps a round bore,
// along the lines to its centre. The pin may be worn by up to twice an
// amplitude on one side.
class SpringRing : public PinSupport
{
public:
  SpringRing(const double bore_radius,
             const double pin_radius,
             const double amplitude)
    : bore_radius(bore_radius)
    , pin_radius(pin_radius)
    , amplitude(amplitude)
  {}

  SupportForce
  compute_force(const Eigen::Vector2d &e, const double alpha) const override
  {
    constexpr int    n         = 400;
    constexpr double stiffness = 1e3;
    SupportForce     result;
    for (int i = 0; i < n; ++i)
      {
        const double          angle = 2 * M_PI * i / n;
        const Eigen::Vector2d y =
          bore_radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)) - e;
        const double distance   = y.norm();
        const double recess     = amplitude * (1 + std::cos(angle - alpha));
        const double d_recess   = amplitude * std::sin(angle - alpha);
        const double d2_recess  = -amplitude * std::cos(angle - alpha);
        const double overlap    = pin_radius - recess - distance;
        const Eigen::Vector2d m = y / distance;
        if (overlap <= 0)
          continue;
        result.force += stiffness * overlap * m;
        result.magnitudes += stiffness * overlap;
        result.energy += stiffness * overlap * overlap / 2;
        result.d_force.leftCols<2>() +=
          stiffness * (m * m.transpose() -
                       overlap / distance *
                         (Eigen::Matrix2d::Identity() - m * m.transpose()));
        result.d_magnitudes.head<2>() += stiffness * m.transpose();
        result.d_force.col(2) -= stiffness * d_recess * m;
        result.d_magnitudes(2) -= stiffness * d_recess;
        result.moment += stiffness * overlap * d_recess;
        result.d_moment.head<2>() += stiffness * d_recess * m.transpose();
        result.d_moment(2) +=
          stiffness * (overlap * d2_recess - d_recess * d_recess);
      }
    return result;
  }

  Eigen::Vector2d
  find_position(const Eigen::Vector2d &, const double) const override
  {
    return Eigen::Vector2d::Zero();
  }

private:
  double bore_radius, pin_radius, amplitude;
};

enum class Surfaces
{
  worn_scalar,
  worn,
  worn_with_pin,
  elastic,
  elastic_with_worn_pin
};

JointCondition
make_surfaces(const Surfaces surfaces, ClearanceJoint &joint)
{
  if (surfaces == Surfaces::worn_scalar)
    joint.penetration_measure = PenetrationMeasure::scalar;
  if (surfaces == Surfaces::elastic ||
      surfaces == Surfaces::elastic_with_worn_pin)
    {
      joint.contact_law = FiniteElementLaw{0.7};
      return joint.make_condition(
        PeriodicProfile(joint.nominal_clearance()),
        std::make_shared<SpringRing>(joint.bushing_radius,
                                     joint.pin_radius,
                                     surfaces == Surfaces::elastic_with_worn_pin
                                       ? 5e-6
                                       : 0.));
    }
  JointClearance clearance = deeply_worn_profile();
  if (surfaces == Surfaces::worn_with_pin)
    clearance.pin_wear = worn_profile(180);
  return joint.make_condition(clearance);
}

void
check_clearance_joint(const std::string &name,
                      const Surfaces     surfaces,
                      const std::string &friction,
                      const double       damping)
{
  ClearanceJoint joint = {"joint",
                          {0, 1},
                          {0.1, 0.2},
                          {-0.3, 0.1},
                          9.525e-3,
                          9.535e-3,
                          LankaraniNikraveshLaw{1.5e7, 0.7},
                          NoFriction{},
                          damping,
                          1e-2};
  if (friction != "none")
    joint.friction_law = RegularisedCoulombFriction{0.15, 1e-3};

  // Second body such that the pin is 20 um deep in the worn bore, and the
  // bodies' speeds such that the surfaces slide by about 0.4 mm/s and the pin
  // approaches.
  const JointCondition condition = make_surfaces(surfaces, joint);
  PairVector           q, v;
  q << 0.3, -0.2, 0.7, 0., 0., -1.1;
  const Eigen::Vector2d n(std::cos(2.), std::sin(2.));
  const Eigen::Vector2d e = turned(
    condition.surfaces.find_position(turned(n, -q(5)), 20e-6, q(2) - q(5)),
    q(5));
  const double c = n.dot(e) - 20e-6;
  q.segment<2>(3) =
    marker_position(q.head<3>(), joint.s_1) - e - turned(joint.s_2, q(5));
  v << 0.5, 0.1, -2., 0., 0., 1.3;
  const Eigen::Vector2d p_t = v.head<2>() +
                              v(2) * perpendicular(turned(joint.s_1, q(2))) -
                              v(5) * perpendicular(turned(joint.s_2, q(5)));
  const double turning = joint.pin_radius * (v(2) - v(5)) - c * v(5);
  const double wrapping =
    find_supported_contact(condition, turned(e, -q(5)), q(2) - q(5)).wrapping;
  v.segment<2>(3) =
    p_t - 2e-3 * n - wrapping * (0.4e-3 - turning) * perpendicular(n);

  const auto force = [&](const PairVector &x, const PairVector &y) {
    return joint.compute_force(x, joint.compute_contact(x, y, condition, 0.02));
  };
  const JointContact contact = joint.compute_contact(q, v, condition, 0.02);
  report_value(name + ": sliding speed [mm/s]", 1e3 * contact.sliding_speed, 3);
  report_value("  normal force [N]", contact.normal_force, 3);
  const PairForce f =
    joint.compute_force_with_derivatives(q, v, condition, 0.02);
  report_below("  force", relative_error(f.force, force(q, v)), 1e-14);
  report_below(
    "  derivative by position",
    relative_error(
      f.d_position,
      differences([&](const PairVector &x) { return force(x, v); }, q, 2e-9)),
    1e-5);
  report_below(
    "  derivative by velocity",
    relative_error(
      f.d_velocity,
      differences([&](const PairVector &x) { return force(q, x); }, v, 1e-7)),
    1e-5);
  // Action and reaction: no net force, and the net moment about the origin is
  // that of two opposite forces whose points, one on each surface, lie a
  // penetration apart: minus tangential force times penetration. Rounding
  // leaves 1e-15 of force times lever (about 1 m); the wear times friction,
  // which must not appear, would be 6e-5 of it.
  const PairVector      b = f.force;
  const Eigen::Vector2d r1(q.head<2>()), r2(q.segment<2>(3));
  const double moment = b(2) + b(5) + perpendicular(r1).dot(b.head<2>()) +
                        perpendicular(r2).dot(b.segment<2>(3));
  report_below("  net force over force",
               (b.head<2>() + b.segment<2>(3)).norm() / contact.normal_force,
               1e-13);
  // Elastic surfaces have one point of contact; where the pin is worn, normal
  // and radius differ by less than 1e-2 in direction.
  const double left =
    surfaces == Surfaces::elastic || surfaces == Surfaces::elastic_with_worn_pin
      ? moment
      : moment + contact.tangential_force * contact.penetration;
  report_below("  net moment but that of the penetration over force [m]",
               std::abs(left) / contact.normal_force,
               surfaces == Surfaces::worn_with_pin ? 1e-2 * 20e-6 : 1e-14);
}

void
check_profile()
{
  double errors[2][3];
  for (const unsigned int i : {0, 1})
    {
      const PeriodicProfile profile = worn_profile(90 * (i + 1));
      for (double &error : errors[i])
        error = 0.;
      for (double x = -7.; x < 13.; x += 0.0137)
        {
          const PeriodicProfile::Values c        = profile.evaluate(x);
          const double                  exact[3] = {1 + 0.3 * std::sin(2 * x) +
                                                      0.2 * std::cos(x),
                                                    0.6 * std::cos(2 * x) - 0.2 * std::sin(x),
                                                    -1.2 * std::sin(2 * x) - 0.2 * std::cos(x)};
          const double                  found[3] = {1e5 * c.value,
                                                    1e5 * c.first_derivative,
                                                    1e5 * c.second_derivative};
          for (const unsigned int k : {0, 1, 2})
            errors[i][k] =
              std::max(errors[i][k], std::abs(found[k] - exact[k]));
        }
    }
  for (const unsigned int k : {0, 1, 2})
    report_value("clearance profile, rate of derivative " + std::to_string(k),
                 std::log2(errors[0][k] / errors[1][k]),
                 1);
  report_below("  error at 180 nodes", errors[1][0], 1e-6);

  // Nodes that are not equidistant.
  const Eigen::VectorXd even =
    Eigen::VectorXd::LinSpaced(200, 0., 2 * M_PI * 199 / 200);
  const Eigen::VectorXd uneven = even.array() + 0.1 * even.array().sin();
  const PeriodicProfile profile(uneven, 1 + uneven.array().cos());
  double                error = 0.;
  for (double x = -7.; x < 13.; x += 0.0137)
    error = std::max(error, std::abs(profile.value(x) - 1 - std::cos(x)));
  report_below("  error with uneven nodes", error, 1e-3);
}

// A LuGre joint 20 um deep in its bore: derivatives by the state of friction
// and of its rate.
void
check_friction_state()
{
  ClearanceJoint joint           = {"joint",
                                    {0, 1},
                                    {0., 0.},
                                    {0., 0.},
                                    9.525e-3,
                                    9.535e-3,
                                    LankaraniNikraveshLaw{1.5e7, 0.7},
                                    LuGreFriction{{0.1, 0.3, 0.01}, 1e5, 20., 0.5},
                                    0.,
                                    1e-2};
  joint.friction_state_index     = 0;
  const JointCondition condition = joint.make_condition(PeriodicProfile(10e-6));
  PairVector           q, v;
  q << 20e-6, -22e-6, 0.7, 0., 0., -1.1;
  v << 0.5e-3, 0.1e-3, 0.4, 0., 0., 0.3;
  const double z = 0.7e-6, step = 1e-10;
  const auto   contact =
    [&](const PairVector &x, const PairVector &y, const double state) {
      return joint.compute_contact(x, y, condition, 0.02, state);
    };
  const auto rate = [&](const PairVector &x, const PairVector &y) {
    return Eigen::VectorXd::Constant(
      1, joint.compute_friction_state_rate(contact(x, y, z), z));
  };
  const ClearanceForce f =
    joint.compute_force_with_derivatives(q, v, condition, 0.02, z);
  report_below("friction state: derivative of the force",
               relative_error(f.d_state,
                              (joint.compute_force(q, contact(q, v, z + step)) -
                               joint.compute_force(q,
                                                   contact(q, v, z - step))) /
                                (2 * step)),
               1e-6);
  report_below(
    "  of the rate by position",
    relative_error(
      f.rate_d_position,
      differences([&](const PairVector &x) { return rate(x, v); }, q, 2e-9)),
    1e-5);
  report_below(
    "  of the rate by velocity",
    relative_error(
      f.rate_d_velocity,
      differences([&](const PairVector &x) { return rate(q, x); }, v, 1e-7)),
    1e-5);
  report_below(
    "  of the rate by the state",
    std::abs((joint.compute_friction_state_rate(contact(q, v, z), z + step) -
              joint.compute_friction_state_rate(contact(q, v, z), z - step)) /
               (2 * step) / f.rate_d_state -
             1),
    1e-6);
}

int
main()
{
  check_friction_state();
  const Marker first = {0, {0.1, 0.2}}, second = {1, {-0.3, 0.1}};
  check_constraint("revolute", RevoluteConstraint("", first, second));
  check_constraint("massless link",
                   MasslessLinkConstraint("", first, second, 0.3));
  check_constraint("translational",
                   TranslationalConstraint("", first, second, 0.4, 0.2));
  check_constraint("rigid", RigidConstraint("", first, second, 0.2));
  check_constraint("point on line",
                   PointOnLineConstraint("", first, second, 0.4));
  const DriverMotion   motion = {0.3, 2., 0.5, TimeFunction("f", "sin(3*t)")};
  const AngleDriver    angle_driver("", {0, 1}, motion);
  const DistanceDriver distance_driver("", first, second, motion);
  check_constraint("angle driver", angle_driver);
  check_time_derivatives("angle driver", angle_driver);
  check_constraint("distance driver", distance_driver);
  check_time_derivatives("distance driver", distance_driver);
  check_time_functions();
  check_spring();
  check_rotational_spring();
  check_applied_force(false);
  check_applied_force(true);
  const std::string coulomb = "Coulomb regularised";
  check_clearance_joint("worn, scalar", Surfaces::worn_scalar, "none", 0.);
  check_clearance_joint("worn, scalar", Surfaces::worn_scalar, coulomb, 200.);
  check_clearance_joint("worn, deepest", Surfaces::worn, "none", 0.);
  check_clearance_joint("worn, deepest", Surfaces::worn, coulomb, 200.);
  check_clearance_joint("both worn", Surfaces::worn_with_pin, coulomb, 200.);
  check_clearance_joint("elastic", Surfaces::elastic, coulomb, 200.);
  check_clearance_joint("elastic, pin worn",
                        Surfaces::elastic_with_worn_pin,
                        coulomb,
                        200.);
  check_profile();

  const ContactForceLaw law = LankaraniNikraveshLaw{1.5e10, 0.8};
  for (const double force : {1e-3, 1e2, 1e5})
    report_below(
      "inverse of the contact law",
      std::abs(
        compute_normal_force(
          law, {compute_penetration(law, force, -3e-3, 0.01), -3e-3, 0.01})
            .value /
          force -
        1),
      1e-10);
}

// SPDX-License-Identifier: LGPL-2.1-or-later

// The deepest penetration of a pin into a worn bore, with its derivatives.
// Known: in a round bore |e| - c with the direction e/|e|; in an elliptic bore
// any point p with its normal n, as the centre e = p - (R - delta) n follows
// from them, as long as the pin curves more than the ellipse; with a larger pin
// on the major axis, delta = R - b sqrt(1 - e^2/(a^2 - b^2)), on two points at
// once. A crescent that the pin itself has made fits it: there the pin
// penetrates by as much as it moves, whatever the direction within the
// crescent. The profiles are splines through 720 values; their error falls
// with the fourth power of the spacing and is below 1e-11 m here, but at the
// ends of the crescent.
//
// A pin that has lost h everywhere is as good as a clearance larger by h. A pin
// with a flat, and a bore with two lobes, are compared with the largest overlap
// of 200 000 directions, which miss the top of a rounded corner by up to 0.2
// nm. Derivatives against central differences, which leave about 1e-7. Elastic
// forces along the gradient of delta have a potential: the second derivatives
// are symmetric.

#include <tribody/surface/pin_in_bore.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <string>

using namespace Tribody;
using Eigen::Vector2d;

std::ostream &output = std::cout;

constexpr double R = 9.5e-3;

void
report_below(const std::string &name, const double value, const double bound)
{
  if (value <= bound)
    output << name << ": below " << bound << '\n';
  else
    output << name << ": " << value << " is above " << bound << '\n';
}

Vector2d
unit(const double angle)
{
  return {std::cos(angle), std::sin(angle)};
}

PeriodicProfile
make_profile(const std::function<double(double)> &value)
{
  const int             n = 720;
  const Eigen::VectorXd angles =
    Eigen::VectorXd::LinSpaced(n, 0., 2 * M_PI * (n - 1) / n);
  return PeriodicProfile(angles, angles.unaryExpr(value));
}

void
round_bore()
{
  double error = 0.;
  for (const auto measure :
       {PenetrationMeasure::deepest, PenetrationMeasure::scalar})
    for (const double angle : {0., 1., 3., 5.})
      {
        const PinInBore pin(PeriodicProfile(40e-6), R, measure);
        const Vector2d  e       = 45e-6 * unit(angle);
        const auto      contact = pin.find_contact(e, 0.3);
        error                   = std::max(
          {error,
                             std::abs(contact.penetration - 5e-6) / 5e-6,
                             (contact.direction - unit(angle)).norm(),
                             std::abs(pin.compute_penetration(e, 0.3) / contact.penetration -
                    1)});
      }
  report_below("round bore", error, 1e-10);
}

void
elliptic_bore()
{
  const double    a = 10.5e-3, b = 10.2e-3, delta = 20e-6;
  const PinInBore pin(make_profile([&](const double x) {
                        return 1 /
                                 std::hypot(std::cos(x) / a, std::sin(x) / b) -
                               R;
                      }),
                      R);
  double          error = 0., direction_error = 0., place_error = 0.;
  for (double t = 0.; t < 2 * M_PI; t += 0.1)
    {
      const Vector2d p(a * std::cos(t), b * std::sin(t));
      const Vector2d n =
        Vector2d(std::cos(t) / a, std::sin(t) / b).normalized();
      const Vector2d e       = p - (R - delta) * n;
      const auto     contact = pin.find_contact(e, 0.);
      error = std::max(error, std::abs(contact.penetration - delta));
      direction_error =
        std::max(direction_error, (contact.direction - n).norm());
      place_error =
        std::max(place_error, (pin.find_position(n, delta, 0.) - e).norm());
    }
  report_below("elliptic bore, penetration [nm]", 1e9 * error, 0.01);
  report_below("  direction", direction_error, 1e-6);
  report_below("  place found for them [nm]", 1e9 * place_error, 1.);

  const double    radius = 10.1e-3;
  JointClearance  tight  = make_profile([&](const double x) {
    return 1 / std::hypot(std::cos(x) / a, std::sin(x) / b) - radius;
  });
  const PinInBore two_points(tight, radius);
  const double    e     = 0.3e-3;
  const double    known = radius - b * std::sqrt(1 - e * e / (a * a - b * b));
  report_below("  on two points [nm]",
               1e9 *
                 std::abs(two_points.compute_penetration({e, 0.}, 0.) - known),
               0.01);
}

void
crescent()
{
  const double    c = 10e-6, sunk = 0.3e-3;
  const PinInBore pin(
    make_profile([&](const double x) {
      const double e = c + sunk;
      return std::max(c,
                      e * std::cos(x) +
                        std::sqrt(R * R - std::pow(e * std::sin(x), 2)) - R);
    }),
    R);
  double error = 0., direction_error = 0.;
  for (double angle = -1.; angle <= 1.; angle += 0.1)
    {
      const Vector2d e       = Vector2d(c + sunk, 0.) + 10e-6 * unit(angle);
      const auto     contact = pin.find_contact(e, 0.);
      error = std::max(error, std::abs(contact.penetration - 10e-6) / 10e-6);
      direction_error =
        std::max(direction_error, (contact.direction - unit(angle)).norm());
    }
  report_below("crescent, penetration", error, 1e-4);
  report_below("  direction", direction_error, 1e-3);
}

void
two_lobes()
{
  const PeriodicProfile bore = make_profile(
    [](const double x) { return 50e-6 + 30e-6 * std::cos(2 * x - 0.2); });
  const PinInBore pin(bore, R);
  double          error = 0.;
  for (double angle = 0.; angle < 6.3; angle += 0.3)
    {
      const Vector2d e       = 60e-6 * unit(angle);
      double         largest = -1.;
      for (int i = 0; i < 200000; ++i)
        {
          const double x = 2 * M_PI * i / 200000;
          largest =
            std::max(largest, R - ((R + bore.value(x)) * unit(x) - e).norm());
        }
      error =
        std::max(error, std::abs(pin.compute_penetration(e, 0.) - largest));
    }
  report_below("two lobes [nm]", 1e9 * error, 1e-4);
}

void
worn_pin()
{
  const PeriodicProfile lobes = make_profile(
    [](const double x) { return 50e-6 + 10e-6 * std::cos(2 * x - 0.2); });
  double error = 0.;
  for (const auto measure :
       {PenetrationMeasure::deepest, PenetrationMeasure::scalar})
    for (double angle = 0.; angle < 6.3; angle += 0.3)
      {
        const Vector2d  e = 60e-6 * unit(angle);
        const PinInBore worn({lobes, PeriodicProfile(5e-6)}, R, measure);
        const PinInBore same(
          {lobes, make_profile([](const double) { return 5e-6; })}, R, measure);
        const auto a = worn.find_contact(e, 0.4);
        const auto b = same.find_contact(e, 0.4);
        error        = std::max({error,
                                 std::abs(a.penetration - b.penetration) / 5e-6,
                                 (a.direction - b.direction).norm()});
        if (measure == PenetrationMeasure::deepest)
          {
            // The same bore, as a smaller pin sees it.
            const PinInBore narrow(make_profile([&](const double x) {
                                     return lobes.value(x) + 5e-6;
                                   }),
                                   R - 5e-6);
            error = std::max(error,
                             std::abs(narrow.compute_penetration(e, 0.4) -
                                      a.penetration) /
                               5e-6);
          }
      }
  report_below("pin worn uniformly", error, 1e-6);

  // In a round bore, a pin whose flat begins at angles of +-0.4, with rounded
  // corners.
  const double         flat = R * std::cos(0.4), corner = 20e-6;
  const JointClearance clearance{
    PeriodicProfile(40e-6), make_profile([&](const double x) {
      const double beta = std::remainder(x - 1., 2 * M_PI);
      const double lost =
        std::abs(beta) < 1. ? (R - flat / std::cos(beta)) / corner : -50.;
      return corner * std::log1p(std::exp(std::max(-50., lost)));
    })};
  const PinInBore pin(clearance, R);
  const double    bore = R + 40e-6;
  error                = 0.;
  for (const double angle : {0.9, 1.3, 1.7, 2.5})
    {
      const double   alpha   = 0.3;
      const Vector2d e       = 45e-6 * unit(angle);
      double         largest = -1.;
      for (int i = 0; i < 200000; ++i)
        {
          const double   psi  = 2 * M_PI * i / 200000;
          const Vector2d m    = unit(psi);
          const double   side = e.x() * m.y() - e.y() * m.x();
          const double   d    = std::sqrt(bore * bore - side * side) - e.dot(m);
          largest =
            std::max(largest, R - clearance.pin_wear.value(psi - alpha) - d);
        }
      error =
        std::max(error, std::abs(pin.compute_penetration(e, alpha) - largest));
    }
  report_below("pin with a flat [nm]", 1e9 * error, 1.);
}

void
derivatives(const std::string &name, const PinInBore &pin)
{
  const Eigen::Vector3d w(40e-6, -30e-6, 0.6);
  const auto            at = [&pin](const Eigen::Vector3d &x) {
    return pin.find_contact(x.head<2>(), x(2));
  };
  const SurfaceContact contact = at(w);
  double               error = 0., second = 0., rest = 0.;
  for (int k = 0; k < 3; ++k)
    {
      const double          step = k < 2 ? 1e-9 : 1e-6;
      const Eigen::Vector3d d    = step * Eigen::Vector3d::Unit(k);
      const SurfaceContact  a = at(w + d), b = at(w - d);
      const auto            compare = [&](const Eigen::MatrixXd &found,
                               const Eigen::MatrixXd &x,
                               const Eigen::MatrixXd &y,
                               const double           scale) {
        return (found - (x - y) / (2 * step)).norm() / scale;
      };
      const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(1, 1);
      // One metre per radian is what a lever of a metre would do.
      error               = std::max(error,
                       compare(one * contact.d_penetration(k),
                               one * a.penetration,
                               one * b.penetration,
                               k < 2 ? 1. : 1e-5));
      second              = std::max(second,
                        compare(contact.d2_penetration.col(k),
                                a.d_penetration.transpose(),
                                b.d_penetration.transpose(),
                                contact.d2_penetration.col(k).norm()));
      const auto relative = [&](const Eigen::MatrixXd &found,
                                const Eigen::MatrixXd &x,
                                const Eigen::MatrixXd &y) {
        return compare(found, x, y, std::max(1e-3, found.norm()));
      };
      rest = std::max(
        {rest,
         relative(contact.d_direction.col(k), a.direction, b.direction),
         relative(contact.d_pin_point.col(k), a.pin_point, b.pin_point),
         relative(contact.d_bushing_point.col(k),
                  a.bushing_point,
                  b.bushing_point),
         relative(one * contact.d_force_ratio(k),
                  one * a.force_ratio,
                  one * b.force_ratio)});
    }
  report_below(name + ": derivative of the penetration", error, 1e-5);
  report_below("  second derivative", second, 1e-4);
  report_below("  derivatives of direction and points", rest, 1e-4);
  report_below(
    "  asymmetry of the second derivative",
    (contact.d2_penetration - contact.d2_penetration.transpose()).norm() /
      contact.d2_penetration.norm(),
    1e-12);
  report_below("  length of the normal minus one",
               std::abs(contact.direction.norm() - 1),
               1e-14);
}

int
main()
{
  round_bore();
  elliptic_bore();
  crescent();
  two_lobes();
  worn_pin();
  const PeriodicProfile bore = make_profile(
    [](const double x) { return 45e-6 + 20e-6 * std::cos(2 * x + 0.7); });
  const PeriodicProfile pin = make_profile(
    [](const double x) { return 10e-6 + 10e-6 * std::sin(3 * x); });
  derivatives("deepest", PinInBore(bore, R));
  derivatives("deepest, pin worn", PinInBore({bore, pin}, R));
  derivatives("scalar, pin worn",
              PinInBore({bore, pin}, R, PenetrationMeasure::scalar));
}

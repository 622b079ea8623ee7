// SPDX-License-Identifier: LGPL-2.1-or-later

// Contact on a compliance that is given in closed form, so no mesh: Fourier
// modes cos n(theta - theta') of pressure move the bore by c/(1 + |n|) each,
// n < N/2, which makes a symmetric, positive definite circulant C with the
// 1/|n| of an elastic half-space. The bore is round, or worn by 0.3 mm in
// a crescent, h = max(0, d cos theta - shoulder): a shifted circle, smaller by
// the shoulder. The pin has 10 um clearance in the round bore, 5 um in the
// crescent with the small shoulder; in the other one it has none and bridges
// it from crest to crest.
//
// Known whatever the compliance is: all conditions of contact (no penetration,
// no tension, one of them zero, balance of forces); position control at the
// centre that force control found gives that force; a round bore gives the
// same for all directions of force through a node; Newton's iteration, the
// fall-back programme, cold and warm starts find the same; zero force is no
// contact; a force that squeezes nothing presses on two nodes with the pin in
// the corner between them; too large a force is reported, not thrown; the
// sensitivity of the nodal forces is their derivative, to the error of central
// differences that keep the active set.

#include <tribody/contact/contact_solver.h>
#include <tribody/contact/force_sensitivity.h>
#include <tribody/contact/pin_gap.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace Tribody;
using namespace Tribody::Contact;

constexpr double       bore_radius = 9.535e-3, pin_radius = 9.525e-3;
constexpr Eigen::Index n_nodes = 360;

Eigen::MatrixXd
make_compliance()
{
  Eigen::VectorXd response = Eigen::VectorXd::Zero(n_nodes);
  for (Eigen::Index k = 0; k < n_nodes; ++k)
    for (Eigen::Index n = 0; n < n_nodes / 2; ++n)
      response[k] +=
        (n == 0 ? 1. : 2.) / (1. + n) * std::cos(2. * M_PI * n * k / n_nodes);
  Eigen::MatrixXd C(n_nodes, n_nodes);
  for (Eigen::Index i = 0; i < n_nodes; ++i)
    for (Eigen::Index j = 0; j < n_nodes; ++j)
      C(i, j) = 1e-9 * response[std::abs(i - j)];
  return C;
}

BoreSurface
make_bore(const double depth, const double shoulder = 0.)
{
  Eigen::Matrix2Xd positions(2, n_nodes);
  for (Eigen::Index i = 0; i < n_nodes; ++i)
    {
      const double angle = 2. * M_PI * i / n_nodes;
      const double worn =
        std::max(0., depth * std::cos(angle - 0.4) - shoulder);
      positions.col(i) = (bore_radius + worn) *
                         Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
  return make_bore_surface(positions, 1);
}

Eigen::Vector2d
at_angle(const double force, const double angle)
{
  return force * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

/// The largest violation of any condition, all relative.
double
violation(const ContactSolution &s,
          const BoreSurface     &bore,
          const Eigen::MatrixXd &C,
          const Eigen::Vector2d &force)
{
  const PinGap          pin(bore.positions, s.pin_centre, pin_radius);
  const Eigen::VectorXd u   = C * s.nodal_force;
  const Eigen::VectorXd gap = pin.gap + u;
  const double scale = std::max(u.maxCoeff(), 0.1 * (bore_radius - pin_radius));
  const Eigen::Vector2d total =
    pin.directions * bore.weights.cwiseProduct(s.pressure);
  return std::max({-gap.minCoeff() / scale,
                   (gap - s.gap).cwiseAbs().maxCoeff() / scale,
                   -s.nodal_force.minCoeff() / s.nodal_force.maxCoeff(),
                   gap.cwiseProduct(s.nodal_force).maxCoeff() / scale /
                     s.nodal_force.maxCoeff(),
                   (total - force).norm() / force.norm(),
                   (s.force - force).norm() / force.norm()});
}

double
difference(const ContactSolution &a, const ContactSolution &b)
{
  return std::max((a.nodal_force - b.nodal_force).norm() / a.nodal_force.norm(),
                  (a.pin_centre - b.pin_centre).norm() / a.pin_centre.norm());
}

void
check_bore(const double depth, const double shoulder)
{
  const BoreSurface     bore = make_bore(depth, shoulder);
  const Eigen::MatrixXd C    = make_compliance();
  ContactSolver         solver(bore, C, pin_radius);
  // One iteration is never enough: everything goes through the programme.
  ContactSolverParameters one_iteration;
  one_iteration.max_iterations     = 1;
  one_iteration.max_linearisations = 100;
  ContactSolver slow_solver(bore, C, pin_radius, one_iteration);

  std::cout << "depth " << 1e3 * depth << " mm, shoulder " << 1e3 * shoulder
            << " mm" << std::endl;
  for (const double force : {30., 300., 8000.})
    {
      const Eigen::Vector2d f    = at_angle(force, 0.123);
      const auto            free = solver.solve_force_controlled(f);
      const auto fixed = solver.solve_position_controlled(free.pin_centre);
      const auto slow  = slow_solver.solve_force_controlled(f);
      const auto slow_fixed =
        slow_solver.solve_position_controlled(free.pin_centre);
      const auto other =
        solver.solve_force_controlled(at_angle(2. * force, 0.5));
      const auto warm = solver.solve_force_controlled(f, &other);
      const auto warm_fixed =
        solver.solve_position_controlled(free.pin_centre, &other);
      std::cout << "  force " << force << ": converged "
                << free.report.converged << fixed.report.converged
                << slow.report.converged << slow_fixed.report.converged
                << warm.report.converged << warm_fixed.report.converged
                << ", nodes in contact " << free.active_set.size()
                << ", half-angle "
                << 180. / M_PI * free.half_angle
                // What is asked of the iteration is 1e-12; the stiffness of
                // some 1e9 N/m^2 then turns a rounding of the gap (1e-18 m)
                // into 1e-9 N/m.
                << ", conditions "
                << (violation(free, bore, C, f) < 1e-10 &&
                    violation(slow, bore, C, f) < 1e-10 &&
                    violation(fixed, bore, C, f) < 1e-9)
                << ", programme "
                << (difference(free, slow) < 1e-9 &&
                    difference(fixed, slow_fixed) < 1e-9)
                << ", position = force " << (difference(free, fixed) < 1e-9)
                << ", warm = cold "
                << (difference(free, warm) < 1e-10 &&
                    difference(fixed, warm_fixed) < 1e-9)
                << std::endl;
    }
}

/// 72 directions, twice around, from a warm start: iterations and deviations.
void
check_directions(const double depth, const double shoulder)
{
  const BoreSurface     bore = make_bore(depth, shoulder);
  const Eigen::MatrixXd C    = make_compliance();
  ContactSolver         solver(bore, C, pin_radius);
  ContactSolution       s = solver.solve_force_controlled(at_angle(1000., 0.));
  double                worst = 0., spread = 0.;
  const double          pressure = s.pressure.maxCoeff();
  unsigned int          n_failed = 0;
  for (unsigned int k = 1; k <= 144; ++k)
    {
      const Eigen::Vector2d f = at_angle(1000., 2. * M_PI * k / 72);
      s                       = solver.solve_force_controlled(f, &s);
      n_failed += !s.report.converged;
      worst = std::max({worst,
                        violation(s, bore, C, f),
                        difference(s, solver.solve_force_controlled(f))});
      spread =
        std::max(spread, std::abs(s.pressure.maxCoeff() / pressure - 1.));
    }
  std::cout << "sweep at depth " << 1e3 * depth << " mm: failed " << n_failed
            << ", conditions and cold start " << (worst < 1e-10);
  if (depth == 0.)
    std::cout << ", same for all directions " << (spread < 1e-9);
  std::cout << std::endl;
}

/// Through a node, from starts all around, by Newton's iteration and by the
/// programme: a force through a node leaves its neighbours with nothing when
/// two nodes carry it.
void
check_far_starts()
{
  const BoreSurface       bore = make_bore(0.);
  const Eigen::MatrixXd   C    = make_compliance();
  ContactSolver           solver(bore, C, pin_radius);
  ContactSolverParameters one_iteration;
  one_iteration.max_iterations = 1;
  ContactSolver slow_solver(bore, C, pin_radius, one_iteration);

  const Eigen::Vector2d f     = at_angle(1000., 0.);
  const auto            s     = solver.solve_force_controlled(f);
  unsigned int          n_bad = 0;
  for (unsigned int k = 0; k < 36; ++k)
    {
      const auto start =
        solver.solve_force_controlled(at_angle(500., 2. * M_PI * k / 36));
      const auto warm = solver.solve_force_controlled(f, &start);
      n_bad += !warm.report.converged || !(difference(warm, s) < 1e-10);
    }
  const auto slow = slow_solver.solve_force_controlled(f);
  std::cout << "force through a node: failed from " << n_bad
            << " of 36 starts, programme "
            << (slow.report.converged && difference(slow, s) < 1e-9)
            << std::endl;
}

void
check_extremes()
{
  const BoreSurface     bore = make_bore(0.);
  const Eigen::MatrixXd C    = make_compliance();
  ContactSolver         solver(bore, C, pin_radius);

  const auto zero = solver.solve_force_controlled(Eigen::Vector2d::Zero());
  const auto open = solver.solve_position_controlled({5e-6, 0.});
  std::cout << "zero force: converged " << zero.report.converged << ", force "
            << zero.force.norm() << ", gap " << 1e6 * zero.gap.minCoeff()
            << " um, half-angle " << zero.half_angle << ", peak "
            << peak_pressure(zero, bore)
            << "; pin in the open: " << open.report.converged
            << open.active_set.empty() << ", gap " << 1e6 * open.gap.minCoeff()
            << " um" << std::endl;

  // A stiff bore is a polygon of gaps: with the pin in the corner between the
  // nodes at 7 and 8 degrees, the lever rule divides the force.
  const double a = 7. * M_PI / 180., b = 8. * M_PI / 180., angle = 0.1295;
  unsigned int n_right = 0;
  for (const double force : {1e-12, 1e-9, 1e-6, 1e-3})
    {
      const Eigen::Vector2d f = at_angle(force, angle);
      const auto            s = solver.solve_force_controlled(f);
      const double share      = std::sin(b - angle) / std::sin(b - a) * force;
      // The directions of the gap differ from the angles of the nodes by the
      // clearance over the radius, 1e-3, times the half spacing.
      n_right += s.report.converged && s.active_set.size() == 2 &&
                 std::abs(s.nodal_force[7] / share - 1.) < 1e-2 &&
                 violation(s, bore, C, f) < 1e-10;
    }
  // Through a node: on that one alone, or on it and a neighbour that carries
  // next to nothing.
  for (const double force : {1e-12, 1e-8, 1e-4, 0.1})
    {
      const Eigen::Vector2d f = force * bore.positions.col(45).normalized();
      const auto            s = solver.solve_force_controlled(f);
      n_right += s.report.converged && violation(s, bore, C, f) < 1e-10 &&
                 std::abs(s.nodal_force[45] / force - 1.) < 1e-3;
    }
  std::cout << "tiny forces: right " << n_right << " of 8" << std::endl;

  for (const double force : {1e6, 1e20})
    {
      const auto s = solver.solve_force_controlled(at_angle(force, angle));
      std::cout << "force " << std::scientific << std::setprecision(0) << force
                << std::fixed << std::setprecision(2) << ": converged "
                << s.report.converged << " " << s.report.message << std::endl;
    }
}

/// Half-angle and peak of pressures and gaps that are known (Hertz).
void
check_reading()
{
  const BoreSurface bore = make_bore(0.);
  for (const double half_angle : {2.2, 20.3, 20.8, 170.6})
    {
      ContactSolution s;
      s.pressure = Eigen::VectorXd::Zero(n_nodes);
      s.gap      = Eigen::VectorXd::Zero(n_nodes);
      for (Eigen::Index i = 0; i < n_nodes; ++i)
        {
          // Centred between two nodes.
          const double angle = std::remainder(i - 180.5, 360.) / half_angle;
          s.pressure[i]      = std::sqrt(std::max(0., 1. - angle * angle));
          if (s.pressure[i] > 0.)
            s.active_set.push_back(i);
          else
            s.gap[i] = std::abs(angle) * std::sqrt(angle * angle - 1.) -
                       std::acosh(std::abs(angle));
        }
      const double peak                = peak_pressure(s, bore);
      s.pressure[s.active_set.front()] = 3.;
      std::cout << "contact of " << half_angle << " deg read as "
                << 180. / M_PI * contact_half_angle(s, bore) << ", peak "
                << peak << ", with a spike at the edge "
                << peak_pressure(s, bore) << std::endl;
    }
}

// The bore is moved along its radii: the gaps change by as much, to the cosine
// between radius and gap gradient (1e-5 off here), and so do the forces.
void
test_sensitivity(const Eigen::MatrixXd &C)
{
  const double          step = 1e-10;
  const Eigen::Vector2d force(8000., 3000.);
  const auto            solve = [&](const double moved) {
    Eigen::Matrix2Xd positions = make_bore(0.).positions;
    for (Eigen::Index i = 0; i < n_nodes; ++i)
      positions.col(i) *=
        1. + moved * std::sin(0.1 * i) / positions.col(i).norm();
    ContactSolver solver(make_bore_surface(positions, 1), C, pin_radius);
    return solver.solve_force_controlled(force);
  };
  const ContactSolution plus = solve(step), minus = solve(-step),
                        middle = solve(0.);

  Eigen::MatrixXd        sensitivity = Eigen::MatrixXd::Zero(n_nodes, n_nodes);
  const Eigen::Matrix2Xd positions   = make_bore(0.).positions;
  sensitivity(middle.active_set, middle.active_set) -=
    ForceSensitivity(positions, C, pin_radius).compute(middle);
  Eigen::VectorXd gap_change(n_nodes);
  for (Eigen::Index i = 0; i < n_nodes; ++i)
    gap_change[i] = std::sin(0.1 * i);

  const Eigen::VectorXd difference =
    (plus.nodal_force - minus.nodal_force) / (2. * step);
  const Eigen::VectorXd predicted = sensitivity * gap_change;
  std::cout << "sensitivity: same active set "
            << (plus.active_set == minus.active_set) << ", right to 1e-3: "
            << ((predicted - difference).norm() < 1e-3 * difference.norm())
            << ", symmetric: "
            << ((sensitivity - sensitivity.transpose()).norm() <
                1e-10 * sensitivity.norm())
            << std::endl;
}



int
main()
{
  std::cout << std::fixed << std::setprecision(2);
  check_bore(0., 0.);
  check_directions(0., 0.);
  for (const double shoulder : {5e-6, 30e-6})
    {
      check_bore(0.3e-3, shoulder);
      check_directions(0.3e-3, shoulder);
    }
  check_far_starts();
  check_extremes();
  check_reading();
  test_sensitivity(make_compliance());
}

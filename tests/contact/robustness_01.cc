// SPDX-License-Identifier: LGPL-2.1-or-later

// The contact solver at its limits.
//
// Cycling: on compliances that are random, symmetric and positive definite,
// with few large eigenvalues, the plain active-set iteration comes back to sets
// it has seen (how often, is counted by an iteration written here). The solver
// must converge all the same, with the pin given and under a force. Its answers
// are held against the conditions of contact, which single out the solution of
// a convex programme, and with the pin given against projected Gauss-Seidel
// iterations, which share nothing with it.
//
// A pin that is larger than the bore by d is pressed all around the hole of a
// plate: p = 2 mu d/R (Lame), under no force and to first order under a
// small one. No clearance: no contact without force, and under 1e-12 N the
// same shares of the force as under 1 N, to 1e-6. 1e9 N on a bushing of
// plastic: no solution, and the report says why.
//
// A compliance must be symmetric; what an iterative solver leaves of it is not
// quite. The factor takes the lower half of each pair of nodes, c (1 u; l 1),
// for both halves. So what one iteration leaves of the gaps, the next one
// multiplies by -l (u - l)/(1 - l^2). Little asymmetry costs a few iterations
// (l = 0.5, u = 0.501: a factor of 7e-4, five of them to 1e-12). With l = 0.5
// and u = -0.9 the factor is 0.93: the iteration stands still, all nodes
// pressed, with gaps as large as what the bore yields. That is no solution,
// with the pin given or under a force, and the report must say so, and how
// large the gaps are.

#include <tribody/contact/contact_solver.h>
#include <tribody/contact/pin_gap.h>
#include <tribody/elasticity/pressure_models.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <random>
#include <set>
#include <string>

using namespace Tribody;
using namespace Tribody::Contact;

constexpr double R = 10e-3;

BoreSurface
make_bore(const Eigen::VectorXd &radii)
{
  const Eigen::Index n = radii.size();
  Eigen::Matrix2Xd   positions(2, n);
  for (Eigen::Index i = 0; i < n; ++i)
    positions.col(i) = radii[i] * Eigen::Vector2d(std::cos(2. * M_PI * i / n),
                                                  std::sin(2. * M_PI * i / n));
  return make_bore_surface(positions, 1);
}

/// Whether the plain iteration comes back to a set.
bool
plain_iteration_cycles(const Eigen::MatrixXd &C, const Eigen::VectorXd &gap)
{
  std::set<ActiveSet> visited;
  ActiveSet           active;
  for (Eigen::Index i = 0; i < gap.size(); ++i)
    if (gap[i] < 0.)
      active.push_back(i);
  while (visited.insert(active).second)
    {
      Eigen::VectorXd force = Eigen::VectorXd::Zero(gap.size());
      if (!active.empty())
        force(active) =
          -Eigen::LLT<Eigen::MatrixXd>(C(active, active)).solve(gap(active));
      const Eigen::VectorXd        open = gap + C * force;
      const std::set<Eigen::Index> held(active.begin(), active.end());
      ActiveSet                    next;
      for (Eigen::Index i = 0; i < gap.size(); ++i)
        if (held.count(i) > 0 ? force[i] > 0. : open[i] < -1e-17)
          next.push_back(i);
      if (next == active)
        return false;
      active = next;
    }
  return true;
}

Eigen::VectorXd
gauss_seidel(const Eigen::MatrixXd &C, const Eigen::VectorXd &gap)
{
  Eigen::VectorXd force = Eigen::VectorXd::Zero(gap.size());
  for (unsigned int sweep = 0; sweep < 100000; ++sweep)
    {
      double change = 0.;
      for (Eigen::Index i = 0; i < gap.size(); ++i)
        {
          const double next =
            std::max(0., force[i] - (gap[i] + C.row(i).dot(force)) / C(i, i));
          change   = std::max(change, std::abs(next - force[i]));
          force[i] = next;
        }
      if (change < 1e-13 * force.maxCoeff())
        break;
    }
  return force;
}

/// The largest violation of the conditions of contact, relative.
double
violation(const ContactSolution &s,
          const Eigen::MatrixXd &C,
          const Eigen::VectorXd &rigid_gap)
{
  const Eigen::VectorXd u   = C * s.nodal_force;
  const Eigen::VectorXd gap = rigid_gap + u;
  const double scale = std::max(u.maxCoeff(), rigid_gap.cwiseAbs().maxCoeff());
  return std::max({-gap.minCoeff() / scale,
                   -s.nodal_force.minCoeff() / s.nodal_force.maxCoeff(),
                   gap.cwiseProduct(s.nodal_force).cwiseAbs().maxCoeff() /
                     (scale * s.nodal_force.maxCoeff())});
}

void
check_random_problems()
{
  constexpr Eigen::Index n = 24, rank = 8;
  constexpr unsigned int n_problems = 300;
  std::mt19937           generator(1);
  // Not a distribution of the library, whose numbers are its own affair.
  const auto random = [&generator]() {
    return 2. * generator() / std::mt19937::max() - 1.;
  };
  unsigned int n_cycling = 0, n_position = 0, n_force = 0, n_same = 0,
               n_unsolved = 0;
  for (unsigned int k = 0; k < n_problems; ++k)
    {
      Eigen::MatrixXd A(n, rank);
      for (Eigen::Index i = 0; i < A.size(); ++i)
        A.data()[i] = random();
      const Eigen::MatrixXd C =
        1e-9 * (A * A.transpose() + 0.02 * Eigen::MatrixXd::Identity(n, n));
      Eigen::VectorXd radii(n);
      for (Eigen::Index i = 0; i < n; ++i)
        radii[i] = R + 20e-6 * random();
      const BoreSurface bore = make_bore(radii);
      ContactSolver     solver(bore, C, R);

      const Eigen::VectorXd gap(PinGap(bore.positions, {0., 0.}, R).gap);
      n_cycling += plain_iteration_cycles(C, gap);
      const auto fixed = solver.solve_position_controlled({0., 0.});
      n_position += fixed.report.converged && violation(fixed, C, gap) < 1e-9;
      n_same += (fixed.nodal_force - gauss_seidel(C, gap)).norm() <
                1e-6 * fixed.nodal_force.norm();

      const Eigen::Vector2d f(1e4 * random(), 1e4 * random());
      const auto            free = solver.solve_force_controlled(f);
      const PinGap          pin(bore.positions, free.pin_centre, R);
      n_unsolved += !free.report.converged;
      n_force += free.report.converged && violation(free, C, pin.gap) < 1e-9 &&
                 (pin.directions * free.nodal_force - f).norm() <
                   1e-10 * free.nodal_force.lpNorm<1>();
    }
  std::cout << n_problems << " random problems, the plain iteration cycles in "
            << n_cycling << ": pin given, solved " << n_position
            << ", as Gauss-Seidel " << n_same << "; under a force, solved "
            << n_force << ", reported as unsolved " << n_unsolved << std::endl;
}

void
check_limits()
{
  const Material               plastic{"plastic", 0.139e9, 0.38, 2160.};
  const Elasticity::PlaneHooke law(plastic, Elasticity::PlaneState::strain);
  const BoreSurface     bore = make_bore(Eigen::VectorXd::Constant(360, R));
  const Eigen::MatrixXd C =
    Elasticity::infinite_plate_compliance(bore, law, 1.6 * R);

  const double  interference = 10e-6;
  ContactSolver press(bore, C, R + interference);
  const double  pressure = 2. * law.mu * interference / R;
  for (const double force : {0., 1., 100.})
    {
      const auto s = press.solve_force_controlled({force, 0.});
      std::cout << "press fit, " << force << " N/m: converged "
                << s.report.converged << ", nodes in contact "
                << s.active_set.size() << ", half-angle "
                << 180. / M_PI * s.half_angle << " deg, mean pressure off by "
                << 100. * (s.pressure.mean() / pressure - 1.) << " %"
                << std::endl;
    }

  ContactSolver tight(bore, C, R);
  const auto    none = tight.solve_force_controlled({0., 0.});
  const auto    one  = tight.solve_force_controlled({1., 0.});
  std::cout << "no clearance: no force " << none.report.converged
            << none.active_set.size() << ", 1 N/m: converged "
            << one.report.converged << ", half-angle "
            << 180. / M_PI * one.half_angle << " deg" << std::endl;

  ContactSolver loose(bore, C, R - 10e-6);
  for (const double force : {1e-12, 1e9, 1e15})
    {
      const auto s = loose.solve_force_controlled({force, 0.});
      std::cout << "clearance 10 um, " << std::scientific
                << std::setprecision(0) << force << std::fixed
                << std::setprecision(2) << " N/m: converged "
                << s.report.converged << ", nodes in contact "
                << (s.report.converged ? s.active_set.size() : 0) << ' '
                << s.report.message << std::endl;
    }
}

/// Pairs of springs that are coupled by @p lower one way, @p upper the other.
Eigen::MatrixXd
make_pairs(const Eigen::Index n, const double lower, const double upper)
{
  Eigen::MatrixXd C = Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index i = 0; i < n; i += 2)
    {
      C(i, i + 1) = upper;
      C(i + 1, i) = lower;
    }
  return 1e-9 * C;
}

std::string
describe(const ContactSolution &s, const double violation)
{
  if (s.report.converged)
    return violation < 1e-11 ? "solved" : "TAKEN FOR SOLVED";
  if (s.report.stagnated && s.report.residual > 0.1 && violation > 0.1)
    return "stagnates: " + s.report.message;
  return "NOT SOLVED: " + s.report.message;
}

void
check_stagnation()
{
  constexpr Eigen::Index n     = 24;
  const double           tight = R + 10e-6;
  const BoreSurface      bore  = make_bore(Eigen::VectorXd::Constant(n, R));
  for (const double upper : {0.5, 0.501, -0.9})
    {
      const Eigen::MatrixXd C = make_pairs(n, 0.5, upper);
      ContactSolver         solver(bore, C, tight);
      const auto            fixed = solver.solve_position_controlled({0., 0.});
      const PinGap          pin(bore.positions, {0., 0.}, tight);
      std::cout << "pairs coupled by 0.5 and " << std::setprecision(3) << upper
                << std::setprecision(2) << ": "
                << describe(fixed, violation(fixed, C, pin.gap))
                << ", at most 6 iterations "
                << (fixed.report.n_iterations <= 6);
      const auto   free = solver.solve_force_controlled({1., 0.});
      const PinGap moved(bore.positions, free.pin_centre, tight);
      std::cout << "; under a force "
                << (free.report.converged
                      ? describe(free, violation(free, C, moved.gap))
                      : "not solved")
                << std::endl;
    }
}

int
main()
{
  std::cout << std::fixed << std::setprecision(2);
  check_random_problems();
  check_limits();
  check_stagnation();
}

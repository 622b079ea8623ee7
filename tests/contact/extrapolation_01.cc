// SPDX-License-Identifier: LGPL-2.1-or-later

// What the contact of a sequence is started from. Known:
// - Contacts whose ends move steadily, with forces like the root of the
//   distance to the nearer end and gaps like its power 3/2: extrapolated from
//   two of them, the nodes of the third are right, and so are, to rounding, the
//   shares of the force of those that have the same end nearer all the time,
//   however the load changes.
// - Where the contact begins, ends or jumps, nothing is extrapolated.
// - A load that turns steadily in a round bore turns the contact with it. On
//   any mesh the nodes that are extrapolated are right but for one at each end.
//   So the iterations do not grow with the mesh; from the contact before they
//   do, as an iteration moves an end by some nodes only.
// - Where the solver starts from does not matter: both leave a residual of
//   1e-12 and a compliance of a condition of 1e3 turns it into 1e-9.

#include <tribody/contact/contact_solver.h>
#include <tribody/elasticity/pressure_models.h>
#include <tribody/material/material.h>
#include <tribody/surface/bore_surface.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <utility>

using namespace Tribody;
using namespace Tribody::Contact;

/// Between two ends, with a load that the forces are proportional to.
ContactSolution
make_contact(const double begin, const double end, const double load)
{
  constexpr Eigen::Index n = 100;
  ContactSolution        solution;
  solution.nodal_force.setZero(n);
  solution.gap.setZero(n);
  for (Eigen::Index i = 0; i < n; ++i)
    {
      const double inside = std::min(i - begin, end - i);
      if (inside > 0.)
        {
          solution.nodal_force[i] = load * std::sqrt(inside);
          solution.active_set.push_back(i);
        }
      else
        solution.gap[i] = std::pow(-inside, 1.5);
    }
  return solution;
}

void
test_steady_ends()
{
  bool         nodes_are_right = true;
  double       largest         = 0.;
  unsigned int n_compared      = 0;
  for (const double speed : {1., 2., -3.})
    for (const double growth : {0.4, 1., 3.})
      {
        const auto contact = [&](const double time) {
          return make_contact(30.1 + speed * time,
                              60.2 + speed * time,
                              std::pow(growth, time));
        };
        const auto before = contact(0.), next = contact(2.);
        const auto extrapolated = extrapolate(before, contact(1.));
        nodes_are_right =
          nodes_are_right && extrapolated.active_set == next.active_set;
        // In the first half the same end is the nearer one all the time.
        for (Eigen::Index i = 0; i < 38; ++i)
          if (before.nodal_force[i] > 0. && next.nodal_force[i] > 0.)
            {
              ++n_compared;
              largest = std::max(largest,
                                 std::abs(growth * extrapolated.nodal_force[i] /
                                            next.nodal_force[i] -
                                          1.));
            }
      }
  std::cout << "steady ends: nodes are right: " << nodes_are_right
            << ", shares of the force of " << n_compared
            << " nodes to 1e-13: " << (largest < 1e-13) << '\n';
}

void
test_jumps()
{
  const auto here   = make_contact(30.1, 60.2, 1.);
  const auto open   = make_contact(0., 0., 1.);
  const auto turned = make_contact(40.1, 70.2, 1.);
  std::cout << "jumps: contact as before: ";
  for (const auto &[before, last] :
       {std::pair(open, here), std::pair(here, open), std::pair(here, turned)})
    {
      const auto next = extrapolate(before, last);
      std::cout << (next.active_set == last.active_set &&
                    next.nodal_force == last.nodal_force &&
                    next.pin_centre == last.pin_centre);
    }
  std::cout << '\n';
}

void
test_turning_load(const Eigen::Index n_nodes)
{
  constexpr double       R = 10e-3, clearance = 20e-6, force = 50e3;
  constexpr unsigned int n_samples = 50;
  Eigen::Matrix2Xd       positions(2, n_nodes);
  for (Eigen::Index i = 0; i < n_nodes; ++i)
    {
      const double angle = 2. * M_PI * i / n_nodes;
      positions.col(i) = R * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
  const BoreSurface surface = make_bore_surface(positions, 1);
  const Material    plastic{"plastic", 2e9, 0.38};
  ContactSolver     solver(surface,
                       Elasticity::infinite_plate_compliance(
                         surface,
                         {plastic, Elasticity::PlaneState::strain},
                         10. * R),
                       R - clearance);
  const auto        load = [](const unsigned int j) {
    const double angle = 0.3 + j * M_PI / 50.;
    return Eigen::Vector2d(force * std::cos(angle), force * std::sin(angle));
  };

  auto         before       = solver.solve_force_controlled(load(0));
  auto         last         = solver.solve_force_controlled(load(1), &before);
  std::size_t  most_wrong   = 0;
  unsigned int n_iterations = 0, n_before = 0;
  double       largest = 0.;
  for (unsigned int j = 2; j < 2 + n_samples; ++j)
    {
      const auto start = extrapolate(before, last);
      const auto next  = solver.solve_force_controlled(load(j), &start);
      const auto plain = solver.solve_force_controlled(load(j), &last);
      const auto fresh = solver.solve_force_controlled(load(j));
      ActiveSet  wrong;
      std::set_symmetric_difference(start.active_set.begin(),
                                    start.active_set.end(),
                                    next.active_set.begin(),
                                    next.active_set.end(),
                                    std::back_inserter(wrong));
      most_wrong = std::max(most_wrong, wrong.size());
      n_iterations += next.report.n_iterations;
      n_before += plain.report.n_iterations;
      largest = std::max(largest,
                         (next.nodal_force - fresh.nodal_force).norm() /
                           fresh.nodal_force.norm());
      before  = last;
      last    = next;
    }
  // Newton's method needs two or three iterations for the place of the pin.
  std::cout << n_nodes << " nodes, " << last.active_set.size()
            << " in contact: at most two wrong: " << (most_wrong <= 2)
            << ", at most three iterations each, on the average: "
            << (n_iterations <= 3 * n_samples)
            << ", no more than from the contact before: "
            << (n_iterations <= n_before)
            << ", difference from a fresh start below 1e-9: "
            << (largest < 1e-9) << '\n';
}

int
main()
{
  test_steady_ends();
  test_jumps();
  for (const Eigen::Index n_nodes : {90, 180, 360, 720})
    test_turning_load(n_nodes);
}

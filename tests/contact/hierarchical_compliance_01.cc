// SPDX-License-Identifier: LGPL-2.1-or-later

// The compliance as a tree of arcs. Known:
// - C_A^-1 times anything is what a dense factor gives, on a bore (scaled by up
//   to 1.4, so that it is not the same everywhere) and on a free ring with bore
//   and rim, for any set: parts of one arc or of several, whole arcs only,
//   loose nodes only, with holes, across the first node; after a set with other
//   whole arcs or with the same ones. The accuracy is 1e-12, the condition of
//   C_A up to 3e3, of which the errors show little: 1e-11 is allowed. Where
//   arcs do nothing to each other (skeletons of no nodes) or a number does it
//   all (of one) the sums are short: 1e-13.
// - A matrix that is not positive definite is not solved with.
// - ActiveCompliance gives the same when the sets grow and shrink across the
//   number of nodes from which it uses the tree, and after refresh(); and so
//   does the inverse, which is followed.
// - Contacts of 500 nodes are solved with it: all conditions hold to 1e-11 (the
//   solver's tolerance is 1e-12, the rest is for what the test itself rounds),
//   and as with exact inverses two iterations are enough for most of the forces
//   of a cycle of 200 that are extrapolated. A pin too large for a ring in a
//   housing presses all corners of cells at the bore alike, and at the rim
//   (Lame), by the mesh's symmetry to the tolerance times the condition.

#include <deal.II/base/mpi.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>

#include <tribody/algebra/hierarchical_compliance.h>
#include <tribody/contact/contact_solver.h>
#include <tribody/elasticity/bushing_elasticity.h>
#include <tribody/elasticity/ring_mesh.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace Tribody;
using namespace Tribody::Contact;

constexpr double       a = 9.535e-3, b = 15.875e-3, pin_radius = 9.525e-3;
constexpr unsigned int degree = 2;

struct Bushing
{
  explicit Bushing(const unsigned int            n_nodes,
                   const Elasticity::RimSupport &support = {})
  {
    Elasticity::make_ring_mesh({n_nodes / degree, 6, 1.5}, a, b, triangulation);
    elasticity = std::make_unique<Elasticity::BushingElasticity>(
      triangulation,
      degree,
      Material{"PTFE", 0.139e9, 0.38, 2160.},
      Elasticity::PlaneState::strain,
      support);
    elasticity->reinit(dealii::MappingQ<2>(degree));
    bore = make_bore_surface(elasticity->bore_nodes().positions, degree);
  }

  Eigen::MatrixXd
  compliance() const
  {
    return elasticity->normal_compliance(bore.normals,
                                         Elasticity::RingSymmetry::cells_alike);
  }

  dealii::Triangulation<2>                       triangulation;
  std::unique_ptr<Elasticity::BushingElasticity> elasticity;
  BoreSurface                                    bore;
};

/// Nodes of ranges that are counted around, so that they may exceed @p n.
ActiveSet
collect(const std::vector<std::pair<int, int>> &ranges, const int n)
{
  ActiveSet nodes;
  for (const auto &[begin, end] : ranges)
    for (int i = begin; i < end; ++i)
      nodes.push_back(i % n);
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

Eigen::MatrixXd
random_columns(const Eigen::Index n_rows)
{
  static std::mt19937                    generator(1);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  return Eigen::MatrixXd::NullaryExpr(n_rows, 3, [&]() {
    return uniform(generator);
  });
}

Eigen::MatrixXd
solve_dense(const Eigen::MatrixXd &C,
            const ActiveSet       &nodes,
            const Eigen::MatrixXd &right_hand_sides)
{
  return Eigen::LLT<Eigen::MatrixXd>(C(nodes, nodes)).solve(right_hand_sides);
}

void
test_solve(const std::string     &name,
           const Eigen::MatrixXd &C,
           const double           allowed)
{
  const HierarchicalCompliance                        tree(C);
  HierarchicalCompliance::Restriction                 restriction;
  const int                                           n = C.rows();
  const std::vector<std::vector<std::pair<int, int>>> sets{
    {{3 * n / 8 + 5, 5 * n / 8 - 3}},
    {{3 * n / 8 + 8, 5 * n / 8}},
    {{3 * n / 8 + 8, 5 * n / 8 + 1}},
    {{n / 2, 5 * n / 8}},
    {{n / 2, 6 * n / 8}},
    {{n - n / 9, n + n / 5}},
    {{10, n / 4}, {n / 4 + 1, n / 2 - 7}},
    {{n / 3, n / 3 + 1}},
    {{0, n - 1}},
    {{0, n}}};
  std::cout << name << ", relative errors below " << allowed << ':';
  for (const auto &ranges : sets)
    {
      const ActiveSet       nodes     = collect(ranges, n);
      const Eigen::MatrixXd rhs       = random_columns(nodes.size());
      const bool            can_solve = tree.restrict_to(nodes, restriction);
      const Eigen::MatrixXd exact     = solve_dense(C, nodes, rhs);
      const double          error =
        (tree.solve(restriction, rhs) - exact).norm() / exact.norm();
      std::cout << ' ' << (can_solve && error < allowed);
    }
  std::cout << '\n';
}

void
test_indefinite()
{
  Eigen::MatrixXd C = Eigen::MatrixXd::Identity(512, 512);
  C(100, 100)       = -1.;
  const HierarchicalCompliance        tree(C);
  HierarchicalCompliance::Restriction restriction;
  std::cout << "indefinite: solved with "
            << tree.restrict_to(collect({{0, 200}}, 512), restriction)
            << ", without what makes it so "
            << tree.restrict_to(collect({{101, 300}}, 512), restriction)
            << '\n';
}

void
test_active_compliance(const Eigen::MatrixXd &C)
{
  const int        n = C.rows();
  ActiveCompliance active(C), inverted(C, ActiveCompliance::Use::inverse);
  double           largest = 0.;
  for (const int end : {390, 398, 405, 410, 404, 396, 380, 420})
    {
      const ActiveSet       nodes = collect({{5, end}}, n);
      const Eigen::MatrixXd rhs   = random_columns(nodes.size());
      const Eigen::MatrixXd exact = solve_dense(C, nodes, rhs);
      active.update(nodes, /*small changes = */ true);
      inverted.update(nodes, /*small changes = */ true);
      for (const Eigen::MatrixXd &x :
           {active.solve(rhs),
            Eigen::MatrixXd(inverted.compute_inverse() * rhs)})
        largest = std::max(largest, (x - exact).norm() / exact.norm());
      if (end == 410)
        {
          const bool is_different = active.refresh();
          std::cout << "refreshed: " << is_different
                    << ", only once: " << !active.refresh();
          largest = std::max(largest,
                             (active.solve(rhs) - exact).norm() / exact.norm());
        }
    }
  std::cout << ", errors below 1e-11: " << (largest < 1e-11) << '\n';
}

void
test_contact()
{
  const Bushing         bushing(1440);
  const Eigen::MatrixXd C = bushing.compliance();
  ContactSolver         solver(bushing.bore, C, pin_radius);
  ContactSolution       before, s;
  std::size_t           fewest_nodes = C.rows();
  double                violation    = 0.;
  unsigned int          n_iterations = 0;
  const unsigned int    n_samples    = 20;
  for (unsigned int j = 0; j < n_samples + 2; ++j)
    {
      const double          phase = 2. * M_PI * j / 200;
      const Eigen::Vector2d force =
        (75. + 25. * std::cos(phase)) / 13.1e-3 *
        Eigen::Vector2d(std::cos(phase), std::sin(phase));
      const ContactSolution start = j < 2 ? s : extrapolate(before, s);
      before                      = std::move(s);
      s = solver.solve_force_controlled(force, j == 0 ? nullptr : &start);
      if (j >= 2)
        n_iterations += s.report.n_iterations;
      fewest_nodes = std::min(fewest_nodes, s.active_set.size());

      const PinGap pin(bushing.bore.positions, s.pin_centre, pin_radius);
      const Eigen::VectorXd yielding = C * s.nodal_force;
      const Eigen::VectorXd gap      = pin.gap + yielding;
      const double          scale    = yielding.maxCoeff();
      for (const double x :
           {-gap.minCoeff() / scale,
            (gap - s.gap).cwiseAbs().maxCoeff() / scale,
            gap(s.active_set).cwiseAbs().maxCoeff() / scale,
            -s.nodal_force.minCoeff() / s.nodal_force.maxCoeff(),
            (pin.directions * s.nodal_force - force).norm() / force.norm()})
        violation = std::max(violation, x);
    }
  std::cout << "contact: at least 480 nodes: " << (fewest_nodes >= 480)
            << ", violations below 1e-11: " << (violation < 1e-11)
            << ", at most 2.2 iterations: " << (n_iterations <= 2.2 * n_samples)
            << '\n';
}

void
test_tight_pin()
{
  const Bushing ring(480, {Elasticity::RimSupport::Kind::housing, 0., 0., 0.});
  ContactSolver solver(
    ring.bore,
    ring.elasticity->bore_and_rim_compliance(ring.bore.normals, MPI_COMM_SELF),
    1.001 * a,
    {},
    Housing{ring.elasticity->rim_surface(), b});
  ContactSolution s      = solver.solve_force_controlled({0., 0.});
  const auto      spread = [](const Eigen::VectorXd &p) {
    const auto corners = Eigen::seqN(0, p.size() / degree, degree);
    return p(corners).maxCoeff() / p(corners).minCoeff() - 1.;
  };
  std::cout << "tight pin: converged " << s.report.converged << ", nodes "
            << s.active_set.size() << " and " << s.rim.active_set.size()
            << ", pressures alike to 1e-8: "
            << (std::max(spread(s.pressure), spread(s.rim.pressure)) < 1e-8)
            << '\n';
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Eigen::VectorXd scale =
    1.2 + 0.2 * Eigen::ArrayXd::LinSpaced(720, 0., 2. * M_PI).cos();
  const Eigen::MatrixXd uneven =
    scale.asDiagonal() * Bushing(720).compliance() * scale.asDiagonal();
  test_solve("uneven bore", uneven, 1e-11);

  const Bushing ring(240, {Elasticity::RimSupport::Kind::housing, 0., 0., 0.});
  test_solve("ring in a housing",
             ring.elasticity->bore_and_rim_compliance(ring.bore.normals,
                                                      MPI_COMM_SELF),
             1e-11);
  const Eigen::MatrixXd springs = Eigen::MatrixXd::Identity(520, 520);
  test_solve("springs", springs, 1e-13);
  test_solve("springs in series with one",
             springs + Eigen::MatrixXd::Ones(520, 520),
             1e-13);
  test_solve("few nodes", uneven.topLeftCorner(63, 63), 1e-11);
  test_indefinite();
  test_active_compliance(uneven);
  test_contact();
  test_tight_pin();
}

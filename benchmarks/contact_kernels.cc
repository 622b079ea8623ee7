// SPDX-License-Identifier: LGPL-2.1-or-later

// How long contact takes on the validation joint (a rigid pin of 9.525 mm in a
// bushing of 9.535 mm, rim 15.875 mm, E = 0.139 GPa, nu = 0.38, plane strain,
// 13.1 mm long), by the number of bore nodes:
//
//   compliance_unworn  stiffness, its factor and the compliance of a round ring
//   compliance_worn    the same of a worn one, all columns
//   hierarchy          what many nodes in contact are solved with, prepared
//   force_cold         one force of 100 N, without a start
//   force_warm         per sample of a cycle of 200 that turns once around with
//                      a force of 50 to 100 N, each started from the two before
//   position_cold, position_warm  the same with the pin's centre given
//   uncondensed        100 N with the active set on the whole mesh
//
// Counters: peak pressure [MPa] of 100 N, Newton iterations per sample.

#include <deal.II/base/mpi.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>

#include <benchmark/benchmark.h>
#include <support/uncondensed_contact.h>

#include <tribody/contact/contact_solver.h>
#include <tribody/elasticity/bushing_elasticity.h>
#include <tribody/elasticity/ring_mesh.h>
#include <tribody/geometry/worn_configuration.h>

#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <utility>

using namespace Tribody;

namespace
{
  constexpr double bore_radius = 9.535e-3, pin_radius = 9.525e-3,
                   rim_radius = 15.875e-3, axial_length = 13.1e-3;
  constexpr unsigned int degree    = 2;
  constexpr unsigned int n_samples = 200;

  /// A bushing and its compliance.
  struct Joint
  {
    Joint(const unsigned int n_nodes, const double depth)
    {
      Elasticity::RingMeshParameters mesh;
      mesh.n_bore_cells = n_nodes / degree;
      Elasticity::make_ring_mesh(mesh, bore_radius, rim_radius, triangulation);
      geometry = std::make_unique<Geometry::WornConfiguration>(triangulation,
                                                               degree,
                                                               "joint");
      geometry->update(
        (depth * geometry->bore_nodes().angles.array().cos()).max(0.));
      elasticity = std::make_unique<Elasticity::BushingElasticity>(
        triangulation,
        degree,
        Material{"PTFE", 0.139e9, 0.38, 2160.},
        Elasticity::PlaneState::strain);
      surface  = make_bore_surface(geometry->worn_positions(), degree);
      symmetry = (depth == 0.) ? Elasticity::RingSymmetry::cells_alike
                               : Elasticity::RingSymmetry::none;
      compute_compliance();
    }

    void
    compute_compliance()
    {
      elasticity->reinit(geometry->mapping());
      compliance = elasticity->normal_compliance(surface.normals, symmetry);
    }

    dealii::Triangulation<2>                       triangulation;
    std::unique_ptr<Geometry::WornConfiguration>   geometry;
    std::unique_ptr<Elasticity::BushingElasticity> elasticity;
    BoreSurface                                    surface;
    Elasticity::RingSymmetry                       symmetry;
    Contact::Compliance                            compliance;
  };

  Joint &
  round_joint(const unsigned int n_nodes)
  {
    static std::map<unsigned int, Joint> joints;
    Joint &joint = joints.try_emplace(n_nodes, n_nodes, 0.).first->second;
    // Prepared once for all contacts: see hierarchy.
    joint.compliance.hierarchy();
    return joint;
  }

  Eigen::Vector2d
  force(const double newtons, const double angle)
  {
    return newtons / axial_length *
           Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }

  Eigen::Vector2d
  force_of_sample(const unsigned int j)
  {
    const double phase = 2. * M_PI * j / n_samples;
    return force(75. + 25. * std::cos(phase), phase);
  }

  void
  compliance(benchmark::State &state, const double depth)
  {
    Joint joint(state.range(0), depth);
    for (auto _ : state)
      joint.compute_compliance();
  }

  void
  hierarchy(benchmark::State &state)
  {
    const Joint &joint = round_joint(state.range(0));
    for (auto _ : state)
      benchmark::DoNotOptimize(
        HierarchicalCompliance(joint.compliance.matrix()));
  }

  void
  force_cold(benchmark::State &state)
  {
    const Joint           &joint = round_joint(state.range(0));
    Contact::ContactSolver solver(joint.surface, joint.compliance, pin_radius);
    Contact::ContactSolution s;
    for (auto _ : state)
      {
        s = solver.solve_force_controlled(force(100., 0.3));
        // Another one, so that the factor at hand does not fit.
        state.PauseTiming();
        solver.solve_force_controlled(force(100., 3.));
        state.ResumeTiming();
      }
    state.counters["peak_MPa"] =
      1e-6 * Contact::peak_pressure(s, joint.surface);
    state.counters["iterations"] = s.report.n_iterations;
  }

  void
  force_warm(benchmark::State &state)
  {
    const Joint           &joint = round_joint(state.range(0));
    Contact::ContactSolver solver(joint.surface, joint.compliance, pin_radius);
    Contact::ContactSolution before =
      solver.solve_force_controlled(force_of_sample(0));
    Contact::ContactSolution s =
      solver.solve_force_controlled(force_of_sample(1), &before);
    unsigned int j = 1, n_iterations = 0;
    const auto   solve_next = [&]() {
      const auto start = Contact::extrapolate(before, s);
      before           = std::move(s);
      s = solver.solve_force_controlled(force_of_sample(++j), &start);
      n_iterations += s.report.n_iterations;
    };
    // What is followed from then on is set up with the first of them.
    solve_next();
    for (auto _ : state)
      solve_next();
    state.counters["peak_MPa"] =
      1e-6 * Contact::peak_pressure(
               solver.solve_force_controlled(force_of_sample(n_samples), &s),
               joint.surface);
    state.counters["iterations"] = static_cast<double>(n_iterations) / (j - 1);
  }

  void
  position(benchmark::State &state, const bool warm)
  {
    const Joint           &joint = round_joint(state.range(0));
    Contact::ContactSolver solver(joint.surface, joint.compliance, pin_radius);
    std::vector<Eigen::Vector2d> centres;
    Contact::ContactSolution     s =
      solver.solve_force_controlled(force_of_sample(0));
    for (unsigned int j = 0; j < n_samples; ++j)
      {
        s = solver.solve_force_controlled(force_of_sample(j), &s);
        centres.push_back(s.pin_centre);
      }
    Contact::ContactSolution before = s;
    unsigned int             j = 0, n_iterations = 0;
    for (auto _ : state)
      {
        const auto start = Contact::extrapolate(before, s);
        before           = std::move(s);
        s = solver.solve_position_controlled(centres[++j % n_samples],
                                             warm ? &start : nullptr);
        n_iterations += s.report.n_iterations;
      }
    state.counters["iterations"] = static_cast<double>(n_iterations) / j;
  }

  void
  uncondensed(benchmark::State &state)
  {
    const Joint             &joint = round_joint(state.range(0));
    Contact::ContactSolution s;
    for (auto _ : state)
      s = Coupling::solve_uncondensed_contact(*joint.elasticity,
                                              joint.surface,
                                              pin_radius,
                                              force(100., 0.3));
    state.counters["peak_MPa"] =
      1e-6 * Contact::peak_pressure(s, joint.surface);
    state.counters["iterations"] = s.report.n_iterations;
  }

  /// For others to solve on: doubles, the number of nodes n, then positions (x,
  /// y of each node), normals, weights, and the compliance.
  void
  write_compliance(const std::string &file_name, const unsigned int n_nodes)
  {
    const Joint  &joint = round_joint(n_nodes);
    const double  n     = n_nodes;
    std::ofstream file(file_name, std::ios::binary);
    const auto    write = [&](const double *values, const Eigen::Index size) {
      file.write(reinterpret_cast<const char *>(values), size * sizeof(double));
    };
    write(&n, 1);
    write(joint.surface.positions.data(), joint.surface.positions.size());
    write(joint.surface.normals.data(), joint.surface.normals.size());
    write(joint.surface.weights.data(), joint.surface.weights.size());
    const Eigen::MatrixXd &C = joint.compliance.matrix();
    write(C.data(), C.size());
  }

  void
  bore_nodes(benchmark::internal::Benchmark *benchmark)
  {
    for (const int n : {180, 360, 720, 1440, 2880})
      benchmark->Arg(n);
    benchmark->Unit(benchmark::kMillisecond);
  }
} // namespace

BENCHMARK_CAPTURE(compliance, unworn, 0.)->Apply(bore_nodes);
BENCHMARK_CAPTURE(compliance, worn, 0.3e-3)->Apply(bore_nodes);
BENCHMARK(hierarchy)->Apply(bore_nodes);
BENCHMARK(force_cold)->Apply(bore_nodes);
BENCHMARK(force_warm)->Apply(bore_nodes);
BENCHMARK_CAPTURE(position, cold, false)->Apply(bore_nodes);
BENCHMARK_CAPTURE(position, warm, true)->Apply(bore_nodes);
BENCHMARK(uncondensed)->Apply(bore_nodes);

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // One thread, as in the program.
  Eigen::setNbThreads(1);
  benchmark::Initialize(&argc, argv);
  // --write_compliance FILE NODES instead of measuring.
  if (argc == 4 && std::string(argv[1]) == "--write_compliance")
    write_compliance(argv[2], std::stoi(argv[3]));
  else
    benchmark::RunSpecifiedBenchmarks();
}

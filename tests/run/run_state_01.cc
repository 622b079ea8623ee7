// SPDX-License-Identifier: LGPL-2.1-or-later

// Where a run stands is one value. Known by construction, to the bit:
// - Two different cases that go on in turn in one process get what each gets
//   alone.
// - From a state that was copied in mid-run, the same simulation, gone on and
//   set back, and another one, which has come nowhere by itself, end where the
//   first one did: implicit steps, explicit ones, and with finite elements
//   inside the dynamics.
// The copy is taken after the compliance has been renewed and the profile has
// moved on, so that both lags are in it.

#include <deal.II/base/mpi.h>

#include <tribody/base/console.h>
#include <tribody/case/case_parameters.h>
#include <tribody/run/wear_simulation.h>

#include <algorithm>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

using namespace Tribody;
using namespace Tribody::Coupling;

namespace
{
  CaseParameters
  read(const std::vector<std::string> &overrides)
  {
    std::vector<std::string> all = {"Bushing crank_pin/Mesh/Bore cells=36"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    return read_case(std::string(SOURCE_DIR) + "/../../prm/quickstart.prm",
                     all);
  }



  struct Run
  {
    explicit Run(const CaseParameters &parameters)
      : console(screen)
      , end(parameters.cycles)
      , simulation(parameters, console, MPI_COMM_SELF)
    {}

    void
    go_on(const unsigned int n_steps)
    {
      for (unsigned int i = 0; i < n_steps && !simulation.is_over(); ++i)
        simulation.advance(
          std::min(end, simulation.state().cycles + 0.1 * end));
    }

    std::ostringstream screen;
    Console            console;
    double             end;
    WearSimulation     simulation;
  };



  constexpr unsigned int many = 1000;

  bool
  agree(const RunState &a, const RunState &b)
  {
    bool same = a.cycles == b.cycles && a.joints.size() == b.joints.size() &&
                a.counts.wear_steps == b.counts.wear_steps &&
                a.counts.rate_evaluations == b.counts.rate_evaluations &&
                a.counts.dynamics_cycles == b.counts.dynamics_cycles &&
                a.counts.compliance_builds == b.counts.compliance_builds;
    for (std::size_t j = 0; same && j < a.joints.size(); ++j)
      {
        const JointState &x = a.joints[j];
        const JointState &y = b.joints[j];

        same = x.depth == y.depth &&
               x.depth_at_compliance == y.depth_at_compliance &&
               x.depth_at_dynamics == y.depth_at_dynamics &&
               x.contact.peak_pressure == y.contact.peak_pressure &&
               x.totals.depth_error == y.totals.depth_error &&
               x.totals.sliding_distance == y.totals.sliding_distance &&
               a.duty_cycle.joints[j].normal_force ==
                 b.duty_cycle.joints[j].normal_force;
      }
    return same;
  }



  /// Whether compliance and motion are those of earlier depths, not of the
  /// unworn joint.
  bool
  both_lag(const RunState &state)
  {
    const JointState &joint    = state.joints[0];
    const auto        distance = [&joint](const Eigen::VectorXd &depth) {
      return (joint.depth.head(depth.size()) - depth).norm();
    };
    return state.counts.compliance_builds > 1 &&
           distance(joint.depth_at_compliance) > 0. &&
           state.cycles_at_dynamics > 0. &&
           state.cycles_at_dynamics < state.cycles;
  }



  RunState
  run_alone(const CaseParameters &parameters)
  {
    Run run(parameters);
    run.simulation.start();
    run.go_on(many);
    return run.simulation.state();
  }



  void
  test_interleaved()
  {
    const CaseParameters first = read({"Cycles=2000"});
    const CaseParameters second =
      read({"Cycles=300",
            "Wear/Extrapolation=constant",
            "Joint crank_pin/Friction coefficient=0.2",
            "Bushing crank_pin/Pin wear coefficient=1e-4 mm^3/(N m)"});
    Run a(first), b(second);
    a.simulation.start();
    b.simulation.start();
    while (!a.simulation.is_over() || !b.simulation.is_over())
      {
        a.go_on(1);
        b.go_on(1);
      }
    std::cout << "interleaved as alone: "
              << (agree(a.simulation.state(), run_alone(first)) &&
                  agree(b.simulation.state(), run_alone(second)))
              << std::endl;
  }



  void
  test_copy(const char *what, const std::vector<std::string> &overrides)
  {
    const CaseParameters parameters = read(overrides);
    Run                  run(parameters);
    run.simulation.start();
    while (!run.simulation.is_over() && !both_lag(run.simulation.state()))
      run.go_on(1);
    const RunState copy = run.simulation.state();
    run.go_on(many);
    const RunState end = run.simulation.state();

    run.simulation.restore(copy);
    run.go_on(many);
    Run other(parameters);
    other.simulation.restore(copy);
    other.go_on(many);
    std::cout << what << ": left something to do "
              << (end.counts.wear_steps > copy.counts.wear_steps)
              << ", set back " << agree(run.simulation.state(), end)
              << ", taken over " << agree(other.simulation.state(), end)
              << std::endl;
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_interleaved();
  test_copy("implicit", {"Cycles=5000"});
  test_copy("explicit, both surfaces",
            {"Cycles=1500",
             "Wear/Extrapolation=constant",
             "Bushing crank_pin/Pin wear coefficient=1e-4 mm^3/(N m)"});
  test_copy("one-shot rates kept",
            {"Cycles=5000", "Wear/Extrapolation=one-shot"});
  test_copy("coupled", {"Cycles=3000", "Wear/Scheme=coupled"});
}

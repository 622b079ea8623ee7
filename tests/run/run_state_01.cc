// SPDX-License-Identifier: LGPL-2.1-or-later

// Where a run stands is one value. Known by construction, to the bit:
// - Two different cases, of one wearing joint and of three, that go on in turn
// in one process get what each gets
//   alone.
// - From a state that was copied in mid-run, the same simulation, gone on and
//   set back, and another one, which has come nowhere by itself, end where the
//   first one did: implicit steps, explicit ones, and with finite elements
//   inside the dynamics. So does WearSimulation::run() on such a state.
// The copy is taken after the compliance has been renewed and the profile has
// moved on, so that both lags are in it.

#include <deal.II/base/mpi.h>

#include <tribody/base/console.h>
#include <tribody/case/case_parameters.h>
#include <tribody/output/output_directory.h>
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
  read(const std::vector<std::string> &overrides,
       const std::string              &name = "quickstart")
  {
    std::vector<std::string> all;
    if (name == "quickstart")
      // So rarely that compliance and motion lag behind at most steps.
      all = {"Bushing crank_pin/Mesh/Bore cells=36",
             "Wear/Compliance update=0.002",
             "Wear/Dynamics update=0.3"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    return read_case(std::string(SOURCE_DIR) + "/../../prm/" + name + ".prm",
                     all);
  }



  struct Run
  {
    explicit Run(const CaseParameters &parameters)
      : console(screen)
      , end(parameters.cycles)
      , simulation(parameters, console, MPI_COMM_WORLD)
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



  /// On the first rank.
  std::ostream &
  say()
  {
    static std::ostringstream nowhere;
    return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0
             ? std::cout
             : nowhere;
  }



  bool
  agree(const StepperState &a, const StepperState &b)
  {
    bool same = a.rate == b.rate && a.max_step == b.max_step &&
                a.extrapolation.proposal == b.extrapolation.proposal &&
                a.extrapolation.slope == b.extrapolation.slope &&
                a.max_stable_step == b.max_stable_step &&
                a.stable_step_builds == b.stable_step_builds &&
                a.contacts.size() == b.contacts.size() &&
                a.rates_taken.size() == b.rates_taken.size();
    for (std::size_t j = 0; same && j < a.rates_taken.size(); ++j)
      same = a.rates_taken[j].wear_rate == b.rates_taken[j].wear_rate &&
             a.rates_before[j].wear_rate == b.rates_before[j].wear_rate;
    return same;
  }



  bool
  agree(const CycleContact &a, const CycleContact &b)
  {
    bool same = a.samples.size() == b.samples.size() &&
                a.peak_pressure == b.peak_pressure &&
                a.wear_rate == b.wear_rate && a.removed_area == b.removed_area;
    for (std::size_t s = 0; same && s < a.samples.size(); ++s)
      same = a.samples[s].nodal_force == b.samples[s].nodal_force &&
             a.samples[s].active_set == b.samples[s].active_set;
    return same;
  }



  bool
  agree(const JointTotals &a, const JointTotals &b)
  {
    bool same = a.depth_error == b.depth_error &&
                a.sliding_distance == b.sliding_distance &&
                a.force_over_sliding == b.force_over_sliding;
    for (std::size_t i = 0; i < a.surfaces.size(); ++i)
      same = same &&
             a.surfaces[i].removed_volume == b.surfaces[i].removed_volume &&
             a.surfaces[i].volume_error == b.surfaces[i].volume_error;
    return same;
  }



  bool
  agree(const Multibody::DutyCycle &a, const Multibody::DutyCycle &b)
  {
    bool same = a.coordinates == b.coordinates && a.velocities == b.velocities;
    for (std::size_t j = 0; same && j < a.joints.size(); ++j)
      same = a.joints[j].force_x == b.joints[j].force_x &&
             a.joints[j].force_y == b.joints[j].force_y &&
             a.joints[j].sliding_increment == b.joints[j].sliding_increment;
    return same;
  }



  bool
  agree(const RunState &a, const RunState &b)
  {
    bool same =
      a.cycles == b.cycles && a.cycles_at_dynamics == b.cycles_at_dynamics &&
      a.stopped_by == b.stopped_by && a.joints.size() == b.joints.size() &&
      a.counts.wear_steps == b.counts.wear_steps &&
      a.counts.rate_evaluations == b.counts.rate_evaluations &&
      a.counts.dynamics_cycles == b.counts.dynamics_cycles &&
      a.counts.contact_solves == b.counts.contact_solves &&
      a.counts.compliance_builds == b.counts.compliance_builds &&
      a.dynamics.contact_losses == b.dynamics.contact_losses &&
      a.dynamics.constraint_drift == b.dynamics.constraint_drift &&
      a.operating_time == b.operating_time && a.shares == b.shares &&
      agree(a.duty_cycles.front(), b.duty_cycles.front()) &&
      agree(a.stepper, b.stepper);
    for (std::size_t j = 0; same && j < a.joints.size(); ++j)
      {
        const JointState &x = a.joints[j];
        const JointState &y = b.joints[j];

        same = x.depth == y.depth &&
               x.depth_at_compliance == y.depth_at_compliance &&
               x.depth_at_dynamics == y.depth_at_dynamics &&
               agree(x.contact, y.contact) && agree(x.totals, y.totals);
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
    const CaseParameters first  = read({"Cycles=2000"});
    const CaseParameters second = read({"Cycles=300"}, "four_bar_three_joints");
    Run                  a(first), b(second);
    a.simulation.start();
    b.simulation.start();
    while (!a.simulation.is_over() || !b.simulation.is_over())
      {
        a.go_on(1);
        b.go_on(1);
      }
    say() << "interleaved as alone: "
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
    say() << what << ": left something to do "
          << (end.counts.wear_steps > copy.counts.wear_steps) << ", set back "
          << agree(run.simulation.state(), end) << ", taken over "
          << agree(other.simulation.state(), end) << std::endl;
  }
} // namespace

// The steps of run() end where outputs are due: here at the last cycle.
void
test_run_from_state()
{
  const CaseParameters parameters =
    read({"Cycles=3000", "Output/Number of outputs=2"});
  Run whole(parameters), rest(parameters);
  whole.simulation.start();
  whole.simulation.advance(whole.end);
  rest.simulation.restore(whole.simulation.state());
  while (!whole.simulation.is_over())
    whole.simulation.advance(whole.end);
  Output::OutputDirectory directory("run_state_01.results", MPI_COMM_WORLD);
  const RunResults        results = rest.simulation.run(directory);
  say() << "run() on a state: "
        << agree(results.state, whole.simulation.state()) << std::endl;
}

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
  test_run_from_state();
}

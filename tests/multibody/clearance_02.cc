// The steel mechanism with a clearance of 5 mm from a centred start. Known from
// three independent codes (design.md, section 10): a first impact of about
// 4.6e4 N, 13 impacts, permanent contact from 0.21 s on, and in the second
// revolution a peak of 975.33 N and a mean of 505.96 N of the total force
// (printed when within 0.2 %).

#include "report.h"
#include "slider_crank.h"

using namespace SliderCrank;

int
main()
{
  MechanismParameters p = steel(1);
  add_steel_clearance(p, 1, 25e-3);
  DynamicsParameters dynamics;
  dynamics.accuracy                = 1e-4;
  dynamics.maximum_order           = 5;
  dynamics.start                   = "centred";
  dynamics.maximum_settling_cycles = 1;
  // So that the peak is met.
  dynamics.samples_per_cycle = 1440;
  const Mechanism       mechanism(p);
  const DutyCycle       cycle = CycleSimulation(mechanism, dynamics).run();
  const JointDutyCycle &joint = cycle.joint("crank_pin");

  std::cout << "cycles: " << cycle.settling.n_cycles << std::endl
            << "impacts: " << cycle.statistics.n_starts - 1 << std::endl
            << "contacts begun and ended in the second revolution: "
            << joint.n_onsets << ", " << joint.n_losses << std::endl;
  report_value("largest impact [kN]", 1e-3 * joint.peak_force_since_start, 1);
  report_below("relative error of the peak",
               std::abs(joint.peak_force() / 975.33 - 1),
               2e-3);
  report_below("relative error of the mean",
               std::abs(joint.mean_force() / 505.96 - 1),
               2e-3);
}

// Clearance joints in slow motion.
//
// Steel, 0.5 um: the joint force is known from an independent integration
// (reference/clearance_0.5um_literal.csv, Radau, rtol 1e-9, second revolution),
// and is within 1 % of it at every tabulated angle at the default accuracy; the
// error falls with the tolerance. Over 100 cycles the constraints stay
// fulfilled.
//
// Steel in PTFE, 10 um (the validation mechanism): contact is never lost, and
// the start leaves no vibration in the recorded cycle. The mean force must be
// near the ideal one. The same with a clearance in the wrist pin as well.

#include "report.h"
#include "slider_crank.h"

using namespace SliderCrank;

double
steel_error(const double accuracy)
{
  MechanismParameters p = steel(1);
  add_steel_clearance(p, 1, 20.0005e-3);
  DynamicsParameters dynamics;
  dynamics.accuracy = accuracy;
  const Mechanism       mechanism(p);
  const DutyCycle       cycle = CycleSimulation(mechanism, dynamics).run();
  const JointDutyCycle &joint = cycle.joint("crank_pin");
  const auto            table = read_table(std::string(SOURCE_DIR) +
                                "/reference/clearance_0.5um_literal.csv");
  double                error = 0.;
  for (unsigned int s = 0; s < table.size(); ++s)
    {
      error =
        std::max(error, std::abs(joint.normal_force(s) / table[s][1] - 1));
      error =
        std::max(error, std::abs(joint.friction_force(s) / table[s][2] - 1));
      error = std::max(error, std::abs(joint.force()(s) / table[s][3] - 1));
    }
  std::cout << "accuracy " << accuracy << ": " << table.size() << " rows, "
            << cycle.settling.n_cycles << " cycles, settled "
            << cycle.settling.converged << ", losses " << joint.n_losses
            << std::endl;
  return error;
}

void
steel_drift()
{
  MechanismParameters p = steel(1);
  add_steel_clearance(p, 1, 20.0005e-3);
  DynamicsParameters dynamics;
  // A tolerance that is never met keeps it going.
  dynamics.settling_tolerance      = 1e-12;
  dynamics.maximum_settling_cycles = 99;
  const Mechanism mechanism(p);
  const DutyCycle cycle = CycleSimulation(mechanism, dynamics).run();
  std::cout << "100 cycles: " << cycle.settling.n_cycles << ", settled "
            << cycle.settling.converged << std::endl;
  report_below("  constraint drift [nm]", 1e9 * cycle.constraint_drift, 10.);
}

void
ptfe(const std::vector<unsigned int> &joints)
{
  MechanismParameters p = validation(2);
  const DutyCycle     ideal =
    CycleSimulation(Mechanism(p), DynamicsParameters()).run();
  for (const unsigned int joint : joints)
    add_ptfe_clearance(p, joint);
  const Mechanism mechanism(p);
  const DutyCycle cycle =
    CycleSimulation(mechanism, DynamicsParameters()).run();
  std::cout << "PTFE, " << joints.size()
            << " joint(s) with clearance: " << cycle.settling.n_cycles
            << " cycles, settled " << cycle.settling.converged
            << cycle.settling.message << std::endl;
  for (const unsigned int j : joints)
    {
      const JointDutyCycle &joint = cycle.joints[j];
      std::cout << "  " << joint.name << ": losses " << joint.n_losses
                << ", following " << joint.share_of(ContactState::following)
                << std::endl;
      report_below("  residual ringing", joint.residual_ringing, 1e-3);
      report_value("  mean force over ideal",
                   joint.mean_force() / ideal.joints[j].mean_force(),
                   2);
      report_value("  least penetration [um]",
                   1e6 * joint.penetration.minCoeff(),
                   0);
    }
}

int
main()
{
  const double coarse = steel_error(1e-3), fine = steel_error(1e-5);
  report_below("  largest relative error, accuracy 1e-3", coarse, 1e-2);
  report_below("  largest relative error, accuracy 1e-5", fine, 1e-4);
  steel_drift();
  ptfe({1});
  ptfe({1, 2});
}

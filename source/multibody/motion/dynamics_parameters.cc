// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/multibody/motion/dynamics_parameters.h>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // One function per group of entries, in the order of the manual.
      void
      add_analysis(dealii::ParameterHandler &prm, DynamicsParameters &p)
      {
        Parameters::add_choice(
          prm,
          "Analysis",
          p.analysis,
          "'kinematic': positions, velocities and accelerations from joints "
          "and "
          "drivers alone; no forces, masses are not used. 'inverse dynamics': "
          "the "
          "same, and the reactions of joints and drivers in that motion. Both "
          "need drivers for all degrees of freedom and no clearance. "
          "'dynamic': "
          "the equations of motion are integrated. 'static equilibrium': "
          "positions in which gravity, springs, forces and contacts balance, "
          "at "
          "each sample with the drivers where they are then. 'automatic': "
          "inverse dynamics without degrees of freedom, dynamic otherwise.");
        Parameters::add_quantity(
          prm,
          "Cycle duration",
          p.cycle_duration,
          "s",
          "Time of one recorded cycle. 0 s: one turn of the first driver. It "
          "must be set where no driver turns; a static equilibrium without "
          "drivers needs none.");
      }



      void
      add_integration(dealii::ParameterHandler &prm, DynamicsParameters &p)
      {
        Parameters::add_choice(
          prm,
          "Joint motion",
          p.joint_motion,
          "How pins move in joints with clearance. 'dynamic': pins are free "
          "in their bores, and the equations of motion are integrated with the "
          "vibration and the impacts of their contacts. 'quasi-static': every "
          "pin rests where its force presses it into its bore, against "
          "friction and as deep as the contact force law says; then the motion "
          "has nothing to settle, and its cost does not depend on the "
          "stiffness. It needs drivers for all degrees of freedom that ideal "
          "joints leave. What it leaves out is the inertia of the pins' motion "
          "against their bores: where that would change the force of a joint "
          "by more than 2 % on the average over its sliding, a message says "
          "so; beyond 10 % the run stops. 'automatic': in runs with wear "
          "quasi-static where that is possible within these limits and leaves "
          "out less than 0.5 % of the wear, otherwise dynamic; in runs without "
          "wear ('Cycles = 0') dynamic.");
        Parameters::add_quantity(
          prm,
          "Accuracy",
          p.accuracy,
          "",
          "Local error allowed in one integration step, relative to the "
          "expected penetration of a joint with clearance (if there is none, "
          "1e-4 of the mechanism's size, and for velocities that in the time "
          "of a cycle over 2 pi). 3e-4 gives joint forces to better than 0.1 "
          "%. 0 takes this in runs without wear and for an energy balance; in "
          "other runs with wear as much as changes the wear of the first "
          "cycles by less than 0.2 % against four times as much. If the "
          "clearance of a joint is more than ten penetrations, so that its pin "
          "strikes, a tenth of this is allowed: every impact multiplies "
          "errors.");
        Parameters::add_integer(
          prm,
          "Maximum order",
          p.maximum_order,
          "Highest order of the BDF method. 0 takes 2 for mechanisms with a "
          "joint whose clearance is less than ten penetrations and 5 for "
          "others: "
          "orders above 2 are unstable for the lightly damped vibration of "
          "such "
          "a joint.",
          0,
          5);
      }



      void
      add_settling(dealii::ParameterHandler &prm, DynamicsParameters &p)
      {
        Parameters::add_integer(prm,
                                "Samples per cycle",
                                p.samples_per_cycle,
                                "Number of equal time steps at which a duty "
                                "cycle is recorded, at least: see 'Sampling "
                                "tolerance'.",
                                8,
                                100000);
        Parameters::add_quantity(
          prm,
          "Sampling tolerance",
          p.sampling_tolerance,
          "",
          "Error that the samples may leave in the wear where it is deepest, "
          "estimated from the forces between them. Where it is larger, twice "
          "as many are taken, up to sixteen times 'Samples per cycle'. 0 takes "
          "these as they are; so do runs without wear.");
        Parameters::add_quantity(
          prm,
          "Settling tolerance",
          p.settling_tolerance,
          "",
          "A motion counts as settled when it is nearer than this to one that "
          "repeats: joint forces, seen from the bushing, speeds at which pins "
          "turn in their bushings, and velocities of bodies, each relative to "
          "its largest. The distance follows from the changes of the last two "
          "cycles and the rate at which they decay; a change below a "
          "thousandth of this counts as none.");
        Parameters::add_integer(
          prm,
          "Maximum settling cycles",
          p.maximum_settling_cycles,
          "Cycles that are run before the last one is "
          "recorded although the motion does not repeat; "
          "the report says so. 0 records the first cycle, "
          "from the start, whether it repeats or not.",
          0,
          100000);
        Parameters::add_integer(
          prm,
          "Averaged cycles",
          p.averaged_cycles,
          "If the motion does not repeat within the settling tolerance: number "
          "of cycles that are recorded after that, at most: from five on, they "
          "end when twice the standard error of the mean of normal force times "
          "sliding is within the settling tolerance. All their samples make up "
          "the duty cycle, each with its share of one cycle's sliding; means "
          "are over all of them, and their scatter from cycle to cycle is "
          "reported. 1 takes the last cycle as it is.",
          1,
          10000);
        Parameters::add_integer(prm,
                                "Maximum steps per cycle",
                                p.maximum_steps_per_cycle,
                                "Integration steps in one cycle after which "
                                "the run stops with an error.",
                                100,
                                2000000000);
      }
    } // namespace



    void
    DynamicsParameters::add_parameters(dealii::ParameterHandler &prm)
    {
      add_analysis(prm, *this);
      add_integration(prm, *this);
      add_settling(prm, *this);
      Parameters::add_choice(
        prm,
        "Start",
        start,
        "How a mechanism with clearance joints starts. 'slow motion': with "
        "every pin at its bore where the force of its joint presses it, moving "
        "along it such that nothing vibrates; where that cannot be, as where a "
        "force reverses, or with degrees of freedom, at rest there while the "
        "bodies have the velocities of ideal joints; and where velocities or "
        "forces would be far from those of ideal joints even so, as 'centred'. "
        "What it comes to is reported, unless nothing vibrates. 'centred': "
        "with every pin in the middle of its bushing, so that the first "
        "contact is an impact. 'static equilibrium': any mechanism, in the "
        "position in which forces and contacts balance.");
      Parameters::add_choice(
        prm,
        "Energy balance",
        energy_balance,
        "Whether to add up the work of drivers and forces and what dampers, "
        "contacts and friction take. Then the energies in energy_NNNN.csv tell "
        "where the work goes, and what is missing in the balance tells how "
        "exact the motion is. It takes about half as long again as the motion "
        "alone; 'without wear' does it for runs with Cycles = 0 only.");
    }



    void
    DynamicsParameters::check() const
    {
      AssertThrow(
        accuracy == 0. || (accuracy > 1e-12 && accuracy <= 0.1),
        ExcParameter("Dynamics/Accuracy",
                     "must be between 1e-12 and 0.1, or 0 for as much as "
                     "the wear allows, not " +
                       Units::to_string(accuracy, "", "")));
      AssertThrow(cycle_duration >= 0,
                  ExcParameter("Dynamics/Cycle duration",
                               "must be positive, or 0 s for one turn of the "
                               "first driver, not " +
                                 Units::to_string(cycle_duration, "s", "s")));
      AssertThrow(sampling_tolerance >= 0,
                  ExcParameter("Dynamics/Sampling tolerance",
                               "must be positive, or 0 for as many samples as "
                               "'Samples per cycle' says, not " +
                                 Units::to_string(sampling_tolerance, "", "")));
      AssertThrow(settling_tolerance > 0,
                  ExcParameter("Dynamics/Settling tolerance",
                               "must be positive, not " +
                                 Units::to_string(settling_tolerance, "", "")));
    }
  } // namespace Multibody
} // namespace Tribody

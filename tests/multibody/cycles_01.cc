// SPDX-License-Identifier: LGPL-2.1-or-later

// Cycles that repeat, cycles that do not, contacts that a step could miss, and
// memory.
//
// Averages: of three cycles whose forces are given, peaks, means and their
// deviations can be counted on one's fingers. Of a motion that repeats, the
// average over three cycles is that of any one of them, and its scatter is what
// the tolerance for settling leaves. A motion that does not repeat has as much
// sliding in the average cycle as the mechanism with ideal joints, to the
// clearance over the lengths of the bars.
//
// Missed contacts: a pin that is thrown up in its clearance circle falls back
// before or after it has touched the wall. Its flight is a parabola, which BDF
// follows exactly with steps longer than all of it. A throw that would rise
// above the wall by a ten-thousandth of the clearance must give a contact, one
// that falls short of it by as much none.
//
// A failure: a motion that asks for more steps than there may be of them ends
// with a message that names time, joint and penetration.
//
// Memory: between two records the integrator calls residuals, Jacobians and
// root functions hundreds of times. What is allocated then, less than one piece
// for ten residuals, comes from the states that are handed out and from
// factorisations.

#include "report.h"
#include "slider_crank.h"
#include <tribody/base/exceptions.h>
#include <tribody/multibody/following/slow_motion_start.h>
#include <tribody/multibody/motion/motion_integrator.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/kinematics.h>

#include <cmath>
#include <cstdlib>

using namespace SliderCrank;

// The C library's own allocator, behind one that counts.
extern "C" void *
__libc_malloc(std::size_t size);

namespace
{
  unsigned long n_allocations = 0;
}

extern "C" void *
malloc(std::size_t size)
{
  ++n_allocations;
  return __libc_malloc(size);
}

// Three cycles of four samples whose forces are known.
void
average_of_known_cycles()
{
  DutyCycle cycle;
  cycle.period = 6.;
  cycle.phase  = Eigen::VectorXd::LinSpaced(12, 0., 330.);
  JointDutyCycle joint;
  joint.force_x = Eigen::VectorXd::Zero(12);
  joint.force_y.resize(12);
  joint.force_y << 0., 1., 0., 3., 2., 4., 2., 0., 5., 1., 1., 5.;
  joint.normal_force      = joint.force_y;
  joint.sliding_increment = Eigen::VectorXd::Constant(12, 1.);
  cycle.joints            = {joint};
  cycle.average_over(3);
  const JointDutyCycle &average = cycle.joints[0];
  std::cout << "known cycles: peaks 3, 4, 5, means 1, 2, 3" << std::endl;
  report_value("  mean peak", average.mean_peak_force, 6);
  report_value("  its deviation", average.peak_force_deviation, 6);
  report_value("  deviation of the mean", average.mean_force_deviation, 6);
  report_value("  sliding in a cycle", average.sliding_distance(), 6);
  report_value("  period [s]", cycle.period, 6);
  report_value("  phase of the sixth sample [deg]", cycle.phase(5), 6);
}

void
average_of_repeating_motion()
{
  MechanismParameters p = validation(2);
  add_ptfe_clearance(p, 1);
  const Mechanism    mechanism(p);
  DynamicsParameters dynamics;
  const DutyCycle    single        = CycleSimulation(mechanism, dynamics).run();
  dynamics.settling_tolerance      = 1e-300;
  dynamics.maximum_settling_cycles = 2;
  dynamics.averaged_cycles         = 3;
  const DutyCycle average          = CycleSimulation(mechanism, dynamics).run();
  std::cout << "repeating motion: averaged over "
            << average.settling.n_averaged_cycles << " cycles, "
            << average.phase.size() << " samples" << std::endl;
  const JointDutyCycle &one  = single.joint("crank_pin");
  const JointDutyCycle &mean = average.joint("crank_pin");
  report_below("  mean force",
               std::abs(mean.mean_force() / one.mean_force() - 1),
               1e-4);
  report_below("  mean normal force over sliding",
               std::abs(mean.mean_normal_force() / one.mean_normal_force() - 1),
               1e-4);
  report_below("  sliding in a cycle",
               std::abs(mean.sliding_distance() / one.sliding_distance() - 1),
               1e-6);
  report_below("  scatter of the peak",
               mean.peak_force_deviation / mean.mean_peak_force,
               1e-3);
  report_below("  scatter of the mean",
               mean.mean_force_deviation / mean.mean_force(),
               1e-4);
  report_below("  period", std::abs(average.period / single.period - 1), 1e-12);
}

void
average_of_other_motion()
{
  // The impacts at the start leave a swing that has not yet died away.
  MechanismParameters p = steel(1);
  const DutyCycle     ideal =
    CycleSimulation(Mechanism(p), DynamicsParameters()).run();
  add_steel_clearance(p, 1, 25e-3);
  const Mechanism    mechanism(p);
  DynamicsParameters dynamics;
  dynamics.start                   = MotionStart::centred;
  dynamics.maximum_settling_cycles = 1;
  dynamics.averaged_cycles         = 5;
  const DutyCycle       cycle      = CycleSimulation(mechanism, dynamics).run();
  const JointDutyCycle &joint      = cycle.joint("crank_pin");
  std::cout << "swinging: settled " << cycle.settling.converged
            << ", averaged over " << cycle.settling.n_averaged_cycles
            << " cycles" << std::endl;
  report_below("  sliding against the ideal joint's, with R_j",
               std::abs(joint.sliding_distance() /
                          ideal.joint("crank_pin").sliding_distance() *
                          p.joints[0].bushing_radius /
                          p.joints[1].bushing_radius -
                        1),
               5e-3 / 1.);
}

// A free pin, 5 mm of clearance, thrown up from the centre to the given height
// [m].
void
throw_up(const double height)
{
  constexpr double    g = 9.81;
  MechanismParameters p;
  p.gravity = {0., -g};
  BodyParameters pin;
  pin.name              = "pin";
  pin.mass              = 1.;
  pin.moment_of_inertia = 1.;
  p.bodies              = {pin};
  JointParameters joint;
  joint.name           = "joint";
  joint.pin_marker     = "pin.O";
  joint.bushing_marker = "ground.O";
  p.joints             = {joint};
  add_steel_clearance(p, 0, 25e-3);
  const Mechanism         mechanism(p);
  const EquationsOfMotion equations(mechanism, nominal_clearances(mechanism));
  MotionTolerances        tolerances;
  tolerances.positions  = Eigen::Vector3d::Constant(1e-8);
  tolerances.velocities = Eigen::Vector3d::Constant(1e-6);
  MotionIntegrator integrator(equations, tolerances);
  const double     speed = std::sqrt(2 * g * height);
  MechanismState   state;
  state.q = Eigen::Vector3d::Zero();
  state.v = Eigen::Vector3d(0., speed, 0.);
  integrator.start(state);
  // Up, and most of the way back.
  integrator.advance_to(1.9 * speed / g, 100000);
  std::cout << "thrown to " << std::setprecision(6) << 1e3 * height
            << " mm of 5 mm: "
            << (integrator.events().empty() ? "no contact" : "contact")
            << std::endl;
}

void
collapse()
{
  MechanismParameters p = validation(2);
  add_ptfe_clearance(p, 1);
  const Mechanism    mechanism(p);
  DynamicsParameters dynamics;
  dynamics.maximum_steps_per_cycle = 20;
  try
    {
      CycleSimulation(mechanism, dynamics).run();
    }
  catch (const ExcRun &error)
    {
      const std::string message = message_of(error);
      for (const std::string part :
           {"time", "crank_pin", "penetration", "um", "Accuracy"})
        std::cout << "collapse: names " << part << ": "
                  << (message.find(part) != std::string::npos) << std::endl;
    }
}

void
allocations(const double bushing_radius, const std::string &what)
{
  MechanismParameters p = steel(1);
  add_steel_clearance(p, 1, bushing_radius);
  const Mechanism          mechanism(p);
  const Mechanism          closed_mechanism(with_ideal_joints(p));
  const EquationsOfMotion  equations(mechanism, nominal_clearances(mechanism));
  const EquationsOfMotion  closed(closed_mechanism, {});
  const DynamicsParameters dynamics;
  const CycleSimulation    simulation(mechanism, dynamics);
  MotionIntegrator         integrator(equations,
                              make_tolerances(mechanism,
                                              simulation.reference_scales(),
                                              dynamics));
  integrator.start(compute_centred_start(equations, closed, 0.).state);
  integrator.advance_to(0.3, 1000000);
  const unsigned long n_residuals = integrator.statistics().n_residuals;
  const unsigned long n_before    = n_allocations;
  integrator.advance_to(0.6, 1000000);
  const unsigned long n_pieces = n_allocations - n_before;
  report_below(what + ": pieces of memory for each residual",
               n_pieces /
                 double(integrator.statistics().n_residuals - n_residuals),
               0.1);
}

int
main()
{
  average_of_known_cycles();
  average_of_repeating_motion();
  average_of_other_motion();
  for (const double height : {4.95e-3, 4.9995e-3, 5.0005e-3, 5.05e-3})
    throw_up(height);
  collapse();
  allocations(20.0005e-3, "0.5 um");
  allocations(25e-3, "5 mm");
}

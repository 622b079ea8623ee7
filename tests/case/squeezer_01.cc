// SPDX-License-Identifier: LGPL-2.1-or-later

// Andrews' squeezing mechanism, as shipped in prm/andrews_squeezer.prm: seven
// bodies in closed loops, a spring attached off-centre, started from rest by a
// constant torque. Known: its angles at t = 0.03 s to 13 digits, the reference
// solution of the Test Set for IVP Solvers (Mazzia and Magherini, release 2.4),
// and that the error against it falls like the tolerance. BDF of fifth order
// with a local error of tol in a step has a global error like tol^(5/6). The
// accuracy of 3e-5 that the file asks for gives six digits, against the
// reference and against a run with tolerances 100 times tighter.
//
// The work of the torque is the energy. What it lacks is of the size of the
// errors of the speeds, below a tenth of "Accuracy".

#include "../multibody/report.h"
#include <tribody/case/case_parameters.h>
#include <tribody/multibody/motion/motion_integrator.h>
#include <tribody/multibody/motion/reference_scales.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>

#include <cmath>

using namespace Tribody;
using namespace Tribody::Multibody;

using Angles = Eigen::Matrix<double, 7, 1>;

// beta, Theta, gamma, Phi, delta, Omega, epsilon from the bodies' angles.
Angles
published_angles(const Eigen::VectorXd &q)
{
  const auto angle = [&](const int body) { return q(3 * body - 1); };
  Angles     result;
  result << angle(1), angle(2) - angle(1), angle(3), angle(4) - angle(5),
    angle(5), angle(6) - angle(7), angle(7);
  return result;
}

MechanismState
start_up(const Coupling::CaseParameters &parameters, const double accuracy)
{
  const Mechanism         mechanism(parameters.mechanism);
  const EquationsOfMotion equations(mechanism, {});
  DynamicsParameters      dynamics = parameters.dynamics;
  dynamics.accuracy                = accuracy;
  MotionIntegrator integrator(equations,
                              make_tolerances(mechanism, {}, dynamics));
  MechanismState   state;
  state.q = assemble_configuration(equations, 0.);
  state.v = compute_initial_velocities(equations, 0., state.q);
  integrator.start(state);
  state = integrator.advance_to(dynamics.cycle_duration, 1000000);
  report_below("constraint drift [nm]",
               1e9 * integrator.constraint_drift(),
               10.);
  // The torque's work is the energy.
  const Energy energy = equations.compute_energy(state.q, state.v);
  const Energy before =
    equations.compute_energy(assemble_configuration(equations, 0.),
                             Eigen::VectorXd::Zero(state.q.size()));
  const double work =
    mechanism.parameters().torques[0].torque *
    (state.q(2) - mechanism.parameters().bodies[0].initial_angle);
  report_below("  relative error of the energy",
               std::abs((energy.total() - before.total()) / work - 1),
               accuracy / 10);
  return state;
}

int
main()
{
  const Coupling::CaseParameters parameters = Coupling::read_case(
    std::string(SOURCE_DIR) + "/../../prm/andrews_squeezer.prm", {});
  Angles reference;
  reference << 15.81077119629904, -15.75637105984298, 0.04082224013073101,
    -0.5347301163226948, 0.5244099658805304, 0.5347301163226948,
    1.048080741042263;
  const double published_speed = 1139.920302151208;

  const unsigned int          n = 5;
  std::vector<double>         errors;
  std::vector<MechanismState> states;
  for (unsigned int i = 0; i < n; ++i)
    {
      const double accuracy = 3e-3 * std::pow(10., -static_cast<double>(i));
      std::cout << "Accuracy " << accuracy << ": ";
      states.push_back(start_up(parameters, accuracy));
      errors.push_back((published_angles(states.back().q) - reference)
                         .lpNorm<Eigen::Infinity>());
    }
  report_below("accuracy 3e-5: error of the angles over the largest",
               errors[2] / reference.lpNorm<Eigen::Infinity>(),
               1e-6);
  report_below("  difference from tolerances 100 times tighter",
               (published_angles(states[2].q) - published_angles(states[4].q))
                   .lpNorm<Eigen::Infinity>() /
                 reference.lpNorm<Eigen::Infinity>(),
               1e-6);
  report_below("  relative error of the crank's speed",
               std::abs(states[2].v(2) / published_speed - 1),
               1e-6);
  report_below("error at the tightest tolerance [1e-6 rad]",
               1e6 * errors[4],
               1.);
  report_value("mean order in the tolerance",
               std::log10(errors[0] / errors[4]) / 4,
               1);
}

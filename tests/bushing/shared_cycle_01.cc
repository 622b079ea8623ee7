// SPDX-License-Identifier: LGPL-2.1-or-later

// The contact of a cycle, shared by ranks. Known: it is the same problem,
// whoever solves it. Compliance, wear rate and peak pressures are compared with
// those that every rank computes alone: the compliance to the bit, the others
// to 1e-12, as samples that are shared start from other neighbours. The
// Jacobian of the wear rate multiplies what the contacts leave of error. A
// sample that cannot be solved ends the work of all ranks with the same
// message, also if only the last rank has it in its share.

#include <deal.II/base/mpi.h>

#include <tribody/base/exceptions.h>
#include <tribody/bushing/wearing_bushing.h>
#include <tribody/multibody/cycle/duty_cycle.h>

#include <cmath>
#include <fstream>
#include <string>

using namespace Tribody;
using namespace Tribody::Coupling;

namespace
{
  WearingBushing
  make_bushing(const MPI_Comm &communicator)
  {
    Multibody::JointParameters joint;
    joint.name             = "pin";
    joint.bushing_material = {"plastic", 0.139e9, 0.38, 2160.};
    BushingParameters bushing;
    bushing.name              = joint.name;
    bushing.axial_length      = 8.6e-3;
    bushing.outer_radius      = 15.875e-3;
    bushing.wear_coefficient  = 5.05e-13;
    bushing.mesh.n_bore_cells = 60;
    return {bushing, joint, 0.005, communicator};
  }

  Multibody::JointDutyCycle
  make_cycle()
  {
    const unsigned int        n = 41;
    Multibody::JointDutyCycle cycle;
    cycle.name              = "pin";
    cycle.sliding_increment = Eigen::VectorXd::Constant(n, 60e-3 / n);
    cycle.normal_force.resize(n);
    cycle.contact_angle_bushing.resize(n);
    for (unsigned int j = 0; j < n; ++j)
      {
        const double phase             = 2. * M_PI * j / n;
        cycle.contact_angle_bushing[j] = phase;
        cycle.normal_force[j]          = 75. + 25. * std::cos(phase + 0.5);
      }
    return cycle;
  }

  std::string
  yes(const bool agree)
  {
    return agree ? "yes" : "no";
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::ofstream                                  output;
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    output.open("output");

  WearingBushing            alone  = make_bushing(MPI_COMM_SELF);
  WearingBushing            shared = make_bushing(MPI_COMM_WORLD);
  Multibody::JointDutyCycle cycle  = make_cycle();

  // Worn enough for a new compliance.
  const Eigen::VectorXd depth = 1e-4 * (1. + alone.node_angles().array().cos());
  alone.set_depth(depth);
  shared.set_depth(depth);
  CycleContact a = alone.compute_cycle_contact(depth, cycle, nullptr);
  CycleContact s = shared.compute_cycle_contact(depth, cycle, nullptr);
  // An eigenvalue of the compliance.
  output << "compliance, the same bits: "
         << yes(alone.max_stable_step(a) == shared.max_stable_step(s)) << '\n';

  for (const std::string start : {"cold", "warm"})
    {
      const auto differ = [](const Eigen::MatrixXd &x,
                             const Eigen::MatrixXd &y) {
        return (x - y).lpNorm<Eigen::Infinity>() / y.lpNorm<Eigen::Infinity>();
      };
      const double rate     = differ(s.wear_rate, a.wear_rate),
                   pressure = differ(s.peak_pressure, a.peak_pressure),
                   peak     = std::abs(s.max_pressure / a.max_pressure - 1.),
                   gap = differ(s.at_peak_force().gap, a.at_peak_force().gap),
                   jacobian = differ(shared.compute_wear_rate_jacobian(s),
                                     alone.compute_wear_rate_jacobian(a));
      output << start << ": wear rate " << yes(rate < 1e-12) << ", pressures "
             << yes(pressure < 1e-12 && peak < 1e-12)
             << ", contact at the peak force "
             << yes(gap < 1e-9 && s.at_peak_force().active_set ==
                                    a.at_peak_force().active_set)
             << ", Jacobian " << yes(jacobian < 1e-10) << '\n';
      // A little more wear, from the solutions at hand.
      const Eigen::VectorXd more = 1.01 * depth;
      a                          = alone.compute_cycle_contact(more, cycle, &a);
      s = shared.compute_cycle_contact(more, cycle, &s);
    }

  cycle.normal_force[40] = 1e12;
  try
    {
      shared.compute_cycle_contact(depth, cycle, nullptr);
    }
  catch (const ExcRun &exception)
    {
      const std::string message = message_of(exception);
      output << "on the first rank: "
             << message.substr(0, message.find(" has no solution")) << '\n';
    }
  // All ranks come here.
  output << "ranks that went on: all but "
         << dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) -
              dealii::Utilities::MPI::sum(1U, MPI_COMM_WORLD)
         << '\n';
}

// SPDX-License-Identifier: LGPL-2.1-or-later

// The contact of a cycle of 200 samples on 360 bore nodes, shared by the ranks
// it is started on, cold and warm: fastest and median of 51 wall
// times.
//
//   mpirun -n 2 benchmark_shared_cycle [BORE_NODES]

#include <deal.II/base/mpi.h>

#include <tribody/bushing/wearing_bushing.h>
#include <tribody/multibody/cycle/duty_cycle.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

using namespace Tribody;
using namespace Tribody::Coupling;

namespace
{
  /// Fastest and median wall time of @p work [ms].
  std::string
  measure(const std::function<void()> &work)
  {
    std::vector<double> times;
    for (unsigned int i = 0; i < 51; ++i)
      {
        MPI_Barrier(MPI_COMM_WORLD);
        const auto start = std::chrono::steady_clock::now();
        work();
        MPI_Barrier(MPI_COMM_WORLD);
        times.push_back(std::chrono::duration<double, std::milli>(
                          std::chrono::steady_clock::now() - start)
                          .count());
      }
    std::sort(times.begin(), times.end());
    return std::to_string(times.front()) + " and " + std::to_string(times[25]) +
           " ms";
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  Multibody::JointParameters joint;
  joint.name             = "pin";
  joint.bushing_material = {"plastic", 0.139e9, 0.38, 2160.};
  BushingParameters parameters;
  parameters.name              = joint.name;
  parameters.axial_length      = 13.1e-3;
  parameters.outer_radius      = 15.875e-3;
  parameters.wear_coefficient  = 5.05e-13;
  parameters.mesh.n_bore_cells = (argc > 1 ? std::stoi(argv[1]) : 360) / 2;
  WearingBushing bushing(parameters, joint, 0.005, MPI_COMM_WORLD);

  const unsigned int        n = 200;
  Multibody::JointDutyCycle cycle;
  cycle.name              = "pin";
  cycle.sliding_increment = Eigen::VectorXd::Constant(n, 60e-3 / n);
  cycle.normal_force.resize(n);
  cycle.contact_angle_bushing.resize(n);
  for (unsigned int j = 0; j < n; ++j)
    {
      const double phase             = 2. * M_PI * j / n;
      cycle.contact_angle_bushing[j] = phase;
      cycle.normal_force[j]          = 75. + 25. * std::cos(phase);
    }

  const Eigen::VectorXd depth =
    1e-5 * (1. + bushing.node_angles().array().cos());
  bushing.set_depth(depth);
  const CycleContact start =
    bushing.compute_cycle_contact(depth, cycle, nullptr);
  const std::string cold =
    measure([&] { bushing.compute_cycle_contact(depth, cycle, nullptr); });
  const Eigen::VectorXd more = 1.01 * depth;
  const std::string     warm =
    measure([&] { bushing.compute_cycle_contact(more, cycle, &start); });
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD)
              << " ranks: cold " << cold << ", warm " << warm << std::endl;
}

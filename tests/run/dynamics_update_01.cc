// SPDX-License-Identifier: LGPL-2.1-or-later

// 'Wear/Dynamics update': the motion is kept over several wear steps, and what
// that does to the results is part of the estimated error. Known, for a
// quarter of the cycles of prm/quickstart.prm:
// - Explicit steps of a given length differ by the kept motion alone. The error
//   of a rate that is kept is half of its change over that span, to first
//   order, and further wear levels part of it: the difference of depth and
//   volume from the run with new motion after every step is no larger than what
//   the estimate has grown by.
// - Implicit steps are chosen by what their motion does, too: they and the
//   explicit ones end within their own estimate of the most accurate run.

#include <deal.II/base/mpi.h>

#include <tribody/base/console.h>
#include <tribody/case/case_parameters.h>
#include <tribody/output/output_directory.h>
#include <tribody/run/wear_simulation.h>

#include <cmath>
#include <iostream>
#include <sstream>

using namespace Tribody;

namespace
{
  struct Result
  {
    // Of depth [m] and volume [m^3]; the errors likewise.
    double       depth, depth_error, volume, volume_error;
    unsigned int n_dynamics;
  };



  Result
  run(const std::string &extrapolation,
      const std::string &tolerance,
      const std::string &update)
  {
    const Coupling::CaseParameters parameters =
      Coupling::read_case(std::string(SOURCE_DIR) + "/../../prm/quickstart.prm",
                          {"Cycles=5350",
                           "Wear/Cycles per step=40",
                           "Wear/Mesh error estimate=none",
                           "Wear/Extrapolation=" + extrapolation,
                           "Wear/Tolerance=" + tolerance,
                           "Wear/Dynamics update=" + update});
    const std::string directory =
      "dynamics_update_01.results/" + extrapolation + "_" + update;

    std::ostringstream         screen;
    Console                    console(screen);
    Coupling::WearSimulation   simulation(parameters, console, MPI_COMM_WORLD);
    Output::OutputDirectory    output(directory, MPI_COMM_SELF);
    const Coupling::RunResults results      = simulation.run(output);
    const Coupling::SurfaceResults &bushing = results.bushings[0].bushing;
    return {bushing.max_wear_depth,
            bushing.max_wear_depth * results.depth_relative_error(),
            bushing.worn_volume,
            bushing.worn_volume * results.volume_relative_error(),
            results.state.counts.dynamics_cycles};
  }



  void
  compare(const Result &kept, const Result &accurate)
  {
    std::cout << "  within the estimate: depth "
              << (std::abs(kept.depth - accurate.depth) <= kept.depth_error)
              << ", volume "
              << (std::abs(kept.volume - accurate.volume) <= kept.volume_error)
              << std::endl;
  }
} // namespace



int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Result accurate = run("implicit", "1e-4", "0");
  const Result every    = run("constant", "5e-3", "0");
  std::cout << "constant, 0:" << std::endl;
  compare(every, accurate);

  for (const char *update : {"0.01", "0.05", "0.3"})
    {
      const Result kept = run("constant", "5e-3", update);
      std::cout << "constant, " << update << ": fewer cycles of dynamics "
                << (kept.n_dynamics < every.n_dynamics) << std::endl;
      compare(kept, accurate);
      std::cout << "  within what the estimate grows by: depth "
                << (std::abs(kept.depth - every.depth) <=
                    kept.depth_error - every.depth_error)
                << ", volume "
                << (std::abs(kept.volume - every.volume) <=
                    kept.volume_error - every.volume_error)
                << std::endl;
    }

  const Result kept = run("implicit", "1e-4", "0.3");
  std::cout << "implicit, 0.3: fewer cycles of dynamics "
            << (kept.n_dynamics < accurate.n_dynamics) << std::endl;
  compare(kept, accurate);
}

// SPDX-License-Identifier: LGPL-2.1-or-later

// A bushing alone, with its loads from a file. Known:
// - The duty cycle that a run with a mechanism has written wears it as in that
//   run, to the digits of the file, as long as that run keeps its motion.
// - A record in time of a constant force and a turning pin is the shaft that is
//   loaded so: 200 m of sliding under 120 N. Forces by components in kN or by
//   size and angle, rows at unequal times, no matter.
// - Load cases from two files are those of two mechanisms.

#include <deal.II/base/mpi.h>

#include <tribody/base/console.h>
#include <tribody/case/case_parameters.h>
#include <tribody/output/output_directory.h>
#include <tribody/run/wear_simulation.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

using namespace Tribody;

namespace
{
  void
  write(const std::string &file_name, const std::string &text)
  {
    std::ofstream(file_name) << text;
  }



  double
  depth_of(const std::string &base, const std::string &lines)
  {
    write("given_loads_01.prm",
          "include " + std::string(SOURCE_DIR) + "/" + base + ".prm\n" + lines);
    const Coupling::CaseParameters parameters =
      Coupling::read_case("given_loads_01.prm", {});
    std::ostringstream       screen;
    Console                  console(screen);
    Coupling::WearSimulation simulation(parameters, console, MPI_COMM_WORLD);
    Output::OutputDirectory  directory("given_loads_01.results", MPI_COMM_SELF);
    return simulation.run(directory).bushings[0].bushing.max_wear_depth;
  }



  void
  compare(const std::string &what, const double depth, const double known)
  {
    std::cout << what << ": " << (std::abs(depth / known - 1.) < 1e-9)
              << std::endl;
  }



  std::string
  loads_from(const std::string &file_name)
  {
    return "subsection Bushing bearing\n  set Duty cycle file = " + file_name +
           "\nend\n";
  }
} // namespace



int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string cycles = "set Cycles = 1000\n";
  const std::string kept =
    cycles +
    "subsection Wear\n  set Dynamics update = 0.999\nend\n"
    "subsection Force load\n  set Time function = 1 + "
    "0.5*sin(pi*t)\nend\n";
  const double  with_mechanism = depth_of("loaded_shaft", kept);
  std::ifstream own("given_loads_01.results/bearing/duty_cycle_0000.csv");
  std::ofstream("own.csv") << own.rdbuf();
  compare("Duty cycle of a run",
          depth_of("loaded_bushing", cycles + loads_from("own.csv")),
          with_mechanism);

  const double constant = depth_of("loaded_shaft", cycles);
  write("components.csv",
        "time [s], force_x [kN], force_y [kN], pin_angle [deg]\n"
        "0, 0.12, 0, 10\n0.5, 0.12, 0, 100\n1, 0.12, 0, 190\n"
        "1.4, 0.12, 0, 262\n2, 0.12, 0, 370\n");
  compare("Components in time",
          depth_of("loaded_bushing", cycles + loads_from("components.csv")),
          constant);
  write("sizes.csv",
        "time [ms];force [N];force_angle [deg];pin_angle [rad]\n"
        "0;120;360;0\n1000;120;0;-3.141592653589793\n"
        "2000;120;0;-6.283185307179586\n");
  compare("Size and angle in time",
          depth_of("loaded_bushing", cycles + loads_from("sizes.csv")),
          constant);

  const std::string cases =
    "set Cycles = 1000\nset Load cases = a, b\nsubsection Load case a\n"
    "  set Share = 0.5\nend\nsubsection Load case b\n  set Share = 0.5\n";
  write("half.csv",
        "time [s], force_x [N], force_y [N], pin_angle [deg]\n"
        "0, 0, 60, 0\n1, 0, 60, 180\n2, 0, 60, 360\n");
  compare("Load cases",
          depth_of("loaded_bushing",
                   loads_from("components.csv") + cases +
                     loads_from("half.csv") + "end\n"),
          depth_of("loaded_shaft",
                   cases + "subsection Force load\n  set Vector = 0 N, 60 "
                           "N\nend\nend\n"));
  return 0;
}

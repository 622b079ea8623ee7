// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_tests_run_run_lines_h
#define tribody_tests_run_run_lines_h

#include <deal.II/base/mpi.h>

#include <tribody/base/console.h>
#include <tribody/case/case_parameters.h>
#include <tribody/run/wear_simulation.h>

#include <fstream>
#include <sstream>
#include <string>

/// The case that includes @p machine, a file beside the tests, with @p lines
/// after it. Each rank writes its own file, "<test>.<rank>.prm".
inline Tribody::Coupling::CaseParameters
read_lines(const std::string &test,
           const std::string &machine,
           const std::string &lines)
{
  const std::string name =
    test + "." +
    std::to_string(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)) +
    ".prm";
  std::ofstream file(name);
  file << "include " << SOURCE_DIR << "/" << machine << "\n" << lines;
  file.close();
  return Tribody::Coupling::read_case(name, {});
}

/// What a run of the case comes to, with nothing on the screen or on the disk.
inline Tribody::Coupling::RunResults
run_silently(const Tribody::Coupling::CaseParameters &parameters)
{
  std::ostringstream                screen;
  Tribody::Console                  console(screen);
  Tribody::Coupling::WearSimulation simulation(parameters,
                                               console,
                                               MPI_COMM_WORLD);
  simulation.start();
  while (!simulation.is_over())
    simulation.advance(parameters.cycles);
  return simulation.results();
}

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

// OutputDirectory: results of different runs never mix, and nothing of the
// user's is touched. What must happen is stated in the class's documentation.

#include <deal.II/base/mpi.h>

#include <tribody/base/exceptions.h>
#include <tribody/output/output_directory.h>
#include <tribody/tables/table_writer.h>

#include <filesystem>
#include <fstream>
#include <iostream>

using namespace Tribody;
namespace fs = std::filesystem;

void
look_at(const std::string &path)
{
  try
    {
      const Output::OutputDirectory directory(path, MPI_COMM_SELF);
      std::cout << path << ": usable" << std::endl;
    }
  catch (const ExcInput &exception)
    {
      exception.print_info(std::cout);
    }
}

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  fs::remove_all("results");
  fs::remove_all("results.1");
  fs::remove_all("results.2");
  fs::remove_all("results.3");
  fs::remove_all("mine");

  for (unsigned int run = 0; run < 3; ++run)
    {
      Output::OutputDirectory directory("results", MPI_COMM_SELF);
      std::cout << "exists before create: " << fs::exists("results")
                << ", message: '" << directory.create() << "'" << std::endl;
      std::ofstream(directory.file("parameters.prm")) << run << std::endl;
      TableWriter table(directory.joint_file("pin", "table.csv"),
                        {"a comment"},
                        {"force [N]"});
      table.write_row({0.1 + run});
      table.finish();
    }
  for (const char *name : {"results.1", "results.2", "results"})
    {
      int run = -1;
      std::ifstream(fs::path(name) / "parameters.prm") >> run;
      std::cout << name << " holds run " << run << std::endl;
    }
  std::cout << std::ifstream("results/pin/table.csv").rdbuf();

  look_at("");
  fs::create_directory("mine");
  look_at("mine");
  std::ofstream("mine/thesis.tex") << "precious" << std::endl;
  look_at("mine");
  look_at("mine/thesis.tex");
  // A parameter file of the user's is no sign of a run.
  std::ofstream("mine/parameters.prm") << "set Cycles = 0" << std::endl;
  look_at("mine");
  look_at(".");

  // A parent that is a file.
  look_at("mine/thesis.tex/results");
  std::cout << Output::numbered_name("bushing", 42, "vtu") << std::endl;
}

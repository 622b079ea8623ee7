// SPDX-License-Identifier: LGPL-2.1-or-later

// OutputDirectory on several ranks: one that comes late must not take the
// directory that the first rank has made for that of another run; what is
// wrong with a directory is wrong on all ranks.

#include <deal.II/base/mpi.h>

#include <tribody/base/exceptions.h>
#include <tribody/output/output_directory.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <thread>

using namespace Tribody;
namespace fs = std::filesystem;

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int                             rank =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const unsigned int n_ranks =
    dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  if (rank == 0)
    {
      fs::remove_all("results");
      fs::remove_all("mine");
      fs::create_directory("mine");
      std::ofstream("mine/thesis.tex") << "precious" << std::endl;
    }
  MPI_Barrier(MPI_COMM_WORLD);

  int usable = 0;
  try
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(300 * rank));
      Output::OutputDirectory directory("results", MPI_COMM_WORLD);
      if (rank == 0)
        directory.create();
      // The lock is held until all of them have looked.
      usable = dealii::Utilities::MPI::sum(1, MPI_COMM_WORLD);
    }
  catch (const ExcInput &exception)
    {
      exception.print_info(std::cout);
      MPI_Abort(MPI_COMM_WORLD, 1);
    }

  int         refused = 0;
  std::string message;
  try
    {
      const Output::OutputDirectory directory("mine", MPI_COMM_WORLD);
    }
  catch (const ExcInput &exception)
    {
      refused = 1;
      message = message_of(exception);
    }
  message =
    dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD, message, n_ranks - 1);
  refused = dealii::Utilities::MPI::sum(refused, MPI_COMM_WORLD);
  if (rank == 0)
    std::cout << n_ranks << " ranks: usable on " << usable << ", refused on "
              << refused << ", the last one with '" << message << "'"
              << std::endl;
}

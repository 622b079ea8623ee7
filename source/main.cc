// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <Eigen/Core>

#include <tribody/base/console.h>
#include <tribody/base/exceptions.h>
#include <tribody/base/foreign_exceptions.h>
#include <tribody/base/interruption.h>
#include <tribody/base/ranks.h>
#include <tribody/run/command_line.h>

#include <exception>
#include <iostream>

int
main(int argc, char **argv)
{
  using namespace Tribody;

  // One thread per rank: results do not depend on the number of threads.
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Eigen::setNbThreads(1);
  const bool is_first_rank =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

  try
    {
      Console console(std::cout, is_first_rank);
      return Coupling::run_command_line({argv + 1, argv + argc},
                                        console,
                                        MPI_COMM_WORLD);
    }
  catch (const ExcInput &exception)
    {
      return Ranks::fail("Error in the input: " + message_of(exception),
                         2,
                         MPI_COMM_WORLD);
    }
  catch (const ExcInterrupted &interruption)
    {
      return Ranks::fail("The run was " + message_of(interruption) +
                           "; what it had reached is written.",
                         128 + interruption.signal,
                         MPI_COMM_WORLD);
    }
  catch (const dealii::ExceptionBase &exception)
    {
      return Ranks::fail("The run failed: " + message_of(exception),
                         1,
                         MPI_COMM_WORLD);
    }
  catch (const std::exception &exception)
    {
      return Ranks::fail("The run failed: " + describe_foreign(exception),
                         1,
                         MPI_COMM_WORLD);
    }
}

#include <deal.II/base/mpi.h>

#include <tribody/base/console.h>
#include <tribody/base/exceptions.h>
#include <tribody/coupling/command_line.h>

#include <exception>
#include <iostream>

int
main(int argc, char **argv)
{
  using namespace Tribody;

  // One thread per rank: results do not depend on the number of threads.
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool                                     is_first_rank =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

  const auto report = [is_first_rank](const std::string &message) {
    if (is_first_rank)
      std::cerr << message << std::endl;
  };

  try
    {
      Console console(is_first_rank);
      return Coupling::run_command_line({argv + 1, argv + argc},
                                        console,
                                        MPI_COMM_WORLD);
    }
  catch (const ExcInput &exception)
    {
      report("Error in the input: " + message_of(exception));
      return 2;
    }
  catch (const dealii::ExceptionBase &exception)
    {
      report("The run failed: " + message_of(exception));
      return 1;
    }
  catch (const std::exception &exception)
    {
      report(std::string("The run failed: ") + exception.what());
      return 1;
    }
}

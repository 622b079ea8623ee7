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

  const auto report = [is_first_rank](const std::string &kind,
                                      const auto        &print) {
    if (is_first_rank)
      {
        std::cerr << kind;
        print(std::cerr);
      }
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
      report("Error in the input:\n",
             [&](std::ostream &out) { exception.print_info(out); });
      return 2;
    }
  catch (const dealii::ExceptionBase &exception)
    {
      report("The run failed:\n",
             [&](std::ostream &out) { exception.print_info(out); });
      return 1;
    }
  catch (const std::exception &exception)
    {
      report("The run failed:\n",
             [&](std::ostream &out) { out << exception.what() << '\n'; });
      return 1;
    }
}

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_run_command_line_h
#define tribody_run_command_line_h

#include <mpi.h>
#include <string>
#include <vector>

namespace Tribody
{
  class Console;

  namespace Coupling
  {
    /**
     * What the user asked for: tribody [options] FILE.prm.
     * @param arguments without the program's name.
     * @return exit status 0.
     * @throws ExcInput for bad usage or input, ExcRun if the run fails.
     */
    int
    run_command_line(const std::vector<std::string> &arguments,
                     Console                        &console,
                     const MPI_Comm                 &communicator);
  } // namespace Coupling
} // namespace Tribody

#endif

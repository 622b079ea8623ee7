// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/config.h>

#include <sundials/sundials_config.h>

#include <tribody/base/version.h>

// Written by CMake: TRIBODY_VERSION and TRIBODY_REVISION.
#include "tribody_version.h"

namespace Tribody
{
  std::string
  program_version()
  {
    return TRIBODY_VERSION;
  }



  std::string
  program_revision()
  {
    return TRIBODY_REVISION;
  }



  std::string
  library_versions()
  {
    return "deal.II " DEAL_II_PACKAGE_VERSION ", Trilinos " +
           std::to_string(DEAL_II_TRILINOS_VERSION_MAJOR) + "." +
           std::to_string(DEAL_II_TRILINOS_VERSION_MINOR) + "." +
           std::to_string(DEAL_II_TRILINOS_VERSION_SUBMINOR) +
           ", SUNDIALS " SUNDIALS_VERSION;
  }
} // namespace Tribody

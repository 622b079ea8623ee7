// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_version_h
#define tribody_base_version_h

#include <string>

namespace Tribody
{
  /// "0.1.0".
  std::string
  program_version();

  /// Revision of the sources, "-dirty" behind it if they were changed, or
  /// "unknown" outside a checkout.
  std::string
  program_revision();

  /// Versions of deal.II, Trilinos and SUNDIALS, in one line.
  std::string
  library_versions();
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_foreign_exceptions_h
#define tribody_base_foreign_exceptions_h

#include <exception>
#include <string>

namespace Tribody
{
  /// What to tell the user of an exception that is not ours and that nobody has
  /// foreseen: memory that is lacking, a file with its path and the reason, else
  /// what it says itself.
  std::string
  describe_foreign(const std::exception &exception);
} // namespace Tribody

#endif

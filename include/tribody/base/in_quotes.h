// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_in_quotes_h
#define tribody_base_in_quotes_h

#include <string>

namespace Tribody
{
  /// @p text with control characters, which would command a terminal, and bytes
  /// that are no UTF-8 written as "\x1b". Line breaks and tabs stay.
  std::string
  printable(const std::string &text);

  /**
   * What a message repeats of a user's file or command line, in quotes:
   * printable(), in one line, and cut after some 60 characters: a file that was
   * named by mistake may hold secrets, or no line break.
   */
  std::string
  in_quotes(const std::string &text);
} // namespace Tribody

#endif

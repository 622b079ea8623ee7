// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_whole_file_h
#define tribody_base_whole_file_h

#include <functional>
#include <ostream>
#include <string>

namespace Tribody
{
  /// "Cannot write 'name': No space left on device.", with the words of the
  /// system for @p error, an errno.
  std::string
  describe_write_error(const std::string &file_name, const int error);

  /**
   * Write a file as a whole or not at all: what @p write says goes to a file
   * beside it, which takes its name when all of it is on the disk. A file of
   * that name is there in full, as it was before or as it is now, at every
   * moment.
   * @throws ExcRun with the name and the cause if the disk does not take it.
   */
  void
  write_whole_file(const std::string                         &file_name,
                   const std::function<void(std::ostream &)> &write);

  /// The same for what can only write to a file by itself: @p write gets the
  /// name of the one beside.
  void
  replace_file(const std::string                              &file_name,
               const std::function<void(const std::string &)> &write);

  /**
   * All bytes of a user's file; of one with more than @p max_n_bytes only
   * some, but more than those.
   * @param kind "parameter file", for messages.
   * @param place where the file is named, "case.prm:12: ", or empty.
   * @throws ExcInput if it cannot be read, or is no regular file: a device has
   *   no end, and a pipe perhaps no beginning.
   */
  std::string
  read_regular_file(const std::string &file_name,
                    const std::string &kind,
                    const std::string &place,
                    const std::size_t  max_n_bytes);
} // namespace Tribody

#endif

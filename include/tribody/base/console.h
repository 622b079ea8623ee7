// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_console_h
#define tribody_base_console_h

#include <boost/iostreams/filtering_stream.hpp>

#include <sstream>
#include <string>

namespace Tribody
{
  /**
   * What the user reads while the program runs: written to a stream, the screen
   * for example, and, once open_log() was called, to the log file too. Silent
   * on all ranks but the first.
   */
  class Console
  {
  public:
    /// @param screen must outlive this object.
    /// @param is_first_rank whether this rank writes at all.
    explicit Console(std::ostream &screen, const bool is_first_rank = true);

    /// From now on write to @p file_name as well, which begins with what was
    /// said before.
    /// @throws ExcRun if it cannot be written.
    void
    open_log(const std::string &file_name);

    /// The stream to write to.
    std::ostream &
    out()
    {
      return stream;
    }

  private:
    std::ostream &screen;
    bool          writes;
    /// For the beginning of the log.
    std::ostringstream                  said_before_log;
    boost::iostreams::filtering_ostream stream;
  };
} // namespace Tribody

#endif

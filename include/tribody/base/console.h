// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_console_h
#define tribody_base_console_h

#include <fstream>
#include <ostream>
#include <streambuf>
#include <string>

namespace Tribody
{
  /**
   * What the user reads while the program runs: written to a stream, the screen
   * for example, and, once open_log() was called, to the log file too. Silent
   * on all ranks but the first.
   *
   * A screen that takes no more, a closed pipe for example, ends neither the
   * run nor the log.
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

    /// Why the log lacks something that was said, or "".
    const std::string &
    log_error() const
    {
      return buffer.log_error;
    }

    /// The stream to write to.
    std::ostream &
    out()
    {
      return stream;
    }

  private:
    /// Passes on all it gets to screen and log.
    class Buffer : public std::streambuf
    {
    public:
      Buffer(std::ostream &screen, const bool writes);

      void
      open_log(const std::string &file_name);

      std::string log_error;

    protected:
      int_type
      overflow(const int_type c) override;

      std::streamsize
      xsputn(const char *text, const std::streamsize n) override;

      int
      sync() override;

    private:
      /// To the log, which is flushed.
      void
      write_to_log(const char *text, const std::streamsize n);

      std::ostream &screen;
      bool          writes;
      /// For the beginning of the log.
      std::string   said_before_log;
      std::string   log_name;
      std::ofstream log;
    };

    Buffer       buffer;
    std::ostream stream;
  };
} // namespace Tribody

#endif

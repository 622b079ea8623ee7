// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/console.h>
#include <tribody/base/exceptions.h>
#include <tribody/base/whole_file.h>

#include <cerrno>

namespace Tribody
{
  Console::Buffer::Buffer(std::ostream &screen, const bool writes)
    : screen(screen)
    , writes(writes)
  {}



  void
  Console::Buffer::open_log(const std::string &file_name)
  {
    if (!writes)
      return;
    log_name = file_name;
    errno    = 0;
    log.open(file_name);
    if (!log)
      log_error = describe_write_error(file_name, errno);
    else
      write_to_log(said_before_log.data(),
                   static_cast<std::streamsize>(said_before_log.size()));
    AssertThrow(log_error.empty(), ExcRun(log_error));
  }



  Console::Buffer::int_type
  Console::Buffer::overflow(const int_type c)
  {
    const char character = traits_type::to_char_type(c);
    xsputn(&character, 1);
    return traits_type::not_eof(c);
  }



  std::streamsize
  Console::Buffer::xsputn(const char *text, const std::streamsize n)
  {
    if (!writes)
      return n;
    screen.write(text, n);
    if (log.is_open())
      write_to_log(text, n);
    else
      said_before_log.append(text, n);
    return n;
  }



  int
  Console::Buffer::sync()
  {
    // Each line is to be seen at once, in a pipe too.
    if (writes)
      screen.flush();
    return 0;
  }



  void
  Console::Buffer::write_to_log(const char *text, const std::streamsize n)
  {
    errno = 0;
    log.write(text, n);
    log.flush();
    if (!log && log_error.empty())
      log_error = describe_write_error(log_name, errno);
    log.clear();
  }



  Console::Console(std::ostream &screen, const bool is_first_rank)
    : buffer(screen, is_first_rank)
    , stream(&buffer)
  {}



  void
  Console::open_log(const std::string &file_name)
  {
    buffer.open_log(file_name);
  }
} // namespace Tribody

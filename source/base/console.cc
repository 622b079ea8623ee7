// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/iostreams/device/file.hpp>
#include <boost/iostreams/device/null.hpp>
#include <boost/iostreams/tee.hpp>

#include <tribody/base/console.h>
#include <tribody/base/exceptions.h>

#include <fstream>

namespace Tribody
{
  Console::Console(std::ostream &screen, const bool is_first_rank)
    : screen(screen)
    , writes(is_first_rank)
  {
    if (writes)
      {
        // Each line is to be seen at once, in a pipe too.
        screen << std::unitbuf;
        stream.push(boost::iostreams::tee(said_before_log));
        stream.push(screen);
      }
    else
      stream.push(boost::iostreams::null_sink());
  }



  void
  Console::open_log(const std::string &file_name)
  {
    if (!writes)
      return;

    stream.flush();
    std::ofstream begin(file_name);
    begin << said_before_log.str() << std::flush;
    AssertThrow(begin,
                ExcRun("Cannot write the log file '" + file_name + "'."));
    begin.close();

    stream.reset();
    stream.push(boost::iostreams::tee(
      boost::iostreams::file_sink(file_name, std::ios_base::app)));
    stream.push(screen);
  }
} // namespace Tribody

#include <boost/iostreams/device/file.hpp>
#include <boost/iostreams/tee.hpp>

#include <tribody/base/console.h>
#include <tribody/base/exceptions.h>

#include <iostream>

namespace Tribody
{
  Console::Console(const bool is_first_rank)
    : writes(is_first_rank)
  {
    if (writes)
      stream.push(std::cout);
    else
      stream.push(boost::iostreams::null_sink());
  }



  void
  Console::open_log(const std::string &file_name)
  {
    if (!writes)
      return;

    const boost::iostreams::file_sink log(file_name);
    AssertThrow(log.is_open(),
                ExcRun("Cannot write the log file '" + file_name + "'."));
    stream.flush();
    stream.reset();
    stream.push(boost::iostreams::tee(log));
    stream.push(std::cout);
  }
} // namespace Tribody

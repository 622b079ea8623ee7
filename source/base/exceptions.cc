// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/algorithm/string/trim.hpp>

#include <tribody/base/exceptions.h>

#include <sstream>

namespace Tribody
{
  std::string
  message_of(const dealii::ExceptionBase &exception)
  {
    std::ostringstream text;
    exception.print_info(text);
    return boost::algorithm::trim_copy(text.str());
  }
} // namespace Tribody

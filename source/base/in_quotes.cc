// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/locale/utf.hpp>

#include <tribody/base/in_quotes.h>

#include <iomanip>
#include <sstream>

namespace Tribody
{
  namespace
  {
    // Of a foreign text, in characters.
    constexpr std::size_t max_repeated = 60;



    bool
    is_line_break_or_tab(const boost::locale::utf::code_point c)
    {
      return c == '\n' || c == '\t';
    }



    // The two ranges of control characters of Unicode, and the marks that turn
    // the direction of what follows.
    bool
    is_control(const boost::locale::utf::code_point c)
    {
      return c < 0x20 || (c >= 0x7f && c < 0xa0) ||
             (c >= 0x202a && c < 0x202f) || (c >= 0x2066 && c < 0x206a);
    }



    // At most @p max_length characters of @p text.
    std::string
    escape(const std::string &text,
           const std::size_t  max_length,
           const bool         keeps_lines)
    {
      using Decoder = boost::locale::utf::utf_traits<char>;
      std::ostringstream out;
      out << std::hex << std::setfill('0');
      std::size_t length = 0;
      for (auto place = text.begin(); place != text.end(); ++length)
        {
          if (length == max_length)
            {
              out << "...";
              break;
            }
          const auto start    = place;
          const auto c        = Decoder::decode(place, text.end());
          const bool is_valid = c != boost::locale::utf::illegal &&
                                c != boost::locale::utf::incomplete;
          if (is_valid &&
              (!is_control(c) || (keeps_lines && is_line_break_or_tab(c))))
            out << std::string(start, place);
          else
            {
              // Behind a wrong byte the next character may begin.
              place = is_valid ? place : start + 1;
              for (auto byte = start; byte != place; ++byte)
                out << "\\x" << std::setw(2)
                    << static_cast<unsigned int>(
                         static_cast<unsigned char>(*byte));
            }
        }
      return out.str();
    }
  } // namespace



  std::string
  printable(const std::string &text)
  {
    return escape(text, std::string::npos, true);
  }



  std::string
  in_quotes(const std::string &text)
  {
    return "'" + escape(text, max_repeated, false) + "'";
  }
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_significant_digits_h
#define tribody_base_significant_digits_h

#include <cstdlib>
#include <iomanip>
#include <sstream>
#include <string>

namespace Tribody
{
  /// @p value rounded to @p n_digits digits, at most 6, for messages: what
  /// was computed need not be read to the last one.
  inline std::string
  significant_digits(const double value, const int n_digits = 3)
  {
    std::ostringstream rounded, out;
    rounded << std::setprecision(n_digits) << value;
    // Once more, so that 1574 becomes 1570 and not 1.57e+03. Not std::stod(),
    // which throws where a number is too small for all of its digits.
    out << std::strtod(rounded.str().c_str(), nullptr);
    return out.str();
  }
} // namespace Tribody

#endif

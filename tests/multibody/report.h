// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_multibody_report_h
#define tests_multibody_report_h

#include <iomanip>
#include <iostream>
#include <string>

/// Print whether @p value is below @p bound; the value itself only if not, so
/// that the output does not depend on rounding.
inline void
report_below(const std::string &what, const double value, const double bound)
{
  std::cout << what << ": ";
  if (value < bound)
    std::cout << "below " << bound << std::endl;
  else
    std::cout << value << ", NOT below " << bound << std::endl;
}

/// Print @p value with @p digits behind the point.
inline void
report_value(const std::string &what, const double value, const int digits)
{
  std::cout << what << ": " << std::fixed << std::setprecision(digits) << value
            << std::defaultfloat << std::setprecision(6) << std::endl;
}

#endif

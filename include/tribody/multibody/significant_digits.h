#ifndef tribody_multibody_significant_digits_h
#define tribody_multibody_significant_digits_h

#include <iomanip>
#include <sstream>
#include <string>

namespace Tribody
{
  namespace Multibody
  {
    /// @p value with @p n_digits digits, for messages: what was computed need
    /// not be read to the last digit.
    inline std::string
    significant_digits(const double value, const int n_digits = 3)
    {
      std::ostringstream out;
      out << std::setprecision(n_digits) << value;
      return out.str();
    }
  } // namespace Multibody
} // namespace Tribody

#endif

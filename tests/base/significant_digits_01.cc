// SPDX-License-Identifier: LGPL-2.1-or-later

// Numbers for messages. Known: rounding to three digits; what is so small that
// a double has not all of its digits, infinite or no number at all is written
// too.

#include <tribody/base/significant_digits.h>

#include <cmath>
#include <fstream>
#include <limits>

int
main()
{
  using Tribody::significant_digits;
  std::ofstream output("output");
  for (const double value : {1574.,
                             -0.0012345,
                             1e-310,
                             0.,
                             std::numeric_limits<double>::infinity(),
                             std::nan("")})
    output << "'" << significant_digits(value) << "'\n";
}

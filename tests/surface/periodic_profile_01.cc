// SPDX-License-Identifier: LGPL-2.1-or-later

// A profile around the bore at angles as an integration or Newton's method may
// try them. Known: it is the same after a turn; of an angle that is not finite
// nothing is known, and no exception says so, for the step is taken again.

#include <tribody/surface/periodic_profile.h>

#include <cmath>
#include <fstream>
#include <limits>

int
main()
{
  using Tribody::PeriodicProfile;
  const Eigen::VectorXd angles =
    Eigen::VectorXd::LinSpaced(72, 0., 2. * M_PI * 71. / 72.);
  const PeriodicProfile profile(angles, angles.array().sin());

  std::ofstream output("output");
  const double  change = profile.value(1. + 2. * M_PI) - profile.value(1.);
  output << "the same after a turn: " << (std::abs(change) < 1e-12) << '\n';
  for (const double angle :
       {std::nan(""), std::numeric_limits<double>::infinity()})
    {
      const PeriodicProfile::Values at = profile.evaluate(angle);
      output << "no number at " << angle << ": "
             << (std::isnan(profile.value(angle)) && std::isnan(at.value) &&
                 std::isnan(at.first_derivative) &&
                 std::isnan(at.second_derivative))
             << '\n';
    }
}

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/cycle/settling_monitor.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    void
    SettlingMonitor::add(const std::vector<RepeatingQuantity> &cycle)
    {
      std::vector<Eigen::Matrix2Xd> changes;
      if (!last.empty())
        {
          the_difference = 0.;
          the_distance   = last_changes.empty() ? infinity : 0.;
          the_decay      = 0.;
        }
      for (std::size_t i = 0; i < last.size(); ++i)
        {
          changes.push_back(cycle[i].values - last[i].values);
          if (cycle[i].scale <= 0.)
            continue;
          const double change =
            changes[i].colwise().norm().maxCoeff() / cycle[i].scale;
          the_difference = std::max(the_difference, change);
          if (last_changes.empty() || change == 0.)
            continue;
          // Without any change before, there is nothing to decay.
          const double square = last_changes[i].squaredNorm();
          const double lambda =
            square > 0.
              ? changes[i].cwiseProduct(last_changes[i]).sum() / square
              : 0.;
          const double ratio =
            square > 0. ? changes[i].squaredNorm() / square : 0.;
          const double distance =
            change / std::sqrt(std::clamp(1. - 2. * lambda + ratio, 0., 1.));
          if (distance > the_distance)
            {
              the_distance = distance;
              the_decay    = lambda;
            }
        }
      last         = cycle;
      last_changes = changes;
    }
  } // namespace Multibody
} // namespace Tribody

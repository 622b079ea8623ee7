// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/significant_digits.h>
#include <tribody/base/units.h>
#include <tribody/run/deviation_limits.h>

#include <algorithm>
#include <limits>

namespace Tribody
{
  namespace Coupling
  {
    DeviationLimits::DeviationLimits(
      const std::vector<Multibody::WatchedMarkerParameters> &markers)
      : markers(markers)
    {}



    bool
    DeviationLimits::are_set() const
    {
      return std::any_of(markers.begin(),
                         markers.end(),
                         [](const auto &marker) {
                           return marker.deviation_limit > 0.;
                         });
    }



    DeviationLimits::Worst
    DeviationLimits::find_worst(const Multibody::DutyCycle &cycle) const
    {
      AssertDimension(cycle.watched_paths.size(), markers.size());
      Worst worst = {0, -std::numeric_limits<double>::infinity()};
      for (std::size_t m = 0; m < markers.size(); ++m)
        if (const double limit = markers[m].deviation_limit; limit > 0.)
          {
            const double excess =
              cycle.watched_paths[m].largest_deviation() / limit - 1.;
            if (excess > worst.excess)
              worst = {m, excess};
          }
      return worst;
    }



    double
    DeviationLimits::excess(const Multibody::DutyCycle &cycle) const
    {
      return find_worst(cycle).excess;
    }



    std::string
    DeviationLimits::describe(const Multibody::DutyCycle &cycle) const
    {
      const Multibody::WatchedMarkerParameters &marker =
        markers[find_worst(cycle).marker];
      return marker.name + ": deviation " +
             Units::to_string(marker.deviation_limit, "m", "mm");
    }



    void
    DeviationLimits::check_start(const Multibody::DutyCycle &cycle) const
    {
      const Worst worst = find_worst(cycle);
      if (worst.excess < 0.)
        return;
      const double deviation =
        cycle.watched_paths[worst.marker].largest_deviation();
      throw ExcRun(
        "Watched marker " + markers[worst.marker].name +
        ": 'Stop at deviation' = " +
        Units::to_string(markers[worst.marker].deviation_limit, "m", "mm") +
        " is passed before any wear: with its new joints the "
        "mechanism lets it deviate by " +
        significant_digits(1e3 * deviation, 4) +
        " mm. Set a larger limit, or 0 for none");
    }
  } // namespace Coupling
} // namespace Tribody

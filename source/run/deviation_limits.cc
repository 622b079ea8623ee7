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
    DeviationLimits::find_worst(
      const std::vector<Multibody::DutyCycle> &cycles) const
    {
      Worst worst = {0, 0., -std::numeric_limits<double>::infinity()};
      for (const Multibody::DutyCycle &cycle : cycles)
        for (std::size_t m = 0; m < markers.size(); ++m)
          if (const double limit = markers[m].deviation_limit; limit > 0.)
            {
              AssertIndexRange(m, cycle.watched_paths.size());
              const double deviation =
                cycle.watched_paths[m].largest_deviation();
              const double excess = deviation / limit - 1.;
              if (excess > worst.excess)
                worst = {m, deviation, excess};
            }
      return worst;
    }



    double
    DeviationLimits::excess(
      const std::vector<Multibody::DutyCycle> &cycles) const
    {
      return find_worst(cycles).excess;
    }



    std::string
    DeviationLimits::describe(
      const std::vector<Multibody::DutyCycle> &cycles) const
    {
      const Multibody::WatchedMarkerParameters &marker =
        markers[find_worst(cycles).marker];
      return marker.name + ": deviation " +
             Units::to_string(marker.deviation_limit, "m", "mm");
    }



    void
    DeviationLimits::check_start(
      const std::vector<Multibody::DutyCycle> &cycles) const
    {
      const Worst worst = find_worst(cycles);
      if (worst.excess < 0.)
        return;
      throw ExcRun(
        "Watched marker " + markers[worst.marker].name +
        ": 'Stop at deviation' = " +
        Units::to_string(markers[worst.marker].deviation_limit, "m", "mm") +
        " is passed before any wear: with its new joints the "
        "mechanism lets it deviate by " +
        significant_digits(1e3 * worst.deviation, 4) +
        " mm. Set a larger limit, or 0 for none");
    }
  } // namespace Coupling
} // namespace Tribody

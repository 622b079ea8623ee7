// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/elements/smoothness.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      constexpr unsigned int n_steps = 4096, n_followed = 32, n_halvings = 16;

      // Of the grid's largest slope.
      constexpr double kink = 1e-4, jump = 100.;

      // Go to the centre of the largest of the second differences over half the
      // step around @p time.
      double
      follow(const std::function<double(const double)> &function,
             const double                               time,
             const double                               step)
      {
        double best = time, largest = -1.;
        for (const double t : {time - step, time, time + step})
          {
            const double difference = std::abs(
              function(t - step) - 2. * function(t) + function(t + step));
            if (difference > largest)
              {
                largest = difference;
                best    = t;
              }
          }
        return best;
      }
    } // namespace



    std::optional<Roughness>
    find_roughness(const std::function<double(const double)> &function,
                   const double                               begin,
                   const double                               end)
    {
      const double        step = (end - begin) / n_steps;
      std::vector<double> values(n_steps + 1);
      for (unsigned int k = 0; k <= n_steps; ++k)
        values[k] = function(begin + k * step);
      double slope = 0., size = 0.;
      for (unsigned int k = 0; k < n_steps; ++k)
        {
          slope = std::max(slope, std::abs(values[k + 1] - values[k]) / step);
          size  = std::max(size, std::abs(values[k]));
        }

      const auto difference = [&](const unsigned int k) {
        return std::abs(values[k - 1] - 2. * values[k] + values[k + 1]);
      };
      std::vector<unsigned int> places;
      for (unsigned int k = 1; k < n_steps; ++k)
        places.push_back(k);
      std::partial_sort(places.begin(),
                        places.begin() + n_followed,
                        places.end(),
                        [&](const unsigned int a, const unsigned int b) {
                          return difference(a) > difference(b);
                        });

      std::optional<Roughness> worst;
      double                   largest = 0.;
      for (unsigned int i = 0; i < n_followed; ++i)
        {
          double t = begin + places[i] * step, h = step;
          for (unsigned int k = 0; k < n_halvings; ++k)
            {
              h /= 2.;
              t = follow(function, t, h);
            }
          const double left   = (function(t) - function(t - h)) / h;
          const double right  = (function(t + h) - function(t)) / h;
          const double change = std::abs(right - left);
          // What roundings of t and of the values amount to.
          const double noise = 16. * std::numeric_limits<double>::epsilon() *
                               (size + slope * std::abs(end)) / h;
          if (change > kink * slope + noise && change > largest)
            {
              largest = change;
              worst   = Roughness{t,
                                std::max(std::abs(left), std::abs(right)) >
                                  jump * slope};
            }
        }
      return worst;
    }
  } // namespace Multibody
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/elements/time_function.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // Offsets of the differences in units of the step.
      constexpr int n_offsets = 4;

      struct Derivatives
      {
        double first, second;
      };

      // Central differences from the values at offsets 0 and +-1, +-2, ...
      template <std::size_t n>
      Derivatives
      differentiate(const std::array<double, n> &first_weights,
                    const std::array<double, n> &second_weights,
                    const double                 centre_weight,
                    const double                 centre,
                    const double                *plus,
                    const double                *minus,
                    const double                 h)
      {
        Derivatives result = {0., centre_weight * centre};
        for (std::size_t i = 0; i < n; ++i)
          {
            result.first += first_weights[i] * (plus[i] - minus[i]);
            result.second += second_weights[i] * (plus[i] + minus[i]);
          }
        return {result.first / h, result.second / (h * h)};
      }

      // The value at the offset of @p x steps that the polynomial through all
      // points has: a fast function that is only sampled to look like a slow
      // one gives itself away there.
      double
      interpolate(const double  x,
                  const double  centre,
                  const double *plus,
                  const double *minus)
      {
        double result = 0.;
        for (int i = -n_offsets; i <= n_offsets; ++i)
          {
            double term = centre;
            if (i != 0)
              term = i > 0 ? plus[i - 1] : minus[-i - 1];
            for (int j = -n_offsets; j <= n_offsets; ++j)
              if (j != i)
                term *= (x - j) / (i - j);
            result += term;
          }
        return result;
      }

      Derivatives
      sixth_order(const double  centre,
                  const double *plus,
                  const double *minus,
                  const double  h)
      {
        return differentiate<3>({{3. / 4, -3. / 20, 1. / 60}},
                                {{3. / 2, -3. / 20, 1. / 90}},
                                -49. / 18,
                                centre,
                                plus,
                                minus,
                                h);
      }

      Derivatives
      eighth_order(const double  centre,
                   const double *plus,
                   const double *minus,
                   const double  h)
      {
        return differentiate<4>({{4. / 5, -1. / 5, 4. / 105, -1. / 280}},
                                {{8. / 5, -1. / 5, 8. / 315, -1. / 560}},
                                -205. / 72,
                                centre,
                                plus,
                                minus,
                                h);
      }
    } // namespace



    TimeFunction::TimeFunction(const std::string &path,
                               const std::string &expression)
      : expression(path,
                   expression,
                   {{{"t"}},
                    {{"s"}},
                    "the time t in seconds",
                    "'sin(2*pi*t)' or 'if(t < 0.1, 10*t, 1)'"})
    {}



    double
    TimeFunction::value(const double t) const
    {
      if (table)
        return table->value(t);
      const dealii::Point<1> place(t);
      const double           result = expression.value(place);
      if (!std::isfinite(result))
        throw expression.error_at(place, "is not a finite number");
      return result;
    }



    std::array<double, 2>
    TimeFunction::derivatives(const double t) const
    {
      if (table)
        return table->derivatives(t);
      if (expression.is_constant())
        return {{0., 0.}};
      const auto evaluate = [this](const double at) {
        return expression.value(dealii::Point<1>(at));
      };
      // Eighth-order differences at (w h)^8 = 1e-12 * 560 have an error of
      // 2e-13 F w^2 and lose about as much to rounding. The second derivative
      // decides because it sees the value at t itself: a narrow pulse between
      // the outer points escapes the first.
      constexpr double agreement = 1e-12, between_points = 0.382;
      const double     centre = value(t);
      Derivatives      best   = {std::nan(""), std::nan("")};
      for (double h = 0.1; h > 5e-8; h /= 4)
        {
          double plus[n_offsets], minus[n_offsets];
          double largest = std::abs(centre);
          for (int i = 0; i < n_offsets; ++i)
            {
              plus[i]  = evaluate(t + (i + 1) * h);
              minus[i] = evaluate(t - (i + 1) * h);
              largest =
                std::max({largest, std::abs(plus[i]), std::abs(minus[i])});
            }
          const Derivatives sixth  = sixth_order(centre, plus, minus, h);
          const Derivatives eighth = eighth_order(centre, plus, minus, h);
          if (!std::isfinite(eighth.second))
            continue;
          best = eighth;
          if (std::abs(eighth.second - sixth.second) * h * h <=
                agreement * largest &&
              std::abs(evaluate(t + between_points * h) -
                       interpolate(between_points, centre, plus, minus)) <=
                10 * agreement * largest)
            break;
        }
      if (!std::isfinite(best.second))
        throw expression.error_at(dealii::Point<1>(t), "has no derivative");
      return {{best.first, best.second}};
    }
  } // namespace Multibody
} // namespace Tribody

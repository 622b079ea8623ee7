// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/wear/coefficient_factor.h>

#include <cmath>

namespace Tribody
{
  namespace Wear
  {
    FactorValue
    RunningIn::evaluate(const double, const Sliding &sliding) const
    {
      return {1. +
                (initial_factor - 1.) * std::exp(-sliding.distance / distance),
              0.};
    }



    FactorExpression::FactorExpression(const std::string &path,
                                       const std::string &expression)
      : expression(path,
                   expression,
                   {{{"p", "v", "s", "T"}},
                    {{"Pa", "m/s", "m", "K"}},
                    "the pressure p in Pa, the sliding speed v in m/s, the "
                    "distance s slid so far in m and the temperature T in K",
                    "'(p/1e6)^0.5' or '1 + 2*exp(-s/100)'"})
    {}



    double
    FactorExpression::value(const double pressure, const Sliding &sliding) const
    {
      dealii::Point<4> place;
      place[0]            = pressure;
      place[1]            = sliding.speed;
      place[2]            = sliding.distance;
      place[3]            = sliding.temperature;
      const double result = expression.value(place);
      if (!(result >= 0. && std::isfinite(result)))
        throw expression.error_at(place, "is negative or not a finite number");
      return result;
    }



    FactorValue
    FactorExpression::evaluate(const double   pressure,
                               const Sliding &sliding) const
    {
      constexpr double step = 1e-5;
      return {value(pressure, sliding),
              (value((1. + step) * pressure, sliding) -
               value((1. - step) * pressure, sliding)) /
                (2. * step * pressure)};
    }



    FactorValue
    evaluate_factor(const CoefficientFactor &factor,
                    const double             pressure,
                    const Sliding           &sliding)
    {
      return std::visit(
        [&](const auto &f) { return f.evaluate(pressure, sliding); }, factor);
    }



    bool
    depends_on_temperature(const CoefficientFactor &factor)
    {
      return std::visit(
        [](const auto &f) { return f.depends_on_temperature(); }, factor);
    }
  } // namespace Wear
} // namespace Tribody

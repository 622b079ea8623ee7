// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>

#include <tribody/base/exceptions.h>
#include <tribody/wear/coefficient_factor.h>

#include <cmath>
#include <iostream>
#include <sstream>

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



    struct FactorExpression::Parser
    {
      dealii::FunctionParser<3> function;
    };



    FactorExpression::FactorExpression(const std::string &path,
                                       const std::string &expression)
      : path(path)
    {
      const auto made = std::make_shared<Parser>();
      // deal.II writes the parser's words to the screen and then throws.
      std::ostringstream    words;
      std::streambuf *const to_screen = std::cerr.rdbuf(words.rdbuf());
      try
        {
          made->function.initialize("p,v,s",
                                    expression,
                                    {{"pi", dealii::numbers::PI}});
          // The first evaluation builds the parser of this thread.
          made->function.value(dealii::Point<3>(1., 1., 1.));
          std::cerr.rdbuf(to_screen);
        }
      catch (const std::exception &)
        {
          std::cerr.rdbuf(to_screen);
          throw ExcParameter(
            path,
            "'" + expression +
              "' is not an expression of the pressure p in Pa, the sliding "
              "speed v in m/s and the distance s slid so far in m. Write for "
              "example '(p/1e6)^0.5' or '1 + 2*exp(-s/100)'; known are + - * / "
              "^, exp, log, sqrt, abs, min, max, if and the constant pi");
        }
      parser = made;
    }



    double
    FactorExpression::value(const double pressure, const Sliding &sliding) const
    {
      const double result = parser->function.value(
        dealii::Point<3>(pressure, sliding.speed, sliding.distance));
      if (result >= 0. && std::isfinite(result))
        return result;
      std::ostringstream place;
      place << "p = " << pressure << " Pa, v = " << sliding.speed
            << " m/s, s = " << sliding.distance << " m";
      throw ExcRun(path + " is negative or not a finite number at " +
                   place.str());
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
  } // namespace Wear
} // namespace Tribody

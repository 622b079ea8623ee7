// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_time_function_h
#define tribody_multibody_elements_time_function_h

#include <tribody/base/expression.h>

#include <array>
#include <string>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * A dimensionless function of the time t in seconds, written as an
     * Expression: "sin(2*pi*t)".
     */
    class TimeFunction
    {
    public:
      /// The constant 1.
      TimeFunction()
        : expression(1.)
      {}

      /// @param path the parameter that holds the @p expression, for
      ///   messages. @throws ExcParameter for what cannot be parsed.
      TimeFunction(const std::string &path, const std::string &expression);

      /// f(t). @throws ExcRun if it is not a finite number.
      double
      value(const double t) const;

      /**
       * f' and f'' by central differences of eighth order, from t - 4 h to
       * t + 4 h. From 0.1 s, the step h is divided by 4 until those of sixth
       * order agree, and a value between the points too. For a function whose
       * fastest part has the amplitude F and angular frequency w (at least
       * 1 rad/s), the errors are below 2e-11 F w and 1e-9 F w^2 while
       * w t < 1000; beyond, the rounding of t itself adds to them. It must be
       * smooth: across a kink, h falls to 0.1 us. @throws ExcRun where it has
       * no finite values.
       */
      std::array<double, 2>
      derivatives(const double t) const;

    private:
      Expression<1> expression;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

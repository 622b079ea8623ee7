// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_time_function_h
#define tribody_multibody_elements_time_function_h

#include <tribody/base/expression.h>
#include <tribody/tables/periodic_table.h>

#include <array>
#include <memory>
#include <string>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * A function of the time t in seconds: a dimensionless one that is written
     * as an Expression, "sin(2*pi*t)", or a PeriodicTable in SI units. A plain
     * value; copies share the table.
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

      /// Values of a table.
      explicit TimeFunction(const PeriodicTable &table)
        : expression(0.)
        , table(std::make_shared<const PeriodicTable>(table))
      {}

      /// After which time it repeats itself, as far as that is known [s]: that
      /// of a table; 0 for an expression.
      double
      period() const
      {
        return table ? table->period() : 0.;
      }

      /// f(t). @throws ExcRun if it is not a finite number.
      double
      value(const double t) const;

      /**
       * f' and f''. Those of a table are exact. Those of an expression come
       * from central differences of eighth order, from t - 4 h to t + 4 h. From
       * 0.1 s, the step h is divided by 4 until those of sixth order agree, and
       * a value between the points too. For a function whose fastest part has
       * the amplitude F and angular frequency w (at least 1 rad/s), the errors
       * are below 2e-11 F w and 1e-9 F w^2 while w t < 1000; beyond, the
       * rounding of t itself adds to them. It must be smooth: across a kink, h
       * falls to 0.1 us. @throws ExcRun where it has no finite values.
       */
      std::array<double, 2>
      derivatives(const double t) const;

    private:
      Expression<1> expression;
      // Instead of the expression, if there is one.
      std::shared_ptr<const PeriodicTable> table;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

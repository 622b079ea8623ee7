// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_wear_coefficient_factor_h
#define tribody_wear_coefficient_factor_h

#include <tribody/base/expression.h>
#include <tribody/wear/coefficient_table.h>
#include <tribody/wear/factor_value.h>

#include <string>
#include <variant>

namespace Tribody
{
  namespace Wear
  {
    /**
     * Running-in: fresh surfaces wear f_0 times as fast as later ones,
     * @f[ f = 1 + (f_0 - 1) \exp(-s/s_0). @f]
     * Over a distance S under a constant load this adds the wear of
     * @f$ (f_0 - 1)\,s_0\,(1 - \exp(-S/s_0)) @f$ more of sliding.
     */
    struct RunningIn
    {
      /// f_0 [-], not negative.
      double initial_factor = 1.;
      /// s_0 [m], positive.
      double distance = 1.;

      /// f at the distance slid before; the @p pressure does not matter.
      FactorValue
      evaluate(const double pressure, const Sliding &sliding) const;

      /// It does not.
      bool
      depends_on_temperature() const
      {
        return false;
      }
    };

    /**
     * A dimensionless function f(p, v, s, T) of pressure [Pa], sliding speed
     * [m/s], the distance slid so far [m] and the temperature of the contact
     * [K], written as an Expression: "(p/1e6)^0.5", "if(v < 0.1, 1, 2)",
     * "exp((T - 293.15)/40)". It must be smooth in
     * p, or the implicit wear steps do not converge; its derivative is a
     * central difference over 2e-5 p, good to about 1e-9 of f/p.
     */
    class FactorExpression
    {
    public:
      /// @param path the parameter that holds the @p expression, for messages.
      /// @throws ExcParameter for what cannot be parsed.
      FactorExpression(const std::string &path, const std::string &expression);

      /// @throws ExcRun if it is negative or not a finite number.
      FactorValue
      evaluate(const double pressure, const Sliding &sliding) const;

      /// Whether it has the temperature.
      bool
      depends_on_temperature() const
      {
        return expression.contains("T");
      }

      /// Whether it is the number one, so that nothing is multiplied.
      bool
      is_one() const
      {
        return expression.is_one();
      }

    private:
      double
      value(const double pressure, const Sliding &sliding) const;

      Expression<4> expression;
    };

    /// What a wear coefficient may be multiplied by. A new wear law is one more
    /// of these: a struct with these two functions, and a line in
    /// BushingParameters::make_wear_law().
    using CoefficientFactor =
      std::variant<RunningIn, FactorExpression, CoefficientTable>;

    /// At @p pressure [Pa], positive.
    FactorValue
    evaluate_factor(const CoefficientFactor &factor,
                    const double             pressure,
                    const Sliding           &sliding);

    /// Whether a change of the temperature would change it.
    bool
    depends_on_temperature(const CoefficientFactor &factor);
  } // namespace Wear
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_thermal_heat_parameters_h
#define tribody_thermal_heat_parameters_h

#include <tribody/base/choice.h>
#include <tribody/base/expression.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  struct Material;

  namespace Thermal
  {
    /// Whether a joint gets warm; steady: as after a long time under the mean
    /// power of friction.
    enum class TemperatureModel
    {
      none,
      steady
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<TemperatureModel>
    choice_names(const TemperatureModel)
    {
      return {{TemperatureModel::none, "none"},
              {TemperatureModel::steady, "steady"}};
    }

    /// Where heat leaves a bushing: through its rim into something that has
    /// the ambient temperature, or over a resistance to that; or nowhere.
    enum class RimCooling
    {
      ambient,
      transfer,
      insulated
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<RimCooling>
    choice_names(const RimCooling)
    {
      return {{RimCooling::ambient, "at ambient temperature"},
              {RimCooling::transfer, "heat transfer"},
              {RimCooling::insulated, "insulated"}};
    }

    /// How a joint gets warm, and what that changes.
    struct HeatParameters
    {
      /// Decides whether the values below count.
      TemperatureModel temperature = TemperatureModel::none;
      /// What is at the rim.
      RimCooling rim = RimCooling::ambient;
      /// Of 'heat transfer' [W/(m^2 K)]; 0: not given.
      double heat_transfer_coefficient = 0.;
      /// Instead, from the whole rim to the surroundings [K/W]; 0: not given.
      double thermal_resistance = 0.;
      /// Through the pin and its shaft to the surroundings [W/K].
      double shaft_conductance = 0.;
      /// At which bore and pin have the radii of the joint [K].
      double reference_temperature = 293.15;
      /// What multiplies Young's modulus of the bushing: an expression of T.
      std::string modulus_factor = "1";
      /// The same for the friction coefficients of the joint.
      std::string friction_factor = "1";
      /// Between two rounds of motion, contact and temperature, below which
      /// they agree [K].
      double tolerance = 0.1;

      /// Declares in the current subsection, "Heat".
      void
      add_parameters(dealii::ParameterHandler &prm);

      /**
       * @param path of the subsection, "Bushing <name>/Heat".
       * @param bushing its material.
       * @throws ExcParameter also where heat has no way out.
       */
      void
      check(const std::string &path, const Material &bushing) const;

      /// Whether the joint gets warm.
      bool
      is_on() const
      {
        return temperature != TemperatureModel::none;
      }
    };

    /// A factor that depends on the temperature in K.
    class TemperatureFactor
    {
    public:
      /// @param path the parameter that holds the @p expression, for messages.
      /// @throws ExcParameter for what cannot be parsed.
      TemperatureFactor(const std::string &path, const std::string &expression);

      /// At @p temperature [K].
      /// @throws ExcRun if it is not positive or not a finite number.
      double
      value(const double temperature) const;

      /// Whether it is the number one.
      bool
      is_one() const
      {
        return expression.is_one();
      }

    private:
      Expression<1> expression;
    };
  } // namespace Thermal
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/parameter_handler.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/in_quotes.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/material/material.h>
#include <tribody/thermal/heat_parameters.h>

#include <cmath>

namespace Tribody
{
  namespace Thermal
  {
    namespace
    {
      void
      add_paths_of_heat(dealii::ParameterHandler &prm, HeatParameters &p)
      {
        Parameters::add_choice(
          prm,
          "Rim",
          p.rim,
          "How heat leaves the bushing: a rim 'at ambient temperature'; 'heat "
          "transfer' from there to the surroundings, with one of the two "
          "values below; 'insulated', where all heat leaves through the "
          "shaft.");
        Parameters::add_quantity(prm,
                                 "Heat transfer coefficient",
                                 p.heat_transfer_coefficient,
                                 "W/(m^2 K)",
                                 "Of 'heat transfer': flux through the rim "
                                 "over what it is warmer than the "
                                 "surroundings.");
        Parameters::add_quantity(prm,
                                 "Thermal resistance",
                                 p.thermal_resistance,
                                 "K/W",
                                 "Instead: what the rim is warmer over the "
                                 "power that leaves through all of it.");
        Parameters::add_quantity(
          prm,
          "Shaft conductance",
          p.shaft_conductance,
          "W/K",
          "Power that leaves through pin and shaft to the surroundings, over "
          "what the contact is warmer than these; 0: none. Of a shaft of the "
          "section A it is lambda A over the length to something cold.");
      }



      // "1 - 0.01*(T - 293.15)".
      const ExpressionVariables<1> &
      variables()
      {
        static const ExpressionVariables<1> result = {
          {{"T"}},
          {{"K"}},
          "the temperature T in K",
          "'1 - 0.005*(T - 293.15)' or 'exp(-(T - 293.15)/60)'"};
        return result;
      }



      // The rim as its kind wants it.
      void
      check_rim(const std::string &path, const HeatParameters &p)
      {
        const bool has_coefficient = p.heat_transfer_coefficient > 0.,
                   has_resistance  = p.thermal_resistance > 0.;
        AssertThrow(
          p.rim != RimCooling::transfer || has_coefficient != has_resistance,
          ExcParameter(path + "/Heat transfer coefficient",
                       has_coefficient
                         ? "is given and 'Thermal resistance' too; one of "
                           "them says how heat leaves the rim"
                         : "'Rim = heat transfer' needs a positive 'Heat "
                           "transfer coefficient' or 'Thermal resistance'"));
        AssertThrow(
          p.rim == RimCooling::transfer ||
            (!has_coefficient && !has_resistance),
          ExcParameter(path + "/Rim",
                       "is '" + name_of(p.rim) +
                         "', but a 'Heat transfer coefficient' or 'Thermal "
                         "resistance' is given; write 'set Rim = heat "
                         "transfer'"));
        AssertThrow(p.rim != RimCooling::insulated || p.shaft_conductance > 0.,
                    ExcParameter(path + "/Rim",
                                 "is 'insulated' and 'Shaft conductance' is 0: "
                                 "heat has no way out, so that the joint gets "
                                 "warmer without bound and no temperature is "
                                 "steady; give one of them"));
      }
    } // namespace



    void
    HeatParameters::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_choice(
        prm,
        "Temperature",
        temperature,
        "'steady': friction heats the bore with its mean power over the duty, "
        "and the joint has the temperature that it comes to; cycles and load "
        "cases must follow each other faster than it warms up. 'none': all is "
        "as cold as the radii of the joint are given for.");
      add_paths_of_heat(prm, *this);
      Parameters::add_quantity(prm,
                               "Reference temperature",
                               reference_temperature,
                               "K",
                               "At which bore and pin have the radii of the "
                               "joint: the cold clearance.",
                               "degC");
      Parameters::add_text(
        prm,
        "Modulus factor",
        modulus_factor,
        "What Young's modulus of the bushing is multiplied by when it is warm: "
        "a number or an expression of its mean temperature T in K, for example "
        "'1 - 0.005*(T - 293.15)'. Positive.");
      Parameters::add_text(
        prm,
        "Friction factor",
        friction_factor,
        "Likewise of the friction coefficients of the joint, with T of the "
        "contact.");
      Parameters::add_quantity(prm,
                               "Temperature tolerance",
                               tolerance,
                               "K",
                               "Motion, contact and temperature are computed "
                               "in turn until the temperature changes by "
                               "less.");
    }



    void
    HeatParameters::check(const std::string &path,
                          const Material    &bushing) const
    {
      const auto check_not_negative =
        [&path](const char *entry, const double value, const char *unit) {
          AssertThrow(value >= 0.,
                      ExcParameter(path + "/" + entry,
                                   Units::to_string(value, unit, unit) +
                                     " must not be negative"));
        };
      check_not_negative("Heat transfer coefficient",
                         heat_transfer_coefficient,
                         "W/(m^2 K)");
      check_not_negative("Thermal resistance", thermal_resistance, "K/W");
      check_not_negative("Shaft conductance", shaft_conductance, "W/K");
      AssertThrow(
        reference_temperature > 0.,
        ExcParameter(path + "/Reference temperature",
                     Units::to_string(reference_temperature, "K", "degC") +
                       " is below absolute zero"));
      // Also of "0.1 degC", which is 273.25 K.
      constexpr double largest_tolerance = 5.;
      AssertThrow(tolerance > 0. && tolerance <= largest_tolerance,
                  ExcParameter(path + "/Temperature tolerance",
                               Units::to_string(tolerance, "K", "K") +
                                 " is not above 0 K and at most 5 K; it is a "
                                 "difference, '0.1 K'"));
      // They name the parameter if it cannot be understood.
      TemperatureFactor(path + "/Modulus factor", modulus_factor);
      TemperatureFactor(path + "/Friction factor", friction_factor);
      if (!is_on())
        return;
      check_rim(path, *this);
      AssertThrow(bushing.thermal_conductivity > 0.,
                  ExcParameter("Material " + bushing.name +
                                 "/Thermal conductivity",
                               "must be given and positive: '" + path +
                                 "/Temperature' is 'steady'"));
    }



    TemperatureFactor::TemperatureFactor(const std::string &path,
                                         const std::string &expression)
      : expression(path, expression, variables())
    {}



    double
    TemperatureFactor::value(const double temperature) const
    {
      const dealii::Point<1> place(temperature);
      const double           result = expression.value(place);
      if (!(result > 0. && std::isfinite(result)))
        throw expression.error_at(place,
                                  "is not positive or not a finite number");
      return result;
    }
  } // namespace Thermal
} // namespace Tribody

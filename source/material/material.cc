// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/material/material.h>

namespace Tribody
{
  namespace
  {
    // A warning tells where a bushing passes one of them.
    void
    add_limits(dealii::ParameterHandler &prm, MaterialLimits &limits)
    {
      Parameters::add_quantity(prm,
                               "Maximum pressure",
                               limits.pressure,
                               "Pa",
                               "Of a bushing of this material, projected: "
                               "force over length and diameter. A warning "
                               "tells where it is passed; 0: none.",
                               "MPa");
      Parameters::add_quantity(
        prm, "Maximum speed", limits.speed, "m/s", "Likewise of sliding.");
      Parameters::add_quantity(prm,
                               "Maximum pv",
                               limits.pv,
                               "Pa m/s",
                               "Likewise of the mean over the cycle of "
                               "projected pressure times sliding speed.",
                               "MPa m/s");
      Parameters::add_quantity(prm,
                               "Maximum temperature",
                               limits.temperature,
                               "K",
                               "Likewise of the bore, where 'Heat/Temperature' "
                               "computes it, as '90 degC'; 0 K: none.");
    }
  } // namespace



  void
  Material::add_parameters(dealii::ParameterHandler &prm)
  {
    Parameters::add_quantity(prm,
                             "Young's modulus",
                             youngs_modulus,
                             "Pa",
                             "Young's modulus E, positive.",
                             "GPa");
    Parameters::add_quantity(prm,
                             "Poisson's ratio",
                             poissons_ratio,
                             "",
                             "Poisson's ratio nu, between -1 and 0.5 "
                             "(0.5, an incompressible material, excluded).");
    Parameters::add_quantity(prm,
                             "Density",
                             density,
                             "kg/m^3",
                             "Mass density, positive. Turns the worn volume "
                             "into the worn mass; nothing else uses it.");
    Parameters::add_quantity(prm,
                             "Thermal conductivity",
                             thermal_conductivity,
                             "W/(m K)",
                             "Heat flux over temperature gradient; needed "
                             "where a bushing has a 'Heat/Temperature'.");
    Parameters::add_quantity(prm,
                             "Thermal expansion",
                             thermal_expansion,
                             "K^-1",
                             "Linear coefficient alpha, by which a warm "
                             "bushing and a warm pin close their clearance; "
                             "0: they do not grow.");
    add_limits(prm, limits);
  }



  void
  Material::check() const
  {
    const std::string path = "Material " + name + "/";
    AssertThrow(youngs_modulus > 0.,
                ExcParameter(path + "Young's modulus",
                             Units::to_string(youngs_modulus, "Pa", "GPa") +
                               " must be positive"));
    AssertThrow(poissons_ratio > -1. && poissons_ratio < 0.5,
                ExcParameter(path + "Poisson's ratio",
                             Units::to_string(poissons_ratio, "", "") +
                               " must lie between -1 and 0.5, both "
                               "excluded"));
    AssertThrow(density > 0.,
                ExcParameter(path + "Density",
                             Units::to_string(density, "kg/m^3", "kg/m^3") +
                               " must be positive"));
    const auto check_not_negative = [&path](const char  *entry,
                                            const double value,
                                            const char  *si_unit,
                                            const char  *shown_unit) {
      AssertThrow(value >= 0.,
                  ExcParameter(path + entry,
                               Units::to_string(value, si_unit, shown_unit) +
                                 " must not be negative"));
    };
    check_not_negative("Thermal conductivity",
                       thermal_conductivity,
                       "W/(m K)",
                       "W/(m K)");
    check_not_negative("Thermal expansion", thermal_expansion, "K^-1", "K^-1");
    check_not_negative("Maximum pressure", limits.pressure, "Pa", "MPa");
    check_not_negative("Maximum speed", limits.speed, "m/s", "m/s");
    check_not_negative("Maximum pv", limits.pv, "Pa m/s", "MPa m/s");
    AssertThrow(limits.temperature >= 0.,
                ExcParameter(path + "Maximum temperature",
                             Units::to_string(limits.temperature, "K", "degC") +
                               " is below absolute zero"));
  }
} // namespace Tribody

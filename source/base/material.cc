// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/base/material.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>

namespace Tribody
{
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
  }
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_material_material_h
#define tribody_material_material_h

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  /// What a bearing material endures, as its data sheet has it; 0: not known.
  struct MaterialLimits
  {
    /// Force over length and diameter [Pa].
    double pressure = 0.;
    /// Of sliding [m/s].
    double speed = 0.;
    /// Their product [Pa m/s].
    double pv = 0.;
    /// Of the surface [K].
    double temperature = 0.;
  };

  /// An isotropic, linearly elastic material.
  struct Material
  {
    /// As bodies and joints refer to it; shown in messages.
    std::string name;
    /// Young's modulus E [Pa].
    double youngs_modulus = 206.8e9;
    /// Poisson's ratio [-], in (-1, 0.5).
    double poissons_ratio = 0.29;
    /// Mass density [kg/m^3].
    double density = 7800.;
    /// lambda [W/(m K)]; 0: not given.
    double thermal_conductivity = 0.;
    /// Linear, alpha [1/K].
    double thermal_expansion = 0.;
    /// What a bushing made of it endures.
    MaterialLimits limits = {};

    /// Declares in the current subsection.
    void
    add_parameters(dealii::ParameterHandler &prm);

    /// @throws ExcParameter with paths that start with "Material <name>".
    void
    check() const;
  };
} // namespace Tribody

#endif

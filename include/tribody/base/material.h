// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_material_h
#define tribody_base_material_h

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
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

    /// Declares in the current subsection.
    void
    add_parameters(dealii::ParameterHandler &prm);

    /// @throws ExcParameter with paths that start with "Material <name>".
    void
    check() const;
  };
} // namespace Tribody

#endif

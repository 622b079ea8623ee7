// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_stepping_wear_parameters_h
#define tribody_stepping_wear_parameters_h

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  namespace Coupling
  {
    /// How wear is integrated over the cycles.
    struct WearParameters
    {
      /// "staggered" or "coupled".
      std::string scheme = "staggered";
      /// "implicit", "constant" (the paper's extrapolation) or "one-shot".
      std::string extrapolation = "implicit";
      /// Relative error of the depth that an implicit step may make [-].
      double tolerance = 5e-3;
      /// Cycles per wear step A_E; 0 lets the program choose.
      double cycles_per_step = 0.;
      /// Change of the profile, as a fraction of the wall, after which the
      /// compliance is computed anew [-].
      double compliance_update = 0.005;
      /// "none", "first cycle" or "whole run".
      std::string mesh_error_estimate = "first cycle";
      /// Change of the profile, as a fraction of the largest clearance of the
      /// worn joint, after which the dynamics is run anew [-].
      double dynamics_update = 0.01;

      /// Declares in the current subsection, "Wear".
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// @throws ExcParameter with paths that start with "Wear".
      void
      check() const;
    };
  } // namespace Coupling
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_stepping_wear_parameters_h
#define tribody_stepping_wear_parameters_h

#include <tribody/base/choice.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  namespace Coupling
  {
    /// Whether joint forces and pressures come from two models or from one.
    enum class WearScheme
    {
      staggered,
      coupled
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<WearScheme>
    choice_names(const WearScheme)
    {
      return {{WearScheme::staggered, "staggered"},
              {WearScheme::coupled, "coupled"}};
    }

    /// How the wear of one cycle is carried over many. "constant" is the
    /// paper's.
    enum class Extrapolation
    {
      implicit,
      constant,
      one_shot
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<Extrapolation>
    choice_names(const Extrapolation)
    {
      return {{Extrapolation::implicit, "implicit"},
              {Extrapolation::constant, "constant"},
              {Extrapolation::one_shot, "one-shot"}};
    }

    /// What is also computed on the next coarser mesh.
    enum class MeshErrorEstimate
    {
      none,
      first_cycle,
      whole_run
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<MeshErrorEstimate>
    choice_names(const MeshErrorEstimate)
    {
      return {{MeshErrorEstimate::none, "none"},
              {MeshErrorEstimate::first_cycle, "first cycle"},
              {MeshErrorEstimate::whole_run, "whole run"}};
    }

    /// How wear is integrated over the cycles.
    struct WearParameters
    {
      /// Coupled: the dynamics takes its contact forces from the bushings.
      WearScheme scheme = WearScheme::staggered;
      /// How the wear of one cycle is carried over many.
      Extrapolation extrapolation = Extrapolation::implicit;
      /// Relative error of the depth that an implicit step may make [-].
      double tolerance = 5e-3;
      /// Cycles per wear step A_E; 0 lets the program choose.
      double cycles_per_step = 0.;
      /// Change of the profile, as a fraction of the wall, after which the
      /// compliance is computed anew [-].
      double compliance_update = 0.005;
      /// What is computed a second time to learn how far the mesh matters.
      MeshErrorEstimate mesh_error_estimate = MeshErrorEstimate::whole_run;
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

#ifndef tribody_coupling_case_parameters_h
#define tribody_coupling_case_parameters_h

#include <tribody/base/material.h>
#include <tribody/coupling/bushing_parameters.h>
#include <tribody/multibody/dynamics_parameters.h>
#include <tribody/multibody/mechanism_parameters.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  class ParameterFile;

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

    /**
     * A parameter file as the program understands it: one member or list entry
     * per subsection, names resolved, SI units. See the documentation strings
     * (tribody --print-parameters) for the meaning of each entry.
     */
    struct CaseParameters
    {
      std::string title;
      /// Cycles to run; 0: dynamics only.
      unsigned int cycles = 0;
      /// Where to write; empty: "output/<name of the parameter file>".
      std::string output_directory;
      /// Times at which fields are written, the first and last cycle included.
      unsigned int n_outputs = 3;

      Multibody::MechanismParameters mechanism;
      Multibody::DynamicsParameters  dynamics;
      std::vector<Material>          materials;
      std::vector<BushingParameters> bushings;
      WearParameters                 wear;

      /// All of this as a parameter file with documentation.
      std::string text;

      /// The parameters of the joint @p name, which must exist.
      const Multibody::JointParameters &
      joint(const std::string &name) const;
    };

    /**
     * Read a parameter file and check it, the mechanism's references included.
     * @param overrides assignments "A/B=value" that win over the file.
     * @throws ExcInput with file, line, value, and what would be valid.
     */
    CaseParameters
    read_case(const std::string              &file_name,
              const std::vector<std::string> &overrides);

    /// A parameter file with one entry of every kind, for
    /// --print-parameters.
    std::string
    parameter_template();
  } // namespace Coupling
} // namespace Tribody

#endif

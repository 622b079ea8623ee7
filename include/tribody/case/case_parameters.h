// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_case_case_parameters_h
#define tribody_case_case_parameters_h

#include <tribody/bushing/bushing_parameters.h>
#include <tribody/case/load_case.h>
#include <tribody/material/material.h>
#include <tribody/multibody/motion/dynamics_parameters.h>
#include <tribody/multibody/system/mechanism_parameters.h>
#include <tribody/stepping/wear_parameters.h>

#include <string>
#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    /**
     * A parameter file as the program understands it: one member or list entry
     * per subsection, names resolved, SI units. See the documentation strings
     * (tribody --print-parameters) for the meaning of each entry.
     */
    struct CaseParameters
    {
      /// With the defaults of parameter files: pins follow their bores where
      /// they can, and there are samples where the forces are.
      CaseParameters()
      {
        dynamics.joint_motion       = Multibody::JointMotion::automatic;
        dynamics.sampling_tolerance = 2e-3;
        dynamics.accuracy           = 0.;
      }

      /// One line that says what the case is, for log and summary.
      std::string title;
      /// Cycles to run, those of all load cases together; 0: dynamics only.
      unsigned int cycles = 0;
      /// After which a run ends, standstill included [s]; 0: none. It is in
      /// #cycles already.
      double stop_at_time = 0.;
      /// Whether it ends the run before its cycles are done.
      bool ends_by_time = false;
      /// The part of that time in which the machine works [-].
      double operating_share = 1.;
      /// Where to write; empty: "output/<name of the parameter file>".
      std::string output_directory;
      /// Times at which fields are written, the first and last cycle included.
      unsigned int n_outputs = 3;

      /// How the load cases follow each other.
      LoadCaseOrder load_case_order = LoadCaseOrder::repeated;
      /// At least one: without load cases the case itself, without a name.
      std::vector<LoadCase> load_cases;
      /// How they share the cycles.
      Spectrum spectrum;

      /// Bodies, joints, drivers, springs and forces; joints know their
      /// materials. Those of the first load case.
      Multibody::MechanismParameters mechanism;
      /// Of the surroundings of all joints [K]; likewise.
      double ambient_temperature = 293.15;
      /// How the motion is computed and when it counts as settled; likewise.
      Multibody::DynamicsParameters dynamics;
      /// All that the file lists, whether something is made of them or not.
      std::vector<Material> materials;
      /// One for each joint that wears; has the name of that joint.
      std::vector<BushingParameters> bushings;
      /// How the wear of one cycle is carried over many.
      WearParameters wear;

      /// All of this as a parameter file with documentation.
      std::string text;

      /// The parameters of the joint @p name, which must exist.
      const Multibody::JointParameters &
      joint(const std::string &name) const;

      /// The bushing of the joint @p name, or nullptr.
      const BushingParameters *
      bushing(const std::string &name) const;

      /// Whether the loads of bushings come from files, so that there is no
      /// mechanism.
      bool
      has_given_loads() const;
    };

    /**
     * Read a parameter file and check it, the mechanism's references included.
     * @param overrides assignments "A/B=value" that win over the file.
     * @throws ExcInput with file, line, value, and what would be valid.
     */
    CaseParameters
    read_case(const std::string              &file_name,
              const std::vector<std::string> &overrides);

    /// Memory that the case takes on a rank [bytes], as far as it is known
    /// before meshes are read and contacts found; see memory_estimate.h.
    double
    estimate_memory(const CaseParameters &parameters);

    /// A parameter file with one entry of every kind, for
    /// --print-parameters.
    std::string
    parameter_template();
  } // namespace Coupling
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_case_load_case_h
#define tribody_case_load_case_h

#include <tribody/base/parameter_file.h>
#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/multibody/motion/dynamics_parameters.h>
#include <tribody/multibody/system/mechanism_parameters.h>
#include <tribody/stepping/spectrum.h>

#include <optional>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  namespace Coupling
  {
    /**
     * One of the conditions that a machine works under: how often, and the
     * mechanism with all that differs there. Its own subsection in a parameter
     * file, 'Load case <name>', repeats others with the entries that differ.
     */
    struct LoadCase
    {
      /// Empty if it is the only one and has no subsection.
      std::string name;
      /// In a block, or in sequence in the whole run; 0: not given [-].
      double cycles = 0.;
      /// Instead, how long they last [s]; 0: not given.
      double duration = 0.;
      /// Instead, their part of the time of a block [-]; 0: not given.
      double share = 0.;
      /// Multiplies the wear coefficients of bushings and pins [-].
      double wear_factor = 1.;

      /// Of the surroundings of all joints [K].
      double ambient_temperature = 293.15;
      /// The mechanism in this case: the same bodies and joints as in all.
      Multibody::MechanismParameters mechanism;
      /// Of one cycle [s].
      double period = 0.;
      /// If the loads of its joints come from files: instead of a mechanism.
      std::optional<Multibody::DutyCycle> given_duty_cycle;
      /// How its motion is computed.
      Multibody::DynamicsParameters dynamics;

      /// Declares in the current subsection, "Load case <name>", all that no
      /// other subsection has.
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// @throws ExcParameter with paths that start with "Load case <name>".
      void
      check() const;

      /// "Load case <name>".
      std::string
      subsection() const;
    };

    /// The parameter file as load case @p name has it: what its subsection
    /// repeats stands at the top level, that of the other @p names is gone.
    /// @throws ExcInput for what may not differ between load cases: meshes,
    ///   joints, and what is numbered.
    ParameterFile
    file_of_load_case(const ParameterFile            &file,
                      const std::vector<std::string> &names,
                      const std::string              &name);

    /// The parameter file without what the subsections of load cases repeat.
    ParameterFile
    file_of_all_load_cases(const ParameterFile            &file,
                           const std::vector<std::string> &names);

    /// What the subsections of load cases repeat, as a parameter file has it.
    std::string
    print_repeated(const ParameterFile            &file,
                   const std::vector<std::string> &names);

    /**
     * How the @p cases share the cycles.
     * @throws ExcParameter if cycles, durations and shares do not fit together.
     */
    Spectrum
    make_spectrum(const std::vector<LoadCase> &cases,
                  const LoadCaseOrder          order);
  } // namespace Coupling
} // namespace Tribody

#endif

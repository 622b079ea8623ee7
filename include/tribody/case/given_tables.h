// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_case_given_tables_h
#define tribody_case_given_tables_h

#include <tribody/base/parameter_file.h>
#include <tribody/multibody/system/mechanism_parameters.h>

namespace Tribody
{
  namespace Coupling
  {
    /// Read the tables of forces, torques and drivers. Their files are named
    /// relative to the parameter file that does so, or to the current directory
    /// if that is the command line.
    /// @throws ExcParameter with what is wrong with which of them.
    void
    read_tables(const ParameterFile            &file,
                Multibody::MechanismParameters &mechanism);

    /// In @p prm, in which @p mechanism is declared, let the files of its
    /// tables be found from anywhere.
    void
    set_full_paths_of_tables(const ParameterFile                  &file,
                             const Multibody::MechanismParameters &mechanism,
                             dealii::ParameterHandler             &prm);
  } // namespace Coupling
} // namespace Tribody

#endif

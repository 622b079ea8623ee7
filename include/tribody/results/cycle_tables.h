// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_results_cycle_tables_h
#define tribody_results_cycle_tables_h

#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/multibody/system/mechanism_parameters.h>
#include <tribody/output/output_directory.h>

#include <string>

namespace Tribody
{
  namespace Coupling
  {
    /**
     * Write all that is known of one cycle of the @p mechanism as tables into
     * @p directory, with the name of the @p load_case, if it has one, and
     * @p number in their names: duty cycle and contacts of
     * each joint, motion of each body, what each driver transmits, energies.
     */
    void
    write_cycle_tables(const Output::OutputDirectory        &directory,
                       const Multibody::MechanismParameters &mechanism,
                       const Multibody::DutyCycle           &cycle,
                       const std::string                    &load_case,
                       const unsigned int                    number);
  } // namespace Coupling
} // namespace Tribody

#endif

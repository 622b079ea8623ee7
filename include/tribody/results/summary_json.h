// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_results_summary_json_h
#define tribody_results_summary_json_h

#include <tribody/case/case_parameters.h>
#include <tribody/results/run_results.h>

#include <string>

namespace Tribody
{
  namespace Coupling
  {
    /// summary.json: all @p results, SI units, angles in degrees, all digits.
    /// @throws ExcRun if the file cannot be written.
    void
    write_summary_json(const std::string    &file_name,
                       const CaseParameters &parameters,
                       const RunResults     &results);
  } // namespace Coupling
} // namespace Tribody

#endif

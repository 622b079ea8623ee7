// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_results_printed_summary_h
#define tribody_results_printed_summary_h

#include <tribody/case/case_parameters.h>
#include <tribody/results/run_results.h>

#include <iosfwd>

namespace Tribody
{
  namespace Coupling
  {
    /// What the user reads at the end of a run: @p results in the units of a
    /// data sheet, with the digits that they deserve.
    void
    print_results(std::ostream         &out,
                  const CaseParameters &parameters,
                  const RunResults     &results);
  } // namespace Coupling
} // namespace Tribody

#endif

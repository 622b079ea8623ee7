// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_results_run_summary_h
#define tribody_results_run_summary_h

#include <tribody/case/case_parameters.h>
#include <tribody/results/summary.h>
#include <tribody/stepping/run_state.h>

#include <iosfwd>
#include <list>

namespace Tribody
{
  namespace Coupling
  {
    /// The results of @p state. Status, message and times are left to the
    /// caller.
    RunSummary
    make_run_summary(const CaseParameters            &parameters,
                     const RunState                  &state,
                     const std::list<WearingBushing> &bushings);

    /// The same for the reader of the console.
    void
    print_results(std::ostream &out, const RunSummary &summary);
  } // namespace Coupling
} // namespace Tribody

#endif

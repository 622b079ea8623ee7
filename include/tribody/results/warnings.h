// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_results_warnings_h
#define tribody_results_warnings_h

#include <tribody/case/case_parameters.h>
#include <tribody/results/run_results.h>

#include <string>
#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    /// What makes a number of the results doubtful.
    struct Warning
    {
      /// For programs; these do not change: "strains", "held_by_friction", ...
      std::string code;
      /// Whose numbers it concerns; empty: all.
      std::string joint;
      /// For the user: which number, by how much it may be wrong, what to do.
      std::string message;
    };

    /**
     * All that there are to @p results. Each has a limit that results of a
     * sound input keep.
     */
    std::vector<Warning>
    find_warnings(const CaseParameters &parameters, const RunResults &results);
  } // namespace Coupling
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_solver_report_h
#define tribody_base_solver_report_h

#include <string>

namespace Tribody
{
  /**
   * How an iteration ended. Non-convergence that can be expected is a value,
   * not an exception: the caller decides what to do about it.
   */
  struct SolverReport
  {
    /// Whether what was asked for has been reached.
    bool converged = false;
    /// Iterations taken, the last one included [-].
    unsigned int n_iterations = 0;
    /// Norm of what should vanish, in the solver's own scaling [-].
    double residual = 0.;
    /// What happened, in words; empty if it converged.
    std::string message;
    /// It has not converged, because the residual falls no more: it may be as
    /// small as rounding lets it be, or the equations cannot be solved. What
    /// residual will do, only the caller knows.
    bool stagnated = false;
  };
} // namespace Tribody

#endif

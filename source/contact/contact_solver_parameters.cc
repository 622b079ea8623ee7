// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/parameter_handler.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/contact/contact_solver_parameters.h>

namespace Tribody
{
  namespace Contact
  {
    void
    ContactSolverParameters::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_quantity(
        prm,
        "Tolerance",
        tolerance,
        "",
        "Largest gap left in contact, as a fraction of the largest elastic "
        "displacement, and largest imbalance of the forces, as a fraction of "
        "the force. Newton's method converges quadratically: little is gained "
        "by a larger value.");
      Parameters::add_integer(
        prm,
        "Maximum iterations",
        max_iterations,
        "Newton iterations before the slow but certain active-set programme "
        "takes over.",
        1,
        10000);
      Parameters::add_integer(
        prm,
        "Maximum linearisations",
        max_linearisations,
        "How often that programme is linearised again before the contact "
        "counts as not converged.",
        1,
        10000);
    }



    void
    ContactSolverParameters::check(const std::string &path) const
    {
      AssertThrow(tolerance >= 1e-14 && tolerance <= 1e-3,
                  ExcParameter(path + "/Tolerance",
                               Units::to_string(tolerance, "", "") +
                                 " is not in [1e-14, 1e-3]."));
    }
  } // namespace Contact
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_contact_contact_solver_parameters_h
#define tribody_contact_contact_solver_parameters_h

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  namespace Contact
  {
    /// When ContactSolver stops.
    struct ContactSolverParameters
    {
      /// What gaps in contact may leave of the largest elastic displacement,
      /// and the balance of forces of the force [-].
      double tolerance = 1e-12;
      /// Newton iterations before the fall-back is used [-].
      unsigned int max_iterations = 30;
      /// Linearisations of the fall-back [-].
      unsigned int max_linearisations = 30;

      /// Declares in the current subsection.
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// @param path of the subsection, for the message.
      /// @throws ExcParameter if the tolerance is out of reach.
      void
      check(const std::string &path) const;
    };
  } // namespace Contact
} // namespace Tribody

#endif

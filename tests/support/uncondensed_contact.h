// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_support_uncondensed_contact_h
#define tests_support_uncondensed_contact_h

#include <Eigen/Core>

#include <tribody/contact/contact_solution.h>

namespace Tribody
{
  struct BoreSurface;

  namespace Elasticity
  {
    class BushingElasticity;
  }

  namespace Coupling
  {
    /**
     * The problem of Contact::ContactSolver under a given force, solved on the
     * whole mesh without condensing it to the bore: the reference to which the
     * fast path is compared.
     *
     * Each iteration solves for the displacements u, the pin's step d and the
     * nodal forces @f$\lambda@f$ of all bore nodes at once,
     * @f[ K u - \sum_i \lambda_i n_i = 0, \quad
     *     \sum_i \lambda_i m_i + H d = f, \quad
     *     \begin{cases}
     *       n_i \cdot u_i - m_i \cdot d = -g^0_i & i \text{ active} \\
     *       \lambda_i = 0 & \text{else,}
     *     \end{cases} @f]
     * with the gap's exact derivatives, and then updates the active set as
     * deal.II's step-42 does. Costs a factorisation of the whole system per
     * iteration.
     *
     * @param elasticity after reinit().
     * @param surface of the bore on the mapping given to reinit().
     * @param pin_radius R [m].
     * @param force_per_length f [N/m], not zero.
     */
    Contact::ContactSolution
    solve_uncondensed_contact(const Elasticity::BushingElasticity &elasticity,
                              const BoreSurface                   &surface,
                              const double                         pin_radius,
                              const Eigen::Vector2d &force_per_length);
  } // namespace Coupling
} // namespace Tribody

#endif

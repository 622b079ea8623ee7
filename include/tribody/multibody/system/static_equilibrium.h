// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_system_static_equilibrium_h
#define tribody_multibody_system_static_equilibrium_h

#include <Eigen/Core>

#include <tribody/base/solver_report.h>

namespace Tribody
{
  namespace Multibody
  {
    class EquationsOfMotion;

    /// A position at rest, and what holds it there.
    struct StaticEquilibrium
    {
      /// Coordinates [m, rad].
      Eigen::VectorXd q;
      /// Lagrange multipliers [N, N m].
      Eigen::VectorXd multipliers;
      /// The residual is what the constraints do not balance of the applied
      /// forces, relative to the sum of their magnitudes.
      SolverReport report;
    };

    /**
     * Solve the equations of equilibrium at time @p t,
     * @f[ Q(t, q, 0) - \Phi_q^T \lambda = 0, \qquad \Phi(q, t) = 0, @f]
     * for a stable position that the mechanism may reach from @p q_guess, which
     * fulfils the constraints.
     *
     * Newton's method in the directions that the constraints leave free, with a
     * pseudo-transient term @f$\sigma@f$ on the diagonal that is raised until
     * the stiffness is positive definite and the forces do positive work in the
     * step (their potential energy falls, if they have one), and lowered after
     * success. A position in which the forces balance but are not stable is
     * left along the most unstable direction.
     */
    StaticEquilibrium
    solve_static_equilibrium(const EquationsOfMotion &equations,
                             const double             t,
                             const Eigen::VectorXd   &q_guess);
  } // namespace Multibody
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_assembly_assembly_checks_h
#define tribody_multibody_assembly_assembly_checks_h

#include <Eigen/Core>

#include <string>

namespace Tribody
{
  namespace Multibody
  {
    class EquationsOfMotion;

    /**
     * Make sure that a mechanism without degrees of freedom has a position, and
     * not a singular one, at each of @p n_steps equal steps through the time
     * @p period from time 0 on. @throws ExcParameter with where the drivers are
     * when it locks, and the joints.
     */
    void
    check_full_cycle(const EquationsOfMotion &equations,
                     const double             period,
                     const unsigned int       n_steps);

    /**
     * Make sure that such a mechanism is back where it began after the time
     * @p period, but for whole turns. @throws ExcParameter naming the body that
     * is not and, if it is found, the time after which all are.
     */
    void
    check_return(const EquationsOfMotion &equations,
                 const double             period,
                 const unsigned int       n_steps);

    /**
     * Make sure that the accelerations are determined: what the constraints
     * leave free at @p q must have a mass. @throws ExcParameter naming a body
     * without.
     */
    void
    check_masses(const EquationsOfMotion &equations, const Eigen::VectorXd &q);

    /**
     * Why a motion may have ended that was at @p q at time @p t and has not
     * reached the time @p t_next: joints that cannot be closed any more, or
     * whose constraints have become dependent. A sentence that begins with a
     * blank; empty if neither is the case.
     */
    std::string
    explain_end_of_motion(const EquationsOfMotion &equations,
                          const double             t,
                          const double             t_next,
                          const Eigen::VectorXd   &q);

    /**
     * Make sure that no constraint follows from the others at @p q (rank of
     * Phi_q). @throws ExcParameter naming the joints and drivers involved.
     */
    void
    check_redundancy(const EquationsOfMotion &equations,
                     const Eigen::VectorXd   &q);
  } // namespace Multibody
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_following_slow_motion_start_h
#define tribody_multibody_following_slow_motion_start_h

#include <tribody/base/solver_report.h>
#include <tribody/multibody/system/mechanism_state.h>

namespace Tribody
{
  namespace Multibody
  {
    class EquationsOfMotion;

    /// A state to start from, and how it was found.
    struct StartingState
    {
      /// At the time t_0; it fulfils the constraints.
      MechanismState state;
      /// Its message says why a start without vibration was not found.
      SolverReport report;
    };

    /// Every pin in the middle of its bushing, with the velocities of ideal
    /// joints; at the end of a massless link, which points where the reaction
    /// of an ideal joint does. @p closed: the equations with ideal joints.
    StartingState
    compute_centred_start(const EquationsOfMotion &equations,
                          const EquationsOfMotion &closed,
                          const double             t_0);

    /**
     * A start without vibration. With each pin at a prescribed eccentricity
     * e(t), the mechanism has no degree of freedom, and its reactions follow
     * from inverse dynamics. The e(t) is sought at which contact and friction
     * laws give just these reactions: at five times around @p t_0, so that e'
     * and e'' are known by differentiation, and all clearance joints at once.
     * The iteration contracts because the contact is much stiffer than the
     * motion is fast. It need not where forces reverse or bores are worn: then
     * the report says that it has not converged. Pins of massless links and of
     * joints with impacts are sought at the distance of the clearance, in the
     * direction of the reaction. @throws ExcRun if the
     * mechanism has no position with the pins at such an e(t).
     *
     * @param equations with clearance joints; @param closed with ideal ones.
     * @param spacing of the five times [s], a small part of a cycle.
     */
    StartingState
    compute_slow_motion_start(const EquationsOfMotion &equations,
                              const EquationsOfMotion &closed,
                              const double             t_0,
                              const double             spacing);
  } // namespace Multibody
} // namespace Tribody

#endif

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
      /// Its message says why it is not without vibration; empty if it is, or
      /// was not asked to be.
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
     * A start with pins at their bores where the forces of the joints press
     * them, as FollowingPins. Without degrees of freedom they follow: they are
     * sought at five times around @p t_0, so that their motion in the bores is
     * known by differences, and nothing vibrates. Where that motion would
     * change the forces, as those that reverse or turn fast, or with degrees of
     * freedom, whose motion is not known before it is integrated, they rest in
     * their bores while the bodies have the velocities of ideal joints. Where
     * not even that is a state near the motion of ideal joints, in velocities
     * and forces, the start is centred. The message of the report says so.
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

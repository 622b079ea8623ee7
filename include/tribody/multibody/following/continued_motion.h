// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_following_continued_motion_h
#define tribody_multibody_following_continued_motion_h

#include <Eigen/Core>

#include <tribody/multibody/system/mechanism_state.h>

namespace Tribody
{
  namespace Multibody
  {
    class EquationsOfMotion;

    /// Where a motion ended.
    struct MotionEnd
    {
      /// The state there.
      MechanismState state;
      /// Penetrations of the clearance joints [m]; negative: gap.
      Eigen::VectorXd penetrations;
    };

    /// Of @p state.
    MotionEnd
    make_motion_end(const EquationsOfMotion &equations,
                    const MechanismState    &state);

    /**
     * A state from which a motion goes on in bores that have worn since:
     * pins that were in contact penetrate as deep as before, at the same
     * places, others stay where they are; velocities are as before, as near as
     * the constraints allow.
     *
     * @param equations with clearance joints; @param closed with ideal ones.
     * @throws ExcRun if the mechanism has no position with its pins there.
     */
    MechanismState
    continue_in_worn_bores(const EquationsOfMotion &equations,
                           const EquationsOfMotion &closed,
                           const MotionEnd         &end);
  } // namespace Multibody
} // namespace Tribody

#endif

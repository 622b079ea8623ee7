// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_following_followed_cycle_h
#define tribody_multibody_following_followed_cycle_h

#include <Eigen/Core>

#include <tribody/multibody/following/following_pins.h>

#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    /// What the motion of following pins leaves out of the forces of a joint.
    struct NeglectedInertia
    {
      /// Change of the force by the accelerations of the pins in their bores
      /// that are not in it, relative to the force; both averaged over the
      /// sliding [-].
      double share = 0.;
      /// Change of the wear by it where that is deepest, WearSpread [-].
      double of_wear = 0.;
      /// Part of the cycle's time in which the pin would have to be pulled to
      /// follow its bore [-].
      double lifting_share = 0.;
      /// When it would have to be pulled most; meaningless if it need not [s].
      double time = 0.;
    };

    /// A cycle of a mechanism whose pins follow their bores.
    struct FollowedCycle
    {
      /// At the times asked for.
      std::vector<FollowingInstant> instants;
      /// The motion of the pins that they have, one entry per instant.
      std::vector<PinRates> rates;
      /// One per joint with a gap.
      std::vector<NeglectedInertia> neglected;
    };

    /**
     * The instants at @p times [s], equal intervals of a cycle whose last is
     * the first of the next cycle; near @p q_guess at the first of them.
     *
     * Velocities and accelerations of the pins in their bores are first zero
     * and then differences of the places that have been found, until they
     * hardly change the forces any more, or no longer less than before. They
     * are means over a thirty-second of the cycle to either side: a pin that
     * crosses its bore flies, and strikes with the momentum that it did not
     * press with, which is no change for the wear if it is that brief. What
     * shorter means would change is neglected: over half as long of the wear,
     * over a quarter of the forces.
     * @throws ExcRun as FollowingPins::find().
     */
    FollowedCycle
    follow_cycle(const FollowingPins       &pins,
                 const std::vector<double> &times,
                 const Eigen::VectorXd     &q_guess);
  } // namespace Multibody
} // namespace Tribody

#endif

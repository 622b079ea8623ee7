// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_cycle_creep_h
#define tribody_multibody_cycle_creep_h

namespace Tribody
{
  namespace Multibody
  {
    class EquationsOfMotion;
    class Mechanism;
    struct DutyCycle;

    /**
     * Judge the creep of an integrated motion. A friction law that is smooth at
     * rest does not hold a joint but lets it creep, in proportion to the
     * speed below which it is smooth: friction_holds(). This sliding is the
     * law's, not the joint's, unless drivers prescribe how the joint turns.
     *
     * A joint that creeps throughout the @p cycle is held by friction: its
     * sliding is taken out, as JointDutyCycle::creep_distance. Of one that
     * creeps now and then, JointDutyCycle::creep_share says how much of its
     * sliding this is, without the samples in which it comes to rest and
     * leaves it again, as those are sliding.
     *
     * @param mechanism whose motion this is.
     * @param closed equations of the same with ideal joints.
     */
    void
    judge_creep(const Mechanism         &mechanism,
                const EquationsOfMotion &closed,
                DutyCycle               &cycle);
  } // namespace Multibody
} // namespace Tribody

#endif

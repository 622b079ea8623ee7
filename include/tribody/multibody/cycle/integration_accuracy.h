// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_cycle_integration_accuracy_h
#define tribody_multibody_cycle_integration_accuracy_h

#include <tribody/multibody/cycle/duty_cycle.h>

#include <functional>
#include <map>
#include <string>

namespace Tribody
{
  namespace Multibody
  {
    /// Angles over which wear spreads to either side of a joint's force [rad],
    /// by name of the joint; those of joints not given are as of a bore that is
    /// worn in.
    using WearArcs = std::map<std::string, double>;

    /// Of @p joint in @p arcs [rad].
    double
    reach_of(const JointDutyCycle &joint, const WearArcs &arcs);

    /// What the integration leaves in the wear where that was not measured, of
    /// a motion with this @p accuracy [-]: 3e-4 gives forces to 0.1 %.
    double
    usual_integration_error(const double accuracy);

    /**
     * A motion with as little accuracy as the wear allows: each goes on from
     * the one before it with a quarter of its tolerance, until the wear of both
     * is the same to 0.2 %, where it is deepest and in all, or differs by more
     * than half of what it did before: then it is scatter. One that has not
     * settled goes on while that halves its distance from one that repeats. The
     * difference of the wear is JointDutyCycle::integration_error, three halves
     * of the error that a method of second order has left.
     *
     * @param integrate makes the motion with an accuracy [-] that goes on from
     *   a looser one, or begins where there is none (the null pointer).
     * @throws ExcRun what the motion with the finest accuracy throws, if all
     *   have failed; after one that has not, the last that has not is returned.
     */
    DutyCycle
    integrate_as_needed(
      const std::function<DutyCycle(const double, const DutyCycle *)>
                     &integrate,
      const WearArcs &arcs);
  } // namespace Multibody
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_assembly_redundancy_h
#define tribody_multibody_assembly_redundancy_h

#include <tribody/multibody/system/mechanism_parameters.h>

#include <string>

namespace Tribody
{
  namespace Multibody
  {
    class Mechanism;

    /// Newton's method ends up to 1e-6 of the size away from a singular
    /// position, and the rows of Phi_q, of length one, are dependent to that
    /// only.
    constexpr double singular_threshold = 1e-5;

    /**
     * The same mechanism without equations of its joints that follow from those
     * of other joints, as of a scissor lift that is guided on each level: its
     * motion is the same, but its reactions are determined only then. Of joints
     * that depend on each other the last ones give way, and before them those
     * that @p simulated gives a gap, with which nothing follows from the
     * others. A position that is only singular is no redundancy, and is left as
     * it is.
     * @throws ExcParameter naming joints that contradict each other, or drivers
     *   that are too many.
     */
    MechanismParameters
    leave_out_redundant_constraints(const MechanismParameters &parameters,
                                    const MechanismParameters &simulated);

    /// For the user: which constraints were left out and whose reactions are
    /// not unique. Empty if there are none.
    std::string
    describe_left_out(const Mechanism &mechanism);
  } // namespace Multibody
} // namespace Tribody

#endif

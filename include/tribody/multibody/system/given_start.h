// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_system_given_start_h
#define tribody_multibody_system_given_start_h

#include <Eigen/Core>

#include <string>

namespace Tribody
{
  namespace Multibody
  {
    class EquationsOfMotion;
    class Mechanism;

    /// Add whole turns to the angles of driven bodies in @p q, so that they are
    /// nearest to what the drivers prescribe at time @p t.
    void
    turn_to_drivers(const Mechanism &mechanism,
                    const double     t,
                    Eigen::VectorXd &q);

    /**
     * Move a closed configuration @p q, on the way of the mechanism's own
     * motion, to one that has the @p given angles, or positions, of the first
     * bodies of the list, as many as there are degrees of freedom. @p q itself
     * if the mechanism locks on the way.
     */
    Eigen::VectorXd
    hold_given_coordinates(const EquationsOfMotion &equations,
                           const double             t,
                           const Eigen::VectorXd   &given,
                           const Eigen::VectorXd   &q);

    /**
     * What the closed configuration @p q has that the parameters say otherwise
     * and that is theirs to say: "body 'crank' is turned by -7 deg from its
     * initial angle", or a body that another way to assemble the mechanism has
     * turned over. Empty if there is nothing.
     */
    std::string
    explain_changed_start(const EquationsOfMotion &equations,
                          const Eigen::VectorXd   &q);
  } // namespace Multibody
} // namespace Tribody

#endif

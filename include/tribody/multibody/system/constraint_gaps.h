// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_system_constraint_gaps_h
#define tribody_multibody_system_constraint_gaps_h

#include <Eigen/Core>

#include <string>

namespace Tribody
{
  namespace Multibody
  {
    class Constraint;
    class EquationsOfMotion;
    class Mechanism;

    /// By what to multiply Phi to have lengths: one for them, the mechanism's
    /// size for angles.
    Eigen::VectorXd
    compute_constraint_scales(const Mechanism &mechanism);

    /// Phi_q in units of the mechanism's size: columns of angles divided by it,
    /// rows of them multiplied, so that a turn counts as the way that it moves
    /// a point.
    Eigen::MatrixXd
    compute_scaled_jacobian(const EquationsOfMotion &equations,
                            const Eigen::VectorXd   &q);

    /**
     * The configuration near @p q_guess in which the squares of all gaps
     * (angles times the mechanism's size) have the least sum, by the method of
     * Levenberg and Marquardt: what can be closed is closed, and what cannot is
     * told by how much. Unlike Newton's method it ends at the same place on any
     * machine.
     * @param open the constraint that gives way to the others; the null
     *   pointer: all but the drivers do.
     */
    Eigen::VectorXd
    find_smallest_gaps(const EquationsOfMotion &equations,
                       const double             t,
                       const Eigen::VectorXd   &q_guess,
                       const Constraint        *open = nullptr);

    /// What keeps a mechanism from being closed, for messages.
    struct OpenConstraint
    {
      /// The joint or driver, as in the parameter file.
      std::string description;
      /// "cannot be closed: a gap of 3 mm remains"
      std::string problem;
    };

    /// The constraint that can be opened so that all others close: of joints
    /// in a loop the one with the largest share of the gap, or the first.
    OpenConstraint
    find_open_constraint(const EquationsOfMotion &equations,
                         const double             t,
                         const Eigen::VectorXd   &q_guess);

    /// Where the drivers want their bodies at time @p t, for messages.
    std::string
    describe_drivers(const Mechanism &mechanism, const double t);
  } // namespace Multibody
} // namespace Tribody

#endif

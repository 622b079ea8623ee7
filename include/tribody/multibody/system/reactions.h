// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_system_reactions_h
#define tribody_multibody_system_reactions_h

#include <Eigen/Core>

#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    class EquationsOfMotion;
    struct Accelerations;
    struct JointContact;
    struct MechanismState;

    /// What joints and drivers transmit at one instant, in global axes.
    struct Reactions
    {
      /// A column per joint, on its second body (that with the bushing): force
      /// x, y [N], and moment about the second marker [N m]. The force of a
      /// contact acts off that marker, so it has a moment too.
      Eigen::Matrix3Xd joints;
      /// The second marker (bushing centre) of each joint [m].
      Eigen::Matrix2Xd joint_points;
      /// A column per driver, on its first body (the driven one): force x, y
      /// [N], and moment about the centre of mass [N m].
      Eigen::Matrix3Xd drivers;
      /// Power of each driver [W].
      Eigen::VectorXd driver_powers;
    };

    /// The reactions at @p state, where the multipliers are those of
    /// @p accelerations, and @p contacts those of the clearance joints.
    Reactions
    compute_reactions(const EquationsOfMotion         &equations,
                      const MechanismState            &state,
                      const Accelerations             &accelerations,
                      const std::vector<JointContact> &contacts);
  } // namespace Multibody
} // namespace Tribody

#endif

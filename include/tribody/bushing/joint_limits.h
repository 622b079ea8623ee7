// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_bushing_joint_limits_h
#define tribody_bushing_joint_limits_h

#include <Eigen/Core>

#include <string>
#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    struct JointParameters;
  }

  namespace Coupling
  {
    class WearingBushing;

    /// What ends the life of a joint: a quantity that grows with the wear, and
    /// the parameter 'Stop at ...' that sets the limit at which a run ends.
    struct JointLimit
    {
      /// For the user: "maximum depth".
      std::string quantity;
      /// Of the quantity and of limits in the program: "m".
      std::string si_unit;
      /// Of limits in messages and in the manual: "mm".
      std::string shown_unit;
      /// Of the parameter.
      std::string documentation;
      /// The quantity when the surfaces of the joint are worn by these depths
      /// [m], as WearingBushing has them.
      double (*value)(const WearingBushing  &bushing,
                      const Eigen::VectorXd &depth);
      /// The quantity before any wear.
      double (*unworn_value)(const Multibody::JointParameters &joint);

      /// "Stop at maximum depth".
      std::string
      parameter() const;

      /// "maximum depth 0.3 mm".
      std::string
      describe(const double limit) const;
    };

    /// All that can be set; a new one is an entry here.
    const std::vector<JointLimit> &
    joint_limits();

    /// The one that every bushing has: the part of its wall that is gone [-].
    const JointLimit &
    worn_through();

    /// When a bushing counts as worn through [-]. What is left is less than the
    /// errors of the depth, and a mesh must not become flat.
    constexpr double worn_through_at = 0.999;
  } // namespace Coupling
} // namespace Tribody

#endif

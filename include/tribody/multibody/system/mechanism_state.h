// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_system_mechanism_state_h
#define tribody_multibody_system_mechanism_state_h

#include <Eigen/Core>

#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    /// The state of a mechanism at one instant.
    struct MechanismState
    {
      /// Time [s].
      double time = 0.;
      /// Coordinates [m, rad].
      Eigen::VectorXd q;
      /// Velocities [m/s, rad/s].
      Eigen::VectorXd v;
      /// Approach speed at which the present or last contact of each clearance
      /// joint began [m/s].
      std::vector<double> approach_speeds;
      /// States z of the friction laws that have one [m].
      Eigen::VectorXd friction_states = Eigen::VectorXd();
      /// Whether the pin of each joint with impacts follows the bore, in the
      /// order of Mechanism::impact_joints(), or flies; empty: all fly.
      std::vector<bool> is_following = std::vector<bool>();
    };
  } // namespace Multibody
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_system_mechanism_parameters_h
#define tribody_multibody_system_mechanism_parameters_h

#include <tribody/multibody/elements/body_parameters.h>
#include <tribody/multibody/elements/driver_parameters.h>
#include <tribody/multibody/elements/force_parameters.h>
#include <tribody/multibody/elements/rotational_spring_parameters.h>
#include <tribody/multibody/elements/spring_parameters.h>
#include <tribody/multibody/elements/watched_marker_parameters.h>
#include <tribody/multibody/joints/joint_parameters.h>

#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    /// Everything that defines a mechanism, by names.
    struct MechanismParameters
    {
      /// The frame and its markers, the "ground" of joints and springs.
      GroundParameters ground;
      /// At least one; numbered in this order.
      std::vector<BodyParameters> bodies;
      /// Including those with clearance.
      std::vector<JointParameters> joints;
      /// Between two markers.
      std::vector<SpringParameters> springs;
      /// Between two bodies.
      std::vector<RotationalSpringParameters> rotational_springs;
      /// A turn of the first one is the period of the motion.
      std::vector<DriverParameters> drivers;
      /// Given functions of time, at markers.
      std::vector<ForceParameters> forces;
      /// Given functions of time, between two bodies.
      std::vector<TorqueParameters> torques;
      /// Whose paths are compared with those of ideal joints.
      std::vector<WatchedMarkerParameters> watched_markers;
      /// Acceleration of gravity [m/s^2].
      dealii::Point<2> gravity;
      /// Constraints that follow from others wherever the mechanism is; whoever
      /// makes a mechanism of these counts them, see
      /// count_redundant_constraints().
      unsigned int n_redundant = 0;

      /// Check every entry by itself and that names are unique. References
      /// between them are checked by Mechanism. @throws ExcParameter.
      void
      check() const;
    };

    /// The same mechanism with every clearance joint made ideal.
    MechanismParameters
    with_ideal_joints(const MechanismParameters &parameters);
  } // namespace Multibody
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_system_mechanism_parameters_h
#define tribody_multibody_system_mechanism_parameters_h

#include <tribody/multibody/elements/body_parameters.h>
#include <tribody/multibody/elements/driver_parameters.h>
#include <tribody/multibody/elements/force_parameters.h>
#include <tribody/multibody/elements/rotational_spring_parameters.h>
#include <tribody/multibody/elements/spring_parameters.h>
#include <tribody/multibody/joints/joint_parameters.h>

#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    /// Everything that defines a mechanism, by names.
    struct MechanismParameters
    {
      GroundParameters                        ground;
      std::vector<BodyParameters>             bodies;
      std::vector<JointParameters>            joints;
      std::vector<SpringParameters>           springs;
      std::vector<RotationalSpringParameters> rotational_springs;
      std::vector<DriverParameters>           drivers;
      std::vector<ForceParameters>            forces;
      std::vector<TorqueParameters>           torques;
      /// Acceleration of gravity [m/s^2].
      dealii::Point<2> gravity;

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

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_rotational_spring_parameters_h
#define tribody_multibody_elements_rotational_spring_parameters_h

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  namespace Multibody
  {
    /// A linear rotational spring with damper between two bodies.
    struct RotationalSpringParameters
    {
      /// From the title of the subsection; unique among the rotational springs.
      std::string name;
      /// The body whose angle counts.
      std::string body;
      /// The body that the angle is measured from.
      std::string reference_body = "ground";
      /// Stiffness [N m/rad].
      double stiffness = 0.;
      /// Angle at which the torque is torque_at_reference_angle [rad].
      double reference_angle = 0.;
      /// Torque at that angle [N m]; 0 makes it the free angle.
      double torque_at_reference_angle = 0.;
      /// Damping [N m s/rad].
      double damping = 0.;

      /// Declares in the current subsection, "Rotational spring <name>".
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// @throws ExcParameter with paths that start with
      ///   "Rotational spring <name>".
      void
      check() const;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_body_parameters_h
#define tribody_multibody_elements_body_parameters_h

#include <deal.II/base/point.h>

#include <map>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  namespace Multibody
  {
    /// Named points of the frame that does not move.
    struct GroundParameters
    {
      /// Positions in global axes [m].
      std::map<std::string, dealii::Point<2>> markers = {
        {"O", dealii::Point<2>()}};

      /// Declares in the current subsection, "Ground".
      void
      add_parameters(dealii::ParameterHandler &prm);
    };

    /// A rigid body with its frame at the centre of mass.
    struct BodyParameters
    {
      /// From the title of the subsection; unique among the bodies.
      std::string name;
      /// Mass [kg].
      double mass = 1.;
      /// Moment of inertia about the centre of mass [kg m^2].
      double moment_of_inertia = 1.;
      /// Points to which joints and springs attach, in the body's frame [m].
      std::map<std::string, dealii::Point<2>> markers = {
        {"O", dealii::Point<2>()}};
      /// Centre of mass at the start [m]; a guess that Newton improves.
      dealii::Point<2> initial_position;
      /// Angle at the start [rad]; a guess too.
      double initial_angle = 0.;
      /// Velocity of the centre of mass at the start [m/s], which is projected
      /// onto what the joints allow.
      dealii::Point<2> initial_velocity;
      /// Angular velocity at the start, counter-clockwise [rad/s]; projected
      /// too.
      double initial_angular_velocity = 0.;

      /// Declares in the current subsection, "Body <name>".
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// @throws ExcParameter with paths that start with "Body <name>".
      void
      check() const;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

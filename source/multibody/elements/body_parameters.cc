// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/multibody/elements/body_parameters.h>

namespace Tribody
{
  namespace Multibody
  {
    void
    GroundParameters::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_named_points(
        prm,
        "Markers",
        markers,
        "m",
        "Named points of the frame that does not move, in global axes: 'O: 0 "
        "mm, 0 mm; W: 1 m, 0 m'. Joints and springs refer to them as "
        "'ground.O'.");
    }



    void
    BodyParameters::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_quantity(
        prm,
        "Mass",
        mass,
        "kg",
        "Mass of the body. It may be zero where joints tie the "
        "body's motion to bodies with mass, and in a kinematic analysis.");
      Parameters::add_quantity(prm,
                               "Moment of inertia",
                               moment_of_inertia,
                               "kg m^2",
                               "Moment of inertia about the centre of mass.");
      Parameters::add_named_points(
        prm,
        "Markers",
        markers,
        "m",
        "Named points of the body, in its own frame, whose origin is the "
        "centre of mass: 'O: -38.1 mm, 0 mm; A: 38.1 mm, 0 mm'. Joints and "
        "springs refer to them as '<body>.A'.");
      Parameters::add_point(
        prm,
        "Initial position",
        initial_position,
        "m",
        "Where the centre of mass is at the start, roughly: the mechanism is "
        "assembled from there by Newton's method. It decides which of "
        "several ways to assemble it is taken. Where joints and drivers leave "
        "degrees of freedom, the first bodies of the list keep their angles, "
        "or "
        "positions, exactly.");
      Parameters::add_quantity(prm,
                               "Initial angle",
                               initial_angle,
                               "rad",
                               "Angle of the body's x axis at the start, "
                               "counter-clockwise from the global one, "
                               "roughly, in the same sense. Whole turns do not "
                               "count.",
                               "deg");
      Parameters::add_point(prm,
                            "Initial velocity",
                            initial_velocity,
                            "m/s",
                            "Velocity of the centre of mass at the start of "
                            "the dynamics. The velocities of all bodies are "
                            "changed as little as it takes to obey joints "
                            "and drivers; without degrees of freedom these "
                            "alone decide.");
      Parameters::add_quantity(prm,
                               "Initial angular velocity",
                               initial_angular_velocity,
                               "rad/s",
                               "Angular velocity at the start, positive "
                               "counter-clockwise, in the same sense.",
                               "rpm");
    }



    void
    BodyParameters::check() const
    {
      const std::string path = "Body " + name;
      AssertThrow(name != "ground",
                  ExcParameter("Bodies",
                               "'ground' is the name of the frame that does "
                               "not move; choose another one"));
      AssertThrow(mass >= 0,
                  ExcParameter(path + "/Mass",
                               "must be zero or positive, not " +
                                 Units::to_string(mass, "kg", "kg")));
      AssertThrow(moment_of_inertia >= 0,
                  ExcParameter(
                    path + "/Moment of inertia",
                    "must be zero or positive, not " +
                      Units::to_string(moment_of_inertia, "kg m^2", "kg m^2")));
    }
  } // namespace Multibody
} // namespace Tribody

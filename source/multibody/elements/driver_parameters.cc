// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/multibody/elements/driver_parameters.h>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      void
      add_angle(dealii::ParameterHandler &prm, DriverParameters &p)
      {
        Parameters::add_text(prm,
                             "Body",
                             p.body,
                             "Angle: the body that the motor turns.");
        Parameters::add_text(prm,
                             "Reference body",
                             p.reference_body,
                             "Angle: the body from which the angle is "
                             "measured; 'ground' for the frame.");
        Parameters::add_quantity(
          prm,
          "Speed",
          p.speed,
          "rad/s",
          "Angle: angular speed, positive counter-clockwise. One revolution "
          "of the first driver at this speed is one duty cycle, unless "
          "'Dynamics/Cycle duration' is set.",
          "rpm");
        Parameters::add_quantity(prm,
                                 "Initial angle",
                                 p.initial_angle,
                                 "rad",
                                 "Angle: that of the body relative to the "
                                 "reference body at time 0, but for the time "
                                 "function, exactly.",
                                 "deg");
        Parameters::add_quantity(prm,
                                 "Angle amplitude",
                                 p.angle_amplitude,
                                 "rad",
                                 "Angle: factor a of the time function; the "
                                 "angle is Initial angle + Speed t + a f(t).",
                                 "deg");
      }



      void
      add_distance(dealii::ParameterHandler &prm, DriverParameters &p)
      {
        Parameters::add_text(prm,
                             "First marker",
                             p.first_marker,
                             "Distance: one end, '<body>.<marker>'.");
        Parameters::add_text(prm,
                             "Second marker",
                             p.second_marker,
                             "Distance: the other end, '<body>.<marker>'.");
        Parameters::add_quantity(prm,
                                 "Initial distance",
                                 p.initial_distance,
                                 "m",
                                 "Distance: that of the two markers at time 0, "
                                 "but for the time function, exactly.",
                                 "mm");
        Parameters::add_quantity(prm,
                                 "Distance speed",
                                 p.distance_speed,
                                 "m/s",
                                 "Distance: its constant rate.",
                                 "mm/s");
        Parameters::add_quantity(prm,
                                 "Distance amplitude",
                                 p.distance_amplitude,
                                 "m",
                                 "Distance: factor a of the time function; the "
                                 "distance is Initial distance + Distance "
                                 "speed t + a f(t).",
                                 "mm");
      }
    } // namespace



    void
    DriverParameters::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_choice(prm,
                             "Type",
                             type,
                             "'angle': a motor between two bodies. "
                             "'distance': an actuator between two markers. "
                             "Entries that belong to the other type are "
                             "ignored.");
      add_angle(prm, *this);
      add_distance(prm, *this);
      Parameters::add_text(prm,
                           "Time function",
                           time_function,
                           "f(t), an expression of the time t in seconds, for "
                           "example 'sin(2*pi*t)'. It must have two continuous "
                           "derivatives, which are taken by differences of "
                           "eighth order: their error is 1e-9 of the fastest "
                           "part of the function.");
    }



    void
    DriverParameters::check() const
    {
      const std::string path = "Driver " + name + "/";
      if (is_angle())
        {
          AssertThrow(body != reference_body,
                      ExcParameter(path + "Reference body",
                                   "is '" + reference_body +
                                     "', the body that is driven itself"));
        }
      else
        {
          AssertThrow(first_marker != second_marker,
                      ExcParameter(path + "Second marker",
                                   "is '" + second_marker +
                                     "' like the first one"));
          AssertThrow(
            initial_distance > 0,
            ExcParameter(path + "Initial distance",
                         "must be positive, not " +
                           Units::to_string(initial_distance, "m", "mm") +
                           ": the direction between markers that "
                           "coincide is not defined"));
        }
    }
  } // namespace Multibody
} // namespace Tribody

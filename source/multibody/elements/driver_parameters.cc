// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/in_quotes.h>
#include <tribody/base/parameters.h>
#include <tribody/base/significant_digits.h>
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



      /// @throws ExcParameter for what the table of a driver takes the place
      /// of.
      void
      check_table_alone(const std::string &path, const DriverParameters &p)
      {
        const std::string cure =
          ", but 'Table' gives the motion over time; remove one of the two";
        AssertThrow(p.time_function == "0",
                    ExcParameter(path + "Time function",
                                 "is " + in_quotes(p.time_function) + cure));
        AssertThrow(
          !p.is_angle() || p.angle_amplitude == 0.,
          ExcParameter(path + "Angle amplitude",
                       "is " +
                         Units::to_string(p.angle_amplitude, "rad", "deg") +
                         cure));
        AssertThrow(
          p.is_angle() || p.distance_amplitude == 0.,
          ExcParameter(path + "Distance amplitude",
                       "is " +
                         Units::to_string(p.distance_amplitude, "m", "mm") +
                         cure));
        AssertThrow(
          p.speed == 0. || p.table_speed == 0.,
          ExcParameter(
            path + "Speed",
            "is " + Units::to_string(p.speed, "rad/s", "rpm") +
              ", but the angle in 'Table' turns by itself, "
              "with " +
              significant_digits(p.table_speed * 30. / dealii::numbers::PI, 6) +
              " rpm; remove one of the two"));
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
      table.add_parameters(
        prm,
        "Its column with the angle or the distance, to which "
        "'Initial angle' and 'Speed', or 'Initial distance' "
        "and 'Distance speed', are added. An angle may end "
        "whole turns further than it begins. A table that "
        "is 'linear' is refused.");
    }



    void
    DriverParameters::read_table()
    {
      table_function.reset();
      table_speed = 0.;
      if (!table.is_given())
        return;
      const std::string path = "Driver " + name;
      AssertThrow(
        table.interpolation == TableInterpolation::cubic,
        ExcParameter(path + "/Interpolation",
                     "'linear' has kinks, where velocities would have "
                     "to jump; the motion of a driver needs two "
                     "continuous derivatives. Write 'cubic'"));
      TableParameters::Columns columns =
        table.read(path,
                   is_angle()
                     ? TableParameters::Quantity{"rad",
                                                 "deg",
                                                 2. * dealii::numbers::PI,
                                                 1,
                                                 "that of the angle"}
                     : TableParameters::Quantity{
                         "m", "mm", 0., 1, "that of the distance"});
      Eigen::VectorXd &values = columns.values[0];
      AssertThrow(
        is_angle() || initial_distance + values.minCoeff() > 0.,
        ExcParameter(path + "/Table",
                     "has a distance of " +
                       Units::to_string(values.minCoeff(), "m", "mm") +
                       (initial_distance != 0.
                          ? ", with 'Initial distance' " +
                              Units::to_string(
                                initial_distance + values.minCoeff(), "m", "mm")
                          : "") +
                       "; it must be positive: the direction between "
                       "markers that coincide is not defined"));

      const Eigen::Index last = values.size() - 1;
      table_speed =
        (values[last] - values[0]) / (columns.times[last] - columns.times[0]);
      values -= table_speed * columns.times;
      values[last] = values[0];
      table_function.emplace(
        PeriodicTable(columns.times, values, table.interpolation));
    }



    DriverMotion
    DriverParameters::motion() const
    {
      Assert(!table.is_given() || table_function.has_value(),
             dealii::ExcMessage("no table is read"));
      const TimeFunction function =
        table_function
          ? *table_function
          : TimeFunction("Driver " + name + "/Time function", time_function);
      if (is_angle())
        return {initial_angle,
                mean_speed(),
                table_function ? 1. : angle_amplitude,
                function};
      return {initial_distance,
              distance_speed,
              table_function ? 1. : distance_amplitude,
              function};
    }



    void
    DriverParameters::check() const
    {
      const std::string path = "Driver " + name + "/";
      if (table.is_given())
        check_table_alone(path, *this);
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
            initial_distance > 0 || table.is_given(),
            ExcParameter(path + "Initial distance",
                         "must be positive, not " +
                           Units::to_string(initial_distance, "m", "mm") +
                           ": the direction between markers that "
                           "coincide is not defined"));
        }
    }
  } // namespace Multibody
} // namespace Tribody

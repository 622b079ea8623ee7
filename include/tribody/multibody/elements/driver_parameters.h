// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_driver_parameters_h
#define tribody_multibody_elements_driver_parameters_h

#include <tribody/base/choice.h>
#include <tribody/multibody/elements/driver_motion.h>
#include <tribody/tables/table_parameters.h>

#include <optional>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  namespace Multibody
  {
    /// What a driver prescribes.
    enum class DriverType
    {
      angle,
      distance
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<DriverType>
    choice_names(const DriverType)
    {
      return {{DriverType::angle, "angle"}, {DriverType::distance, "distance"}};
    }

    /**
     * A motor that prescribes the angle of one body relative to another, or an
     * actuator that prescribes the distance of two markers: the value at time
     * 0, plus a constant speed times t, plus an amplitude times an expression
     * of t, or plus what a table has. Entries of the other type are ignored.
     */
    struct DriverParameters
    {
      /// From the title of the subsection; unique among the drivers.
      std::string name;
      /// Whether it is a motor or an actuator.
      DriverType type = DriverType::angle;

      /// The body that is turned.
      std::string body;
      /// The body that its angle is measured from.
      std::string reference_body = "ground";
      /// Angular speed, counter-clockwise [rad/s].
      double speed = 0.;
      /// Angle at time 0 [rad].
      double initial_angle = 0.;
      /// Factor of the time function [rad].
      double angle_amplitude = 0.;

      /// One end of an actuator, "<body>.<marker>".
      std::string first_marker = "ground.O";
      /// The other end.
      std::string second_marker = "ground.O";
      /// Distance at time 0 [m].
      double initial_distance = 0.;
      /// Its constant rate [m/s].
      double distance_speed = 0.;
      /// Factor of the time function [m].
      double distance_amplitude = 0.;

      /// f(t).
      std::string time_function = "0";
      /// Instead of amplitude and function.
      TableParameters table{TableInterpolation::cubic};
      /// What it adds to the motion, periodic [rad or m]; empty without one.
      std::optional<TimeFunction> table_function;
      /// Mean rate of a table whose angle makes whole turns [rad/s].
      double table_speed = 0.;

      /// Declares in the current subsection, "Driver <name>".
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// Set what comes from the table if there is one. @throws ExcParameter.
      void
      read_table();

      /// @throws ExcParameter with paths that start with "Driver <name>".
      void
      check() const;

      /// What it prescribes. @throws ExcParameter for an expression that cannot
      /// be parsed.
      DriverMotion
      motion() const;

      /// Mean angular speed [rad/s].
      double
      mean_speed() const
      {
        return speed + table_speed;
      }

      /// Of the parameter that the function comes from.
      std::string
      path_of_function() const
      {
        return "Driver " + name +
               (table.is_given() ? "/Table" : "/Time function");
      }

      /// Whether it prescribes an angle: a motor, not an actuator.
      bool
      is_angle() const
      {
        return type == DriverType::angle;
      }
    };
  } // namespace Multibody
} // namespace Tribody

#endif

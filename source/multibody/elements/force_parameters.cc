// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/base/in_quotes.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/multibody/elements/force_parameters.h>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      const std::string constant_one = "1";



      /// @throws ExcParameter if @p time_function is another than the default.
      void
      check_table_alone(const std::string &path,
                        const std::string &time_function)
      {
        AssertThrow(time_function == constant_one,
                    ExcParameter(path + "/Time function",
                                 "is " + in_quotes(time_function) +
                                   ", but 'Table' gives the values over time; "
                                   "remove one of the two"));
      }
    } // namespace



    void
    ForceParameters::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_text(prm,
                           "Marker",
                           marker,
                           "Where the force acts, '<body>.<marker>'.");
      Parameters::add_point(prm,
                            "Vector",
                            vector,
                            "N",
                            "The force, times 'Time function': '0 N, -10 N'. "
                            "With one column of a table: its direction, "
                            "whatever its length.");
      Parameters::add_choice(prm,
                             "Axes",
                             axes,
                             "Axes of 'Vector': 'global' ones, which do not "
                             "move, or those of the 'body', with which the "
                             "force turns.");
      Parameters::add_text(prm,
                           "Time function",
                           time_function,
                           "A factor as an expression of the time t in "
                           "seconds: 'sin(2*pi*t)', 'if(t < 0.1, 10*t, 1)'.");
      table.add_parameters(prm,
                           "Its columns: one for the force in the direction of "
                           "'Vector', or two, separated by a comma, for the x "
                           "and y components in 'Axes'.");
    }



    void
    ForceParameters::read_table()
    {
      table_functions.clear();
      if (!table.is_given())
        return;
      const TableParameters::Columns columns =
        table.read("Force " + name,
                   {"N",
                    "N",
                    0.,
                    2,
                    "one for the force in the direction of 'Vector', or two "
                    "for its x and y components"});
      for (const Eigen::VectorXd &values : columns.values)
        table_functions.emplace_back(
          PeriodicTable(columns.times, values, table.interpolation));
    }



    void
    ForceParameters::check() const
    {
      if (!table.is_given())
        return;
      const std::string path = "Force " + name;
      check_table_alone(path, time_function);
      const bool has_vector = vector != dealii::Point<2>();
      AssertThrow(has_vector || table_functions.size() > 1,
                  ExcParameter(path + "/Vector",
                               "is zero, but 'Table' has one column, the force "
                               "in the direction of this vector. Set it, '0 N, "
                               "-1 N' for a force downwards, or name two "
                               "columns"));
      AssertThrow(!has_vector || table_functions.size() == 1,
                  ExcParameter(path + "/Vector",
                               "is '" + Units::to_string(vector[0], "N", "N") +
                                 ", " + Units::to_string(vector[1], "N", "N") +
                                 "', but 'Table' has both components of the "
                                 "force; remove it, or name one column"));
    }



    std::vector<ForceParameters::Part>
    ForceParameters::parts() const
    {
      const Eigen::Vector2d given(vector[0], vector[1]);
      if (!table.is_given())
        return {
          {given,
           TimeFunction("Force " + name + "/Time function", time_function)}};
      Assert(!table_functions.empty(), dealii::ExcMessage("no table is read"));
      if (table_functions.size() == 1)
        return {{given.normalized(), table_functions[0]}};
      return {{Eigen::Vector2d::UnitX(), table_functions[0]},
              {Eigen::Vector2d::UnitY(), table_functions[1]}};
    }



    void
    TorqueParameters::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_text(prm,
                           "Body",
                           body,
                           "The body that the torque acts on.");
      Parameters::add_text(prm,
                           "Reference body",
                           reference_body,
                           "The body that takes the opposite torque; 'ground' "
                           "for the frame.");
      Parameters::add_quantity(prm,
                               "Torque",
                               torque,
                               "N m",
                               "The torque, times 'Time function'; positive "
                               "counter-clockwise.");
      Parameters::add_text(prm,
                           "Time function",
                           time_function,
                           "A factor as an expression of the time t in "
                           "seconds: 'sin(2*pi*t)', 'if(t < 0.1, 10*t, 1)'.");
      table.add_parameters(prm,
                           "Its column with the torque, positive "
                           "counter-clockwise.");
    }



    void
    TorqueParameters::read_table()
    {
      table_function.reset();
      if (!table.is_given())
        return;
      const TableParameters::Columns columns =
        table.read("Torque " + name,
                   {"N m", "N m", 0., 1, "that of the torque"});
      table_function.emplace(
        PeriodicTable(columns.times, columns.values[0], table.interpolation));
    }



    TimeFunction
    TorqueParameters::function() const
    {
      Assert(!table.is_given() || table_function.has_value(),
             dealii::ExcMessage("no table is read"));
      return table_function ? *table_function
                            : TimeFunction("Torque " + name + "/Time function",
                                           time_function);
    }



    void
    TorqueParameters::check() const
    {
      if (table.is_given())
        {
          check_table_alone("Torque " + name, time_function);
          AssertThrow(
            torque == 0.,
            ExcParameter("Torque " + name + "/Torque",
                         "is " + Units::to_string(torque, "N m", "N m") +
                           ", but 'Table' gives the values over time; "
                           "remove one of the two"));
        }
      AssertThrow(body != reference_body,
                  ExcParameter("Torque " + name + "/Reference body",
                               "is '" + reference_body +
                                 "', the body that the torque acts on"));
    }
  } // namespace Multibody
} // namespace Tribody

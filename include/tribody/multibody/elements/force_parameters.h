// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_force_parameters_h
#define tribody_multibody_elements_force_parameters_h

#include <deal.II/base/point.h>

#include <Eigen/Core>

#include <tribody/base/choice.h>
#include <tribody/multibody/elements/time_function.h>
#include <tribody/tables/table_parameters.h>

#include <optional>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  namespace Multibody
  {
    /// In which axes a force is given: those that do not move, or the body's.
    enum class ForceAxes
    {
      global,
      body
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<ForceAxes>
    choice_names(const ForceAxes)
    {
      return {{ForceAxes::global, "global"}, {ForceAxes::body, "body"}};
    }

    /// A given force at a marker.
    struct ForceParameters
    {
      /// From the title of the subsection; unique among the forces.
      std::string name;
      /// Where it acts, "<body>.<marker>".
      std::string marker = "ground.O";
      /// Force where the time function is 1 [N]; only the direction counts
      /// where the table has one column.
      dealii::Point<2> vector;
      /// Those in which the vector is given.
      ForceAxes axes = ForceAxes::global;
      /// Factor as an expression of t.
      std::string time_function = "1";
      /// Instead of it.
      TableParameters table{TableInterpolation::linear};
      /// The force along the vector, or its two components [N]; empty without a
      /// table.
      std::vector<TimeFunction> table_functions;

      /// A force f(t) F.
      struct Part
      {
        /// F [N].
        Eigen::Vector2d vector;
        /// f [-].
        TimeFunction function;
      };

      /// Declares in the current subsection, "Force <name>".
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// Set the functions of the table if there is one. @throws ExcParameter.
      void
      read_table();

      /// @throws ExcParameter with paths that start with "Force <name>". What
      /// it refers to is checked by Mechanism.
      void
      check() const;

      /// The force is their sum: two where a table has both components.
      /// @throws ExcParameter for an expression that cannot be parsed.
      std::vector<Part>
      parts() const;

      /// Of the parameter that its functions come from.
      std::string
      path_of_function() const
      {
        return "Force " + name +
               (table.is_given() ? "/Table" : "/Time function");
      }
    };

    /// A given torque between two bodies.
    struct TorqueParameters
    {
      /// From the title of the subsection; unique among the torques.
      std::string name;
      /// The body that it acts on.
      std::string body;
      /// The body that takes the reaction.
      std::string reference_body = "ground";
      /// Torque where the time function is 1 [N m].
      double torque = 0.;
      /// Factor as an expression of t.
      std::string time_function = "1";
      /// Instead of torque and factor.
      TableParameters table{TableInterpolation::linear};
      /// The torque [N m]; empty without a table.
      std::optional<TimeFunction> table_function;

      /// Declares in the current subsection, "Torque <name>".
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// Set the function of the table if there is one. @throws ExcParameter.
      void
      read_table();

      /// @throws ExcParameter with paths that start with "Torque <name>".
      void
      check() const;

      /// The torque where function() is 1 [N m].
      double
      factor() const
      {
        return table_function ? 1. : torque;
      }

      /// @throws ExcParameter for an expression that cannot be parsed.
      TimeFunction
      function() const;

      /// Of the parameter that the function comes from.
      std::string
      path_of_function() const
      {
        return "Torque " + name +
               (table.is_given() ? "/Table" : "/Time function");
      }
    };
  } // namespace Multibody
} // namespace Tribody

#endif

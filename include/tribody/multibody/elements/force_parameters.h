// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_force_parameters_h
#define tribody_multibody_elements_force_parameters_h

#include <deal.II/base/point.h>

#include <tribody/base/choice.h>

#include <string>

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
      /// Force where the time function is 1 [N].
      dealii::Point<2> vector;
      /// Those in which the vector is given.
      ForceAxes axes = ForceAxes::global;
      /// Factor as an expression of t.
      std::string time_function = "1";

      /// Declares in the current subsection, "Force <name>".
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// Nothing: what can be wrong are references, which Mechanism checks.
      void
      check() const
      {}
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

      /// Declares in the current subsection, "Torque <name>".
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// @throws ExcParameter with paths that start with "Torque <name>".
      void
      check() const;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

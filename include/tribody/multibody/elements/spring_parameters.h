// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_spring_parameters_h
#define tribody_multibody_elements_spring_parameters_h

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  namespace Multibody
  {
    /// A linear spring with damper between two markers.
    struct SpringParameters
    {
      /// From the title of the subsection; unique among the springs.
      std::string name;
      /// One end, "<body>.<marker>".
      std::string first_marker = "ground.O";
      /// The other end.
      std::string second_marker = "ground.O";
      /// Stiffness [N/m].
      double stiffness = 0.;
      /// Length at which the tension is force_at_reference_length [m].
      double reference_length = 0.;
      /// Tension at that length [N]; 0 makes it the free length.
      double force_at_reference_length = 0.;
      /// Damping [N s/m].
      double damping = 0.;

      /// Declares in the current subsection, "Spring <name>".
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// @throws ExcParameter with paths that start with "Spring <name>".
      void
      check() const;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

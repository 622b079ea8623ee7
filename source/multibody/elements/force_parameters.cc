// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/multibody/elements/force_parameters.h>

namespace Tribody
{
  namespace Multibody
  {
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
                            "The force, times 'Time function': '0 N, -10 N'.");
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
    }



    void
    TorqueParameters::check() const
    {
      AssertThrow(body != reference_body,
                  ExcParameter("Torque " + name + "/Reference body",
                               "is '" + reference_body +
                                 "', the body that the torque acts on"));
    }
  } // namespace Multibody
} // namespace Tribody

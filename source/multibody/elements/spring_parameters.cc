// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/multibody/elements/spring_parameters.h>

namespace Tribody
{
  namespace Multibody
  {
    void
    SpringParameters::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_text(prm,
                           "First marker",
                           first_marker,
                           "One end, '<body>.<marker>'.");
      Parameters::add_text(prm,
                           "Second marker",
                           second_marker,
                           "The other end, '<body>.<marker>'.");
      Parameters::add_quantity(prm,
                               "Stiffness",
                               stiffness,
                               "N/m",
                               "k in the tension F_0 + k (l - l_0) + d l'.");
      Parameters::add_quantity(prm,
                               "Reference length",
                               reference_length,
                               "m",
                               "l_0, the length at which the tension is "
                               "'Force at reference length'.",
                               "mm");
      Parameters::add_quantity(prm,
                               "Force at reference length",
                               force_at_reference_length,
                               "N",
                               "F_0, positive if it pulls the ends together. "
                               "With 0 N the reference length is the free "
                               "length; with zero stiffness the force is "
                               "constant.");
      Parameters::add_quantity(prm,
                               "Damping",
                               damping,
                               "N s/m",
                               "d, of the damper beside the spring.");
    }



    void
    SpringParameters::check() const
    {
      const auto check_not_negative = [&](const std::string &entry,
                                          const double       value,
                                          const std::string &unit) {
        AssertThrow(value >= 0,
                    ExcParameter("Spring " + name + "/" + entry,
                                 "must be zero or positive, not " +
                                   Units::to_string(value, unit, unit)));
      };
      check_not_negative("Stiffness", stiffness, "N/m");
      check_not_negative("Reference length", reference_length, "m");
      check_not_negative("Damping", damping, "N s/m");
    }
  } // namespace Multibody
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/multibody/elements/rotational_spring_parameters.h>

namespace Tribody
{
  namespace Multibody
  {
    void
    RotationalSpringParameters::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_text(prm,
                           "Body",
                           body,
                           "The body whose angle the spring holds.");
      Parameters::add_text(prm,
                           "Reference body",
                           reference_body,
                           "The body from which the angle is measured; "
                           "'ground' for the frame.");
      Parameters::add_quantity(prm,
                               "Stiffness",
                               stiffness,
                               "N m/rad",
                               "k in the torque M_0 + k (theta - theta_0) + d "
                               "theta', which turns the body back. The angle "
                               "theta counts whole turns.");
      Parameters::add_quantity(prm,
                               "Reference angle",
                               reference_angle,
                               "rad",
                               "theta_0, the angle of the body relative to the "
                               "reference body at which the torque is 'Torque "
                               "at reference angle'.",
                               "deg");
      Parameters::add_quantity(prm,
                               "Torque at reference angle",
                               torque_at_reference_angle,
                               "N m",
                               "M_0, positive if it turns the body clockwise, "
                               "towards smaller angles. With 0 N m the "
                               "reference angle is the free angle.");
      Parameters::add_quantity(prm,
                               "Damping",
                               damping,
                               "N m s/rad",
                               "d, of the damper beside the spring.");
    }



    void
    RotationalSpringParameters::check() const
    {
      const std::string path = "Rotational spring " + name + "/";
      AssertThrow(body != reference_body,
                  ExcParameter(path + "Reference body",
                               "is '" + reference_body +
                                 "', the body that the spring holds"));
      const auto check_not_negative = [&](const std::string &entry,
                                          const double       value,
                                          const std::string &unit) {
        AssertThrow(value >= 0,
                    ExcParameter(path + entry,
                                 "must be zero or positive, not " +
                                   Units::to_string(value, unit, unit)));
      };
      check_not_negative("Stiffness", stiffness, "N m/rad");
      check_not_negative("Damping", damping, "N m s/rad");
    }
  } // namespace Multibody
} // namespace Tribody

#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/multibody/driver_parameters.h>

namespace Tribody
{
  namespace Multibody
  {
    void
    DriverParameters::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_text(prm, "Body", body, "The body that the motor turns.");
      Parameters::add_text(prm,
                           "Reference body",
                           reference_body,
                           "The body from which the angle is measured; "
                           "'ground' for the frame.");
      Parameters::add_quantity(prm,
                               "Speed",
                               speed,
                               "rad/s",
                               "Angular speed, positive counter-clockwise. "
                               "One revolution of the first driver is one "
                               "duty cycle.",
                               "rpm");
      Parameters::add_quantity(prm,
                               "Initial angle",
                               initial_angle,
                               "rad",
                               "Angle of the body relative to the reference "
                               "body at time 0, exactly.",
                               "deg");
    }



    void
    DriverParameters::check() const
    {
      AssertThrow(body != reference_body,
                  ExcParameter("Driver " + name + "/Reference body",
                               "is '" + reference_body +
                                 "', the body that is driven itself"));
    }
  } // namespace Multibody
} // namespace Tribody

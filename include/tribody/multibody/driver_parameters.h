#ifndef tribody_multibody_driver_parameters_h
#define tribody_multibody_driver_parameters_h

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  namespace Multibody
  {
    /// A motor that turns one body relative to another at constant speed.
    struct DriverParameters
    {
      std::string name;
      /// The body that is turned.
      std::string body;
      /// The body that its angle is measured from.
      std::string reference_body = "ground";
      /// Angular speed, counter-clockwise [rad/s].
      double speed = 3.14159265358979324;
      /// Angle at time 0 [rad].
      double initial_angle = 0.;

      /// Declares in the current subsection, "Driver <name>".
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// @throws ExcParameter with paths that start with "Driver <name>".
      void
      check() const;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_wear_factor_value_h
#define tribody_wear_factor_value_h

#include <limits>

namespace Tribody
{
  namespace Wear
  {
    /// How pin and bushing slide on each other in one sample of a cycle.
    struct Sliding
    {
      /// Distance slid in the sample [m], not negative.
      double increment = 0.;
      /// Speed v [m/s], not negative.
      double speed = 0.;
      /// Distance s that the joint has slid before this cycle [m].
      double distance = 0.;
      /// What multiplies the wear coefficients meanwhile, whatever they depend
      /// on [-].
      double factor = 1.;
      /// T of the contact [K]; not a number where nobody knows it, and then
      /// nothing depends on it.
      double temperature = std::numeric_limits<double>::quiet_NaN();
    };

    /// What multiplies a wear coefficient, with its derivative.
    struct FactorValue
    {
      /// [-], not negative.
      double value = 1.;
      /// Its derivative with respect to the pressure [Pa^-1].
      double d_pressure = 0.;
    };
  } // namespace Wear
} // namespace Tribody

#endif

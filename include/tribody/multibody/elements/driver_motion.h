// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_driver_motion_h
#define tribody_multibody_elements_driver_motion_h

#include <tribody/multibody/elements/time_function.h>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * What a driver prescribes, @f$ c(t) = c_0 + \dot c_0 t + a f(t) @f$: an
     * angle [rad] or a distance [m].
     */
    struct DriverMotion
    {
      /// c_0 [rad or m].
      double initial = 0.;
      /// c'_0 [rad/s or m/s].
      double speed = 0.;
      /// a [rad or m].
      double amplitude = 0.;
      /// f [-].
      TimeFunction function;

      /// c at time @p t [s], in rad or m.
      double
      value(const double t) const
      {
        return initial + speed * t +
               (amplitude == 0. ? 0. : amplitude * function.value(t));
      }

      /// c' [rad/s or m/s].
      double
      first_derivative(const double t) const
      {
        return speed +
               (amplitude == 0. ? 0. : amplitude * function.derivatives(t)[0]);
      }

      /// c'' [rad/s^2 or m/s^2].
      double
      second_derivative(const double t) const
      {
        return amplitude == 0. ? 0. : amplitude * function.derivatives(t)[1];
      }
    };
  } // namespace Multibody
} // namespace Tribody

#endif

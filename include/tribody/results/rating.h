// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_results_rating_h
#define tribody_results_rating_h

#include <tribody/bushing/bushing_parameters.h>
#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/multibody/joints/joint_parameters.h>

namespace Tribody
{
  namespace Coupling
  {
    /// What catalogues rate a bearing by, in one duty cycle: the force over the
    /// projected area of the bore, 2 R_j L, and how fast it slides.
    struct Rating
    {
      double mean_pressure = 0.; ///< over the time [Pa]
      double max_pressure  = 0.; ///< [Pa]
      double mean_speed    = 0.; ///< over the time [m/s]
      double max_speed     = 0.; ///< [m/s]
      double mean_pv       = 0.; ///< of their product, over the time [Pa m/s]
      double max_pv        = 0.; ///< [Pa m/s]
    };

    /// Of the joint @p loads belong to. @param period of the cycle [s].
    Rating
    rate(const Multibody::JointDutyCycle  &loads,
         const double                      period,
         const BushingParameters          &bushing,
         const Multibody::JointParameters &joint);
  } // namespace Coupling
} // namespace Tribody

#endif

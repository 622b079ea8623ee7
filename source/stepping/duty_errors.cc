// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/stepping/run_state.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace Coupling
  {
    double
    reach_of(const CycleContact &contact)
    {
      // Narrower arcs than that of a few nodes are not told apart.
      constexpr double narrowest = 0.035;
      return std::clamp(contact.at_peak_force().half_angle,
                        narrowest,
                        Multibody::JointDutyCycle::usual_reach);
    }



    DutyErrors
    estimate_duty_errors(const Multibody::DutyCycle      &cycle,
                         const Multibody::JointDutyCycle &joint,
                         const double                     reach)
    {
      DutyErrors errors;
      errors.sampling      = joint.sampling_error(reach);
      errors.inertia       = joint.wear_of_neglected_inertia;
      errors.integration   = cycle.integration_error;
      errors.creep         = joint.creep_share;
      const unsigned int n = cycle.settling.n_averaged_cycles;
      if (n > 1 && joint.mean_force() > 0.)
        // Twice the standard error of the mean.
        errors.settling =
          2. * joint.mean_force_deviation /
          (std::sqrt(static_cast<double>(n)) * joint.mean_force());
      else
        errors.settling = cycle.settling.repeat_difference;
      return errors;
    }
  } // namespace Coupling
} // namespace Tribody

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
      if (contact.samples.empty())
        return Multibody::JointDutyCycle::usual_reach;
      return std::clamp(contact.at_peak_force().half_angle,
                        narrowest,
                        Multibody::JointDutyCycle::usual_reach);
    }



    DutyErrors
    estimate_duty_errors(const Multibody::DutyCycle      &cycle,
                         const Multibody::JointDutyCycle &joint,
                         const Multibody::BearingLoads   &loads,
                         const double                     reach)
    {
      DutyErrors errors;
      errors.sampling = joint.sampling_error(reach) +
                        loads.spread(reach).difference(joint.spread(reach));
      errors.inertia     = joint.wear_of_neglected_inertia;
      errors.integration = joint.integration_error;
      errors.creep       = joint.creep_share;
      const Multibody::SettlingReport &settling = cycle.settling;
      const unsigned int               n        = settling.n_averaged_cycles;
      if (n == 1)
        errors.settling = std::isfinite(settling.distance)
                            ? settling.distance
                            : settling.repeat_difference;
      else
        errors.settling = joint.wear_scatter;
      // What comes nearer steadily no mean takes away.
      if (n > 1 && settling.decay > 0.5 && settling.decay < 1.)
        errors.settling =
          std::max(errors.settling,
                   joint.wear_trend / (1. - std::pow(settling.decay, n - 1.)));
      return errors;
    }
  } // namespace Coupling
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/results/rating.h>

namespace Tribody
{
  namespace Coupling
  {
    Rating
    rate(const Multibody::JointDutyCycle  &loads,
         const double                      period,
         const BushingParameters          &bushing,
         const Multibody::JointParameters &joint)
    {
      Rating rating;
      if (loads.size() == 0)
        return rating;
      const Eigen::VectorXd pressure =
        loads.normal_force / (2. * joint.bushing_radius * bushing.axial_length);
      rating.max_pressure = pressure.maxCoeff();
      rating.mean_pressure =
        loads.durations.size() > 0
          ? pressure.dot(loads.durations) / loads.durations.sum()
          : pressure.mean();
      rating.mean_speed = loads.sliding_distance() / period;
      rating.mean_pv    = pressure.dot(loads.sliding_increment) / period;
      if (loads.sliding_speed.size() > 0)
        {
          rating.max_speed = loads.sliding_speed.maxCoeff();
          rating.max_pv = pressure.cwiseProduct(loads.sliding_speed).maxCoeff();
        }
      return rating;
    }
  } // namespace Coupling
} // namespace Tribody

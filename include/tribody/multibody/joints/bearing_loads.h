// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_joints_bearing_loads_h
#define tribody_multibody_joints_bearing_loads_h

#include <Eigen/Core>

#include <tribody/multibody/joints/wear_spread.h>

namespace Tribody
{
  namespace Multibody
  {
    /// What a cycle does to the surfaces of a revolute joint, all that their
    /// wear follows from: forces and the sliding under each. One entry per
    /// load; in a duty cycle one per sample.
    struct BearingLoads
    {
      /// F_N [N], not negative.
      Eigen::VectorXd normal_force;
      /// Direction of n, from the bushing's centre to the contact, in the frame
      /// of the bushing [rad], [0, 2 pi).
      Eigen::VectorXd contact_angle_bushing;
      /// Direction of n in the frame of the pin [rad], [0, 2 pi).
      Eigen::VectorXd contact_angle_pin;
      /// R_j times the angle turned between pin and bushing under this load
      /// [m], >= 0; in a duty cycle from half an interval before the sample to
      /// half an interval after.
      Eigen::VectorXd sliding_increment;
      /// Mean sliding speed meanwhile [m/s], not negative.
      Eigen::VectorXd sliding_speed;
      /// What multiplies the wear coefficient meanwhile [-]; empty: one.
      Eigen::VectorXd wear_factor = {};

      /// How many there are.
      Eigen::Index
      size() const
      {
        return normal_force.size();
      }

      /// Sum of the sliding increments [m].
      double
      sliding_distance() const;

      /// Mean of the normal force over the sliding distance [N].
      double
      mean_normal_force() const;

      /// The wear that they would make, spread over @p reach [rad].
      WearSpread
      spread(const double reach) const;
    };

    /**
     * Fewer loads that wear nearly the same. Of @p n_cycles that were recorded
     * one after the other, the loads at the same place in the cycle become one,
     * then up to four of these that follow each other: the mean of their forces
     * as vectors in the frame of the bushing, weighted with the sliding, under
     * the sum of it.
     *
     * A mean of forces in different directions is less than that of their
     * magnitudes, and forces of different size wear in other places than their
     * mean. Where least is lost, seen from the bushing or from the pin, loads
     * are merged first, as long as all of it is no more than @p tolerance [-]
     * of force times sliding; the others stay as they are. Last comes the
     * largest load of all with no sliding, for the largest pressure. One cycle
     * is returned as it is.
     */
    BearingLoads
    merge_cycles(const BearingLoads &loads,
                 const unsigned int  n_cycles,
                 const double        tolerance);
  } // namespace Multibody
} // namespace Tribody

#endif

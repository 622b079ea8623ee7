// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/elements/distance_driver.h>
#include <tribody/multibody/elements/marker_distance.h>

namespace Tribody
{
  namespace Multibody
  {
    DistanceDriver::DistanceDriver(const std::string  &description,
                                   const Marker       &first,
                                   const Marker       &second,
                                   const DriverMotion &motion)
      : Constraint(description, {first.body, second.body}, 1)
      , s_1(first.position)
      , s_2(second.position)
      , motion(motion)
    {}



    Constraint::Values
    DistanceDriver::value(const double t, const PairVector &q) const
    {
      return (compute_marker_distance(q, s_1, s_2).value - motion.value(t)) *
             Values::UnitX();
    }



    Constraint::Jacobian
    DistanceDriver::jacobian(const PairVector &q) const
    {
      Jacobian result = Jacobian::Zero();
      result.row(0) = compute_marker_distance(q, s_1, s_2).gradient.transpose();
      return result;
    }



    PairMatrix
    DistanceDriver::weighted_hessian(const PairVector &q,
                                     const Values     &weights) const
    {
      return weights(0) * compute_marker_distance(q, s_1, s_2).hessian;
    }



    Constraint::Values
    DistanceDriver::time_derivative(const double t) const
    {
      return -motion.first_derivative(t) * Values::UnitX();
    }



    Constraint::Values
    DistanceDriver::second_time_derivative(const double t) const
    {
      return -motion.second_derivative(t) * Values::UnitX();
    }



    Eigen::Vector2d
    DistanceDriver::reaction_force(const PairVector &q,
                                   const Values     &multipliers) const
    {
      return -multipliers(0) * compute_marker_distance(q, s_1, s_2).direction;
    }
  } // namespace Multibody
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/elements/angle_driver.h>

namespace Tribody
{
  namespace Multibody
  {
    AngleDriver::AngleDriver(const std::string  &description,
                             const BodyPair     &bodies,
                             const DriverMotion &motion)
      : Constraint(description, bodies, 1)
      , motion(motion)
    {}



    Constraint::Values
    AngleDriver::value(const double t, const PairVector &q) const
    {
      return (q(2) - q(5) - motion.value(t)) * Values::UnitX();
    }



    Constraint::Jacobian
    AngleDriver::jacobian(const PairVector & /*q*/) const
    {
      Jacobian result = Jacobian::Zero();
      result(0, 2)    = 1.;
      result(0, 5)    = -1.;
      return result;
    }



    PairMatrix
    AngleDriver::weighted_hessian(const PairVector & /*q*/,
                                  const Values & /*weights*/) const
    {
      return PairMatrix::Zero();
    }



    Constraint::Values
    AngleDriver::time_derivative(const double t) const
    {
      return -motion.first_derivative(t) * Values::UnitX();
    }



    Constraint::Values
    AngleDriver::second_time_derivative(const double t) const
    {
      return -motion.second_derivative(t) * Values::UnitX();
    }



    Eigen::Vector2d
    AngleDriver::reaction_force(const PairVector & /*q*/,
                                const Values & /*multipliers*/) const
    {
      return Eigen::Vector2d::Zero();
    }
  } // namespace Multibody
} // namespace Tribody

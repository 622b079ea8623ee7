#include <tribody/multibody/angle_driver.h>

namespace Tribody
{
  namespace Multibody
  {
    AngleDriver::AngleDriver(const std::string &description,
                             const BodyPair    &bodies,
                             const double       initial_angle,
                             const double       speed)
      : Constraint(description, bodies, 1)
      , initial_angle(initial_angle)
      , speed(speed)
    {}



    Eigen::Vector2d
    AngleDriver::value(const double t, const PairVector &q) const
    {
      return {q(2) - q(5) - initial_angle - speed * t, 0.};
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
                                  const Eigen::Vector2d & /*weights*/) const
    {
      return PairMatrix::Zero();
    }



    Eigen::Vector2d
    AngleDriver::time_derivative(const double /*t*/) const
    {
      return {-speed, 0.};
    }



    Eigen::Vector2d
    AngleDriver::reaction_force(const PairVector & /*q*/,
                                const Eigen::Vector2d & /*multipliers*/) const
    {
      return Eigen::Vector2d::Zero();
    }
  } // namespace Multibody
} // namespace Tribody

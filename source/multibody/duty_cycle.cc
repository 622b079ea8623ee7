#include <deal.II/base/exceptions.h>

#include <tribody/multibody/duty_cycle.h>

#include <algorithm>

namespace Tribody
{
  namespace Multibody
  {
    Eigen::VectorXd
    JointDutyCycle::force() const
    {
      return (force_x.array().square() + force_y.array().square()).sqrt();
    }



    double
    JointDutyCycle::peak_force() const
    {
      return force().maxCoeff();
    }



    Eigen::Index
    JointDutyCycle::peak_sample() const
    {
      Eigen::Index sample = 0;
      force().maxCoeff(&sample);
      return sample;
    }



    double
    JointDutyCycle::mean_force() const
    {
      return force().mean();
    }



    double
    JointDutyCycle::mean_normal_force() const
    {
      const double distance = sliding_distance();
      return distance > 0 ? normal_force.dot(sliding_increment) / distance
                          : normal_force.mean();
    }



    double
    JointDutyCycle::sliding_distance() const
    {
      return sliding_increment.sum();
    }



    double
    JointDutyCycle::share_of(const ContactState wanted) const
    {
      return state_shares[static_cast<unsigned int>(wanted)];
    }



    const JointDutyCycle &
    DutyCycle::joint(const std::string &name) const
    {
      const auto found = std::find_if(joints.begin(),
                                      joints.end(),
                                      [&](const JointDutyCycle &joint) {
                                        return joint.name == name;
                                      });
      AssertThrow(found != joints.end(),
                  dealii::ExcMessage("There is no joint '" + name + "'."));
      return *found;
    }
  } // namespace Multibody
} // namespace Tribody

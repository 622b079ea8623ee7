#include <tribody/base/exceptions.h>
#include <tribody/multibody/friction_law.h>
#include <tribody/multibody/joint_parameters.h>

#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    FrictionRatio
    NoFriction::ratio(const double /*sliding_speed*/) const
    {
      return {};
    }



    FrictionRatio
    RegularisedCoulombFriction::ratio(const double sliding_speed) const
    {
      const double s = std::tanh(sliding_speed / regularisation_speed);
      return {coefficient * s,
              coefficient * (1 - s * s) / regularisation_speed};
    }



    std::vector<std::string>
    friction_law_names()
    {
      return {"none", "Coulomb regularised"};
    }



    FrictionLaw
    make_friction_law(const JointParameters &joint)
    {
      if (joint.friction_law == "none")
        return NoFriction{};
      if (joint.friction_law == "Coulomb regularised")
        return RegularisedCoulombFriction{joint.friction_coefficient,
                                          joint.friction_regularisation_speed};
      AssertThrow(false,
                  ExcParameter("Joint " + joint.name + "/Friction law",
                               "'" + joint.friction_law + "' is not known"));
      return NoFriction{};
    }



    FrictionRatio
    compute_friction_ratio(const FrictionLaw &law, const double sliding_speed)
    {
      return std::visit(
        [&](const auto &chosen) { return chosen.ratio(sliding_speed); }, law);
    }
  } // namespace Multibody
} // namespace Tribody

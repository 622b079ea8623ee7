#ifndef tribody_multibody_friction_law_h
#define tribody_multibody_friction_law_h

#include <string>
#include <variant>
#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    struct JointParameters;

    /// Friction force divided by normal force, with its derivative.
    struct FrictionRatio
    {
      /// F_mu/F_N [-], of the sign of the sliding speed.
      double value = 0.;
      /// Its derivative with respect to the sliding speed [s/m].
      double d_sliding_speed = 0.;
    };

    /// No friction.
    struct NoFriction
    {
      FrictionRatio
      ratio(const double sliding_speed) const;
    };

    /// Coulomb's law made smooth, @f$ F_\mu = \mu F_N \tanh(v_t/v_0) @f$.
    struct RegularisedCoulombFriction
    {
      /// mu [-].
      double coefficient;
      /// v_0 [m/s].
      double regularisation_speed;

      FrictionRatio
      ratio(const double sliding_speed) const;
    };

    /**
     * To add a law: a struct like those above, its name in
     * friction_law_names(), its making in make_friction_law().
     */
    using FrictionLaw = std::variant<NoFriction, RegularisedCoulombFriction>;

    /// What can be chosen as "Friction law".
    std::vector<std::string>
    friction_law_names();

    /// The law of a joint with clearance.
    FrictionLaw
    make_friction_law(const JointParameters &joint);

    /// Friction under @p law at the @p sliding_speed [m/s].
    FrictionRatio
    compute_friction_ratio(const FrictionLaw &law, const double sliding_speed);
  } // namespace Multibody
} // namespace Tribody

#endif

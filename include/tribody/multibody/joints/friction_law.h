// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_joints_friction_law_h
#define tribody_multibody_joints_friction_law_h

#include <tribody/base/law_choice.h>

#include <variant>

namespace Tribody
{
  namespace Multibody
  {
    struct JointParameters;

    /// Friction force divided by normal force, with its derivatives.
    struct FrictionRatio
    {
      /// F_mu/F_N [-], of the sign of the sliding speed.
      double value = 0.;
      /// Its derivative with respect to the sliding speed [s/m].
      double d_sliding_speed = 0.;
      /// Its derivative with respect to the law's state [1/m].
      double d_state = 0.;
    };

    /// Rate of the state of a law that has one, with its derivatives.
    struct FrictionStateRate
    {
      /// z' [m/s].
      double value = 0.;
      /// With respect to the sliding speed [-].
      double d_sliding_speed = 0.;
      /// With respect to the state [1/s].
      double d_state = 0.;
    };

    /// No friction.
    struct NoFriction
    {
      /// The word for it in parameter files.
      static constexpr const char *name = "none";

      /// Of any @p joint: there are no values.
      static NoFriction
      make(const JointParameters &joint);

      /// Zero at any speed.
      FrictionRatio
      ratio(const double sliding_speed) const;

      /// Sliding speed [m/s] over which friction takes its sign: infinite.
      double
      transition_speed() const;

      /// Whether a joint that slides at @p sliding_speed under this @p ratio of
      /// friction to normal force is held, where Coulomb's friction would
      /// stick: never.
      bool
      holds(const double sliding_speed, const double ratio) const;
    };

    /// Coulomb's law made smooth, @f$ F_\mu = \mu F_N \tanh(v_t/v_0) @f$.
    struct RegularisedCoulombFriction
    {
      /// The word for it in parameter files.
      static constexpr const char *name = "Coulomb regularised";

      /// mu [-].
      double coefficient;
      /// v_0 [m/s].
      double regularisation_speed;

      /// With mu and v_0 of @p joint.
      static RegularisedCoulombFriction
      make(const JointParameters &joint);

      /// mu tanh(v_t/v_0) at the @p sliding_speed v_t [m/s], with its
      /// derivative.
      FrictionRatio
      ratio(const double sliding_speed) const;

      /// v_0 [m/s]; infinite if mu is zero.
      double
      transition_speed() const;

      /// Whether a joint that slides at @p sliding_speed under this @p ratio of
      /// friction to normal force is held, where Coulomb's friction would
      /// stick: below 3 v_0, where friction lacks 0.5 %.
      bool
      holds(const double sliding_speed, const double ratio) const;
    };

    /**
     * Coulomb's law as Ambrosio changed it for numerical integration,
     * @f[ F_\mu = \mu\,c_d F_N\,\mathrm{sgn}\,v_t, \qquad
     *     c_d = \min\left(1, \max\left(0, \frac{|v_t| - v_0}{v_1 - v_0}
     *     \right)\right): @f]
     * none below @f$v_0@f$, all of it above @f$v_1@f$. @cite ambrosio2003.
     */
    struct AmbrosioFriction
    {
      /// The word for it in parameter files.
      static constexpr const char *name = "Ambrosio";

      /// mu [-].
      double coefficient;
      /// v_0 [m/s].
      double lower_speed;
      /// v_1 [m/s], larger than v_0.
      double upper_speed;

      /// With mu, v_0 and v_1 of @p joint.
      static AmbrosioFriction
      make(const JointParameters &joint);

      /// mu c_d sgn(v_t) at the @p sliding_speed v_t [m/s], with its
      /// derivative, which jumps at v_0 and v_1.
      FrictionRatio
      ratio(const double sliding_speed) const;

      /// v_1 - v_0 [m/s]; infinite if mu is zero.
      double
      transition_speed() const;

      /// Whether a joint that slides at @p sliding_speed under this @p ratio of
      /// friction to normal force is held, where Coulomb's friction would
      /// stick: below v_1.
      bool
      holds(const double sliding_speed, const double ratio) const;
    };

    /**
     * How friction falls from its static to its kinetic value as the speed
     * grows, @f$ g(v) = \mu_k + (\mu_s - \mu_k) \exp(-(v/v_s)^2) @f$.
     */
    struct StribeckCurve
    {
      /// mu_k [-].
      double kinetic_coefficient;
      /// mu_s [-].
      double static_coefficient;
      /// v_s [m/s].
      double stribeck_speed;

      /// g [-] at the @p speed v [m/s], of either sign.
      double
      value(const double speed) const;

      /// dg/dv [s/m].
      double
      derivative(const double speed) const;
    };

    /**
     * Friction with Stribeck's effect and a viscous part,
     * @f$ F_\mu = F_N\,[g(v_t) \tanh(v_t/v_0) + \sigma_2 v_t] @f$, made
     * smooth as in RegularisedCoulombFriction. @cite olsson1998.
     */
    struct StribeckFriction
    {
      /// The word for it in parameter files.
      static constexpr const char *name = "Stribeck";

      /// g.
      StribeckCurve curve;
      /// v_0 [m/s].
      double regularisation_speed;
      /// sigma_2 [s/m].
      double viscous_coefficient;

      /// With g, v_0 and sigma_2 of @p joint.
      static StribeckFriction
      make(const JointParameters &joint);

      /// F_mu/F_N at the @p sliding_speed v_t [m/s], with its derivative.
      FrictionRatio
      ratio(const double sliding_speed) const;

      /// v_0 [m/s]; infinite if mu_s is zero.
      double
      transition_speed() const;

      /// Whether a joint that slides at @p sliding_speed under this @p ratio of
      /// friction to normal force is held, where Coulomb's friction would
      /// stick: below 3 v_0, where friction lacks 0.5 %.
      bool
      holds(const double sliding_speed, const double ratio) const;
    };

    /**
     * The LuGre law. Bristles of the surfaces bend by z before they slip,
     * @f[ \dot z = v_t - \frac{\sigma_0 |v_t|}{g(v_t)} z, \qquad
     *     F_\mu = F_N\,[\sigma_0 z + \sigma_1 \dot z + \sigma_2 v_t], @f]
     * so that friction sticks, with the stiffness @f$\sigma_0 F_N@f$, and
     * slides with @f$ F_\mu = F_N\,[g\,\mathrm{sgn}\,v_t + \sigma_2 v_t] @f$.
     * The coefficients are those of a unit normal force. @cite canudas1995.
     */
    struct LuGreFriction
    {
      /// The word for it in parameter files.
      static constexpr const char *name = "LuGre";

      /// g.
      StribeckCurve curve;
      /// sigma_0 [1/m].
      double bristle_stiffness;
      /// sigma_1 [s/m].
      double bristle_damping;
      /// sigma_2 [s/m].
      double viscous_coefficient;

      /// With g, sigma_0, sigma_1 and sigma_2 of @p joint.
      static LuGreFriction
      make(const JointParameters &joint);

      /// F_mu/F_N at the @p sliding_speed v_t [m/s] and the @p state z [m],
      /// with its derivatives.
      FrictionRatio
      ratio(const double sliding_speed, const double state) const;

      /// z' at the same.
      FrictionStateRate
      state_rate(const double sliding_speed, const double state) const;

      /// z [m] that stays as it is at this sliding speed.
      double
      steady_state(const double sliding_speed) const;

      /// mu_s/(sigma_1 + sigma_2) [m/s]: friction follows the displacement, the
      /// speed acts through the damping.
      double
      transition_speed() const;

      /// Whether a joint that slides at @p sliding_speed under this @p ratio of
      /// friction to normal force is held, where Coulomb's friction would
      /// stick: where friction is not yet that of slipping.
      bool
      holds(const double sliding_speed, const double ratio) const;
    };

    /**
     * To add a law: a struct like those above, and a place in this list.
     */
    using FrictionLaw = std::variant<NoFriction,
                                     RegularisedCoulombFriction,
                                     AmbrosioFriction,
                                     StribeckFriction,
                                     LuGreFriction>;

    /// What can be chosen as "Friction law".
    using FrictionLawChoice = LawChoice<FrictionLaw>;

    /// Whether @p law remembers: has a state z.
    bool
    has_state(const FrictionLaw &law);

    /// Friction under @p law at the @p sliding_speed [m/s]; the @p state [m] is
    /// of laws that have one.
    FrictionRatio
    compute_friction_ratio(const FrictionLaw &law,
                           const double       sliding_speed,
                           const double       state = 0.);

    /// z' under @p law; zero for a law without a state.
    FrictionStateRate
    compute_friction_state_rate(const FrictionLaw &law,
                                const double       sliding_speed,
                                const double       state);

    /// The state [m] that lasts at a constant @p sliding_speed; zero for a law
    /// without one.
    double
    compute_steady_friction_state(const FrictionLaw &law,
                                  const double       sliding_speed);

    /// Sliding speed [m/s] over which friction takes its sign.
    double
    compute_transition_speed(const FrictionLaw &law);

    /// Whether friction under @p law holds a joint that creeps at @p
    /// sliding_speed [m/s] under the @p ratio of friction to normal force.
    bool
    friction_holds(const FrictionLaw &law,
                   const double       sliding_speed,
                   const double       ratio);
  } // namespace Multibody
} // namespace Tribody

#endif

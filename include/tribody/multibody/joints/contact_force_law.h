// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_joints_contact_force_law_h
#define tribody_multibody_joints_contact_force_law_h

#include <tribody/base/choice.h>
#include <tribody/base/law_choice.h>

#include <optional>
#include <variant>

namespace Tribody
{
  struct Material;

  namespace Multibody
  {
    struct JointParameters;

    /// What a law is asked: the state of one contact.
    struct ContactKinematics
    {
      /// Penetration, positive in contact [m].
      double penetration;
      /// Its rate [m/s].
      double penetration_rate;
      /// Its rate when this contact began, positive [m/s].
      double approach_speed;
      /// Normal force [N] with which the elastic surfaces hold the pin at rest
      /// here; only known, and needed, for FiniteElementLaw.
      double elastic_force = 0.;
    };

    /// A normal force with its partial derivatives.
    struct NormalForce
    {
      /// F_N [N], not negative.
      double value = 0.;
      /// dF_N/d(penetration) [N/m].
      double d_penetration = 0.;
      /// dF_N/d(penetration rate) [N s/m].
      double d_penetration_rate = 0.;
      /// dF_N/d(elastic force) [-].
      double d_elastic_force = 0.;
    };

    /// Hertz' law without losses, @f$ F_N = K \delta^{3/2} @f$.
    struct HertzLaw
    {
      /// The word for it in parameter files.
      static constexpr const char *name = "Hertz";

      /// K [N/m^1.5].
      double stiffness;

      /// With K of compute_hertz_stiffness() for the radii and materials of @p
      /// joint.
      static HertzLaw
      make(const JointParameters &joint);

      /// F_N and its derivatives; zero without penetration.
      NormalForce
      normal_force(const ContactKinematics &contact) const;
    };

    /**
     * Hertz' law with hysteresis,
     * @f[ F_N = K \delta^{3/2} \left[1 + \frac{3(1-e_r^2)}{4}
     *     \frac{\dot\delta}{\dot\delta^-}\right] \ge 0, @f]
     * with the approach speed @f$\dot\delta^-@f$ at which this contact began.
     * Eqs. (9) and (10) of @cite mukras2010 after @cite lankarani1990.
     */
    struct LankaraniNikraveshLaw
    {
      /// The word for it in parameter files.
      static constexpr const char *name = "Lankarani-Nikravesh";

      /// K [N/m^1.5].
      double stiffness;
      /// e_r [-].
      double restitution_coefficient;

      /// With K of compute_hertz_stiffness() and e_r of @p joint.
      static LankaraniNikraveshLaw
      make(const JointParameters &joint);

      /// F_N and its derivatives; zero without penetration, and where the
      /// factor in brackets is negative.
      NormalForce
      normal_force(const ContactKinematics &contact) const;
    };

    /**
     * Hertz' law with the damping of Hunt and Crossley,
     * @f[ F_N = K \delta^{3/2} \left[1 + \frac{3(1-e_r)}{2}
     *     \frac{\dot\delta}{\dot\delta^-}\right] \ge 0, @f]
     * which takes the restitution coefficient linearly; meant for values near
     * one. @cite hunt1975.
     */
    struct HuntCrossleyLaw
    {
      /// The word for it in parameter files.
      static constexpr const char *name = "Hunt-Crossley";

      /// K [N/m^1.5].
      double stiffness;
      /// e_r [-].
      double restitution_coefficient;

      /// With K of compute_hertz_stiffness() and e_r of @p joint.
      static HuntCrossleyLaw
      make(const JointParameters &joint);

      /// F_N and its derivatives; zero without penetration, and where the
      /// factor in brackets is negative.
      NormalForce
      normal_force(const ContactKinematics &contact) const;
    };

    /**
     * Hertz' law with the damping of Flores, Machado, Silva and Martins,
     * @f[ F_N = K \delta^{3/2} \left[1 + \frac{8(1-e_r)}{5 e_r}
     *     \frac{\dot\delta}{\dot\delta^-}\right] \ge 0, @f]
     * made for the whole range of restitution: as e_r falls to zero, the losses
     * grow without bound. @cite flores2011.
     */
    struct FloresLaw
    {
      /// The word for it in parameter files.
      static constexpr const char *name = "Flores";

      /// K [N/m^1.5].
      double stiffness;
      /// e_r [-].
      double restitution_coefficient;

      /// With K of compute_hertz_stiffness() and e_r of @p joint, which must be
      /// positive.
      static FloresLaw
      make(const JointParameters &joint);

      /// F_N and its derivatives; zero without penetration, and where the
      /// factor in brackets is negative.
      NormalForce
      normal_force(const ContactKinematics &contact) const;
    };

    /**
     * The impact pair of Dubowsky and Freudenstein, a linear spring with a
     * linear damper that cannot pull,
     * @f[ F_N = k\,\delta + b\,\dot\delta \ge 0. @f]
     * A mass m that runs into it leaves with @f$ e = \exp(-2 \zeta
     * \arccos\zeta/\sqrt{1-\zeta^2}) @f$, @f$ \zeta = b/(2\sqrt{k m}) @f$,
     * whatever its speed. The force jumps by @f$ b\,\dot\delta @f$ when a
     * contact begins. @cite dubowsky1971.
     */
    struct SpringDamperLaw
    {
      /// The word for it in parameter files.
      static constexpr const char *name = "spring-damper";

      /// k [N/m].
      double stiffness;
      /// b [N s/m].
      double damping;

      /// With k and b of @p joint.
      static SpringDamperLaw
      make(const JointParameters &joint);

      /// F_N and its derivatives; zero without penetration, and where the
      /// damper would pull harder than the spring presses.
      NormalForce
      normal_force(const ContactKinematics &contact) const;
    };

    /**
     * A rigid pin in a bore that is lined with an elastic foundation (Winkler):
     * springs side by side that do not know each other. At the angle t from
     * the direction of contact the pin indents it by @f$ u = (c+\delta) \cos t
     * - c @f$ (linearised in c/R), where that is positive, and
     * @f$ p = \frac{M}{h} u @f$. The resultant over the arc of half-angle
     * @f$ t_0 = \arccos\frac{c}{c+\delta} @f$ is, exactly,
     * @f[ F_N = \frac{M}{h} L R \left[(c+\delta)\,t_0 - c \sin t_0\right],
     *     \qquad \frac{dF_N}{d\delta} = \frac{M}{h} L R
     *     \left[t_0 + \sin t_0 \cos t_0\right], @f]
     * both times the hysteresis factor of LankaraniNikraveshLaw. The clearance
     * c is that of the bore as manufactured: how closely a worn bore fits the
     * pin is not told by c(theta). See @cite johnson1985, section 4.3.
     */
    struct ElasticFoundationLaw
    {
      /// The word for it in parameter files.
      static constexpr const char *name = "elastic foundation";

      /// c = R_j - R_i [m].
      double clearance;
      /// R = R_j [m].
      double bore_radius;
      /// L, along the axis [m].
      double length;
      /// M/h [Pa/m]: pressure per indentation.
      double foundation_modulus;
      /// e_r [-]; 1: no losses.
      double restitution_coefficient;

      /// With L, h and e_r of @p joint, and M of it or, if that is zero,
      /// compute_layer_modulus() of the bushing's material.
      static ElasticFoundationLaw
      make(const JointParameters &joint);

      /// F_N and its derivatives; zero without penetration, and where the
      /// hysteresis factor is negative.
      NormalForce
      normal_force(const ContactKinematics &contact) const;

      /// Half-angle t_0 of the arc in contact [rad].
      double
      half_angle(const double penetration) const;

      /// p [Pa] at the @p angle t from the direction of contact [rad].
      double
      pressure(const double angle, const ContactKinematics &contact) const;
    };

    /**
     * The force of the elastic surfaces themselves, which PinSupport computes,
     * times the hysteresis factor of LankaraniNikraveshLaw. That it depends on
     * the position of the pin is not part of the law.
     */
    struct FiniteElementLaw
    {
      /// The word for it in parameter files.
      static constexpr const char *name = "finite element";

      /// e_r [-]; 1: no losses.
      double restitution_coefficient;

      /// With e_r of @p joint.
      static FiniteElementLaw
      make(const JointParameters &joint);

      /// F_N and its derivatives, those by the rate and by
      /// ContactKinematics::elastic_force; zero without penetration, and where
      /// the hysteresis factor is negative.
      NormalForce
      normal_force(const ContactKinematics &contact) const;
    };

    /**
     * To add a law: a struct like those above, and a place in this list.
     */
    using ContactForceLaw = std::variant<HertzLaw,
                                         LankaraniNikraveshLaw,
                                         HuntCrossleyLaw,
                                         FloresLaw,
                                         SpringDamperLaw,
                                         ElasticFoundationLaw,
                                         FiniteElementLaw>;

    /// What can be chosen as "Contact force law".
    using ContactForceLawChoice = LawChoice<ContactForceLaw>;

    /// Whether the force comes from a PinSupport.
    inline bool
    needs_support(const ContactForceLaw &law)
    {
      return std::holds_alternative<FiniteElementLaw>(law);
    }

    /// Normal force under @p law.
    NormalForce
    compute_normal_force(const ContactForceLaw   &law,
                         const ContactKinematics &contact);

    /**
     * Penetration [m] at which the force is @p normal_force [N], at the given
     * rate and approach speed: the inverse of compute_normal_force(). Not for
     * laws that need a PinSupport.
     */
    double
    compute_penetration(const ContactForceLaw &law,
                        const double           normal_force,
                        const double           penetration_rate,
                        const double           approach_speed);

    /**
     * M [Pa] of a thin layer bonded to a rigid wall, which cannot expand
     * sideways: @f$ M = \frac{(1-\nu) E}{(1+\nu)(1-2\nu)} @f$.
     */
    double
    compute_layer_modulus(const Material &material);

    /// How the radii of pin and bore make the one of compute_hertz_stiffness().
    enum class RadiiCombination
    {
      /// R_i + R_j: the surfaces bend away from each other.
      sum,
      /// R_j - R_i: the bore bends around the pin.
      difference
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<RadiiCombination>
    choice_names(const RadiiCombination)
    {
      return {{RadiiCombination::sum, "sum"},
              {RadiiCombination::difference, "difference"}};
    }

    /**
     * Stiffness K [N/m^1.5] of two spheres of radii R_i and R_j,
     * @f$ K = \frac{4}{3(h_i+h_j)} \sqrt{\frac{R_i R_j}{R}} @f$,
     * @f$ h = (1-\nu^2)/E @f$. With the sum of the radii, R = R_i + R_j, as
     * eq. (10) of @cite mukras2010 is printed, they touch from outside; with
     * the difference, R = R_j - R_i, the first lies in the hollow of the
     * second, as @cite lankarani1990 and @cite flores2011 have it.
     */
    double
    compute_hertz_stiffness(const double           pin_radius,
                            const double           bushing_radius,
                            const Material        &pin,
                            const Material        &bushing,
                            const RadiiCombination radii);

    /// K [N/m^1.5] of a law in delta^1.5, or nothing.
    std::optional<double>
    find_hertz_stiffness(const ContactForceLaw &law);
  } // namespace Multibody
} // namespace Tribody

#endif

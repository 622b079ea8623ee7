#ifndef tribody_multibody_contact_force_law_h
#define tribody_multibody_contact_force_law_h

#include <string>
#include <variant>
#include <vector>

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
    };

    /// Hertz' law without losses, @f$ F_N = K \delta^{3/2} @f$.
    struct HertzLaw
    {
      /// K [N/m^1.5].
      double stiffness;

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
      /// K [N/m^1.5].
      double stiffness;
      /// e_r [-].
      double restitution_coefficient;

      NormalForce
      normal_force(const ContactKinematics &contact) const;
    };

    /**
     * To add a law: a struct like those above, its name in
     * contact_force_law_names(), its making in make_contact_force_law().
     */
    using ContactForceLaw = std::variant<HertzLaw, LankaraniNikraveshLaw>;

    /// What can be chosen as "Contact force law".
    std::vector<std::string>
    contact_force_law_names();

    /// The law of a joint with clearance.
    ContactForceLaw
    make_contact_force_law(const JointParameters &joint);

    /// Normal force under @p law.
    NormalForce
    compute_normal_force(const ContactForceLaw   &law,
                         const ContactKinematics &contact);

    /**
     * Penetration [m] at which the force is @p normal_force [N], at the given
     * rate and approach speed: the inverse of compute_normal_force().
     */
    double
    compute_penetration(const ContactForceLaw &law,
                        const double           normal_force,
                        const double           penetration_rate,
                        const double           approach_speed);

    /**
     * Stiffness K [N/m^1.5] of two spheres of radii R_i and R_j, the convex one
     * in the hollow: @f$ K = \frac{4}{3(h_i+h_j)}
     * \sqrt{\frac{R_i R_j}{R_i+R_j}} @f$, @f$ h = (1-\nu^2)/E @f$; eq. (10) of
     * @cite mukras2010, with the sum of the radii as printed there.
     */
    double
    compute_hertz_stiffness(const double    pin_radius,
                            const double    bushing_radius,
                            const Material &pin,
                            const Material &bushing);
  } // namespace Multibody
} // namespace Tribody

#endif

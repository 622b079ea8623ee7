#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/multibody/contact_force_law.h>
#include <tribody/multibody/friction_law.h>
#include <tribody/multibody/joint_parameters.h>
#include <tribody/multibody/significant_digits.h>

#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // One function per group of entries, in the order of the manual.
      void
      add_markers_and_radii(dealii::ParameterHandler &prm, JointParameters &p)
      {
        Parameters::add_text(prm,
                             "Pin marker",
                             p.pin_marker,
                             "Revolute joint: centre of the pin, "
                             "'<body>.<marker>'.");
        Parameters::add_text(prm,
                             "Bushing marker",
                             p.bushing_marker,
                             "Revolute joint: centre of the bushing, "
                             "'<body>.<marker>'. Angles of contact and wear "
                             "are counted in this body's frame.");
        Parameters::add_choice(
          prm,
          "Model",
          p.model,
          {"ideal", "clearance", "massless link", "impact"},
          "Revolute joint: 'ideal' keeps the two centres together; with "
          "'clearance' the pin moves freely in the bushing until it touches "
          "it, and contact and friction forces act then. The others are rigid "
          "and for comparison; they cannot wear a bushing. 'massless link' "
          "keeps the centres at the distance of the clearance, without "
          "friction, and the reaction is the force along that link. 'impact': "
          "the pin flies freely; where it hits the bore, the velocities jump "
          "by momentum balance with the restitution coefficient (and the "
          "friction coefficient unless the friction law is 'none'); when it "
          "hits more slowly than the capture speed, it follows the bore, "
          "without friction, until the force would pull.");
        Parameters::add_quantity(
          prm, "Pin radius", p.pin_radius, "m", "Radius R_i of the pin.", "mm");
        Parameters::add_quantity(prm,
                                 "Bushing radius",
                                 p.bushing_radius,
                                 "m",
                                 "Radius R_j of the bore. The clearance is "
                                 "R_j - R_i.",
                                 "mm");
        Parameters::add_text(prm,
                             "Pin material",
                             p.pin_material_name,
                             "Name of the pin's material.");
        Parameters::add_text(prm,
                             "Bushing material",
                             p.bushing_material_name,
                             "Name of the bushing's material.");
      }



      void
      add_contact(dealii::ParameterHandler &prm, JointParameters &p)
      {
        Parameters::add_choice(
          prm,
          "Contact force law",
          p.contact_force_law,
          contact_force_law_names(),
          "Normal force in contact; delta is the penetration, delta'_minus the "
          "approach speed at which the contact began. 'Hertz': F_N = K "
          "delta^1.5. 'Lankarani-Nikravesh', 'Hunt-Crossley' and 'Flores': the "
          "same times 1 + d delta'/delta'_minus, which takes energy out of an "
          "impact, with d = 3/4 (1 - e_r^2), d = 3/2 (1 - e_r) and d = 8/5 (1 "
          "- e_r)/e_r; the last one is made for any e_r, the others for e_r "
          "near 1. 'spring-damper': F_N = k delta + b delta' >= 0. 'elastic "
          "foundation': the bore is lined with springs (Winkler), p = M/h "
          "times the indentation, integrated over the arc of contact; its "
          "losses are those of Lankarani and Nikravesh.");
        Parameters::add_quantity(
          prm,
          "Restitution coefficient",
          p.restitution_coefficient,
          "",
          "e_r of all laws with losses but 'spring-damper', between 0 and 1 "
          "(no loss), and of the model 'impact', which takes it as it is. "
          "Otherwise it is the laws' parameter: for values below 0.9 a free "
          "impact leaves noticeably faster than e_r says; under 'Flores' it "
          "leaves at e_r within 0.05.");
        Parameters::add_quantity(prm,
                                 "Contact stiffness",
                                 p.contact_stiffness,
                                 "N/m",
                                 "k of 'spring-damper', which requires it.");
        Parameters::add_quantity(
          prm,
          "Contact damping",
          p.contact_damping,
          "N s/m",
          "b of 'spring-damper'. A mass m leaves an impact with exp(-2 zeta "
          "acos(zeta)/sqrt(1 - zeta^2)) of its speed, zeta = b/(2 sqrt(k m)).");
        Parameters::add_quantity(
          prm,
          "Foundation length",
          p.foundation_length,
          "m",
          "L of 'elastic foundation': the joint's length along its axis.",
          "mm");
        Parameters::add_quantity(
          prm,
          "Foundation thickness",
          p.foundation_thickness,
          "m",
          "h of 'elastic foundation': thickness of the layer.",
          "mm");
        Parameters::add_quantity(
          prm,
          "Foundation modulus",
          p.foundation_modulus,
          "Pa",
          "M of 'elastic foundation'. 0 takes that of a thin layer of the "
          "bushing's material which is bonded to its back, (1 - nu) E/((1 + "
          "nu) (1 - 2 nu)).",
          "GPa");
        Parameters::add_quantity(
          prm,
          "Capture speed",
          p.capture_speed,
          "m/s",
          "Model 'impact': approach speed below which the pin does not bounce "
          "any more but follows the bore. Without it the impacts, each weaker "
          "than the one before, would have no end.",
          "mm/s");
        Parameters::add_quantity(
          prm,
          "Minimum approach speed",
          p.minimum_approach_speed,
          "m/s",
          "Floor of delta'_minus. It is also its value for a motion that "
          "starts in contact. Without a floor a contact that begins gently "
          "would be damped without bound.",
          "mm/s");
      }



      void
      add_friction(dealii::ParameterHandler &prm, JointParameters &p)
      {
        Parameters::add_choice(
          prm,
          "Friction law",
          p.friction_law,
          friction_law_names(),
          "Friction F_mu against the sliding v_t of the two surfaces at the "
          "contact. 'Coulomb regularised': mu F_N tanh(v_t/v_0). 'Ambrosio': "
          "none below the lower speed, mu F_N above the upper one, linear in "
          "between. 'Stribeck': g tanh(v_t/v_0) + sigma_2 v_t, times F_N, with "
          "g = mu + (mu_s - mu) exp(-(v_t/v_s)^2). 'LuGre': sigma_0 z + "
          "sigma_1 z' + sigma_2 v_t, times F_N, with bristles that bend by z "
          "and slip, z' = v_t - sigma_0 |v_t|/g z; a new contact begins with "
          "z = 0.");
        Parameters::add_quantity(
          prm, "Friction coefficient", p.friction_coefficient, "", "mu.");
        Parameters::add_quantity(prm,
                                 "Friction regularisation speed",
                                 p.friction_regularisation_speed,
                                 "m/s",
                                 "v_0: below this sliding speed friction "
                                 "falls to zero smoothly.",
                                 "mm/s");
        Parameters::add_quantity(
          prm,
          "Tangential damping",
          p.tangential_damping,
          "N s/m",
          "Damping of the pin's sideways swing in the bore while it is in "
          "contact. The contact laws damp the normal direction only.");
      }



      void
      add_further_friction(dealii::ParameterHandler &prm, JointParameters &p)
      {
        Parameters::add_quantity(prm,
                                 "Friction lower speed",
                                 p.friction_lower_speed,
                                 "m/s",
                                 "'Ambrosio': no friction below it.",
                                 "mm/s");
        Parameters::add_quantity(prm,
                                 "Friction upper speed",
                                 p.friction_upper_speed,
                                 "m/s",
                                 "'Ambrosio': full friction above it.",
                                 "mm/s");
        Parameters::add_quantity(
          prm,
          "Static friction coefficient",
          p.static_friction_coefficient,
          "",
          "mu_s of 'Stribeck' and 'LuGre', at least the friction coefficient.");
        Parameters::add_quantity(prm,
                                 "Stribeck speed",
                                 p.stribeck_speed,
                                 "m/s",
                                 "v_s of 'Stribeck' and 'LuGre'.",
                                 "mm/s");
        Parameters::add_quantity(prm,
                                 "Viscous friction",
                                 p.viscous_friction,
                                 "s/m",
                                 "sigma_2 of 'Stribeck' and 'LuGre', per "
                                 "normal force.");
        Parameters::add_quantity(
          prm,
          "Bristle stiffness",
          p.bristle_stiffness,
          "m^-1",
          "sigma_0 of 'LuGre', per normal force: friction builds up over a "
          "displacement of about mu/sigma_0.");
        Parameters::add_quantity(prm,
                                 "Bristle damping",
                                 p.bristle_damping,
                                 "s/m",
                                 "sigma_1 of 'LuGre', per normal force.");
      }



      void
      add_other_types(dealii::ParameterHandler &prm, JointParameters &p)
      {
        Parameters::add_text(prm,
                             "First marker",
                             p.first_marker,
                             "Other joints than revolute: '<body>.<marker>'; a "
                             "point of the axis, if there is one.");
        Parameters::add_text(prm,
                             "Second marker",
                             p.second_marker,
                             "Other joints than revolute: the point that stays "
                             "on the axis of the first body, or of a rigid "
                             "joint where the first marker is, "
                             "'<body>.<marker>'.");
        Parameters::add_quantity(prm,
                                 "Axis",
                                 p.axis_angle,
                                 "rad",
                                 "Translational joint and point on line: "
                                 "direction of the axis in the first body's "
                                 "frame.",
                                 "deg");
        Parameters::add_quantity(prm,
                                 "Relative angle",
                                 p.relative_angle,
                                 "rad",
                                 "Translational and rigid joint: angle of the "
                                 "second body relative to the first, which "
                                 "stays the same.",
                                 "deg");
      }



      void
      check_positive(const std::string &path,
                     const double       value,
                     const std::string &unit,
                     const std::string &shown_unit = "")
      {
        AssertThrow(value > 0,
                    ExcParameter(path,
                                 "must be positive, not " +
                                   Units::to_string(value,
                                                    unit,
                                                    shown_unit.empty()
                                                      ? unit
                                                      : shown_unit)));
      }



      void
      check_not_negative(const std::string &path,
                         const double       value,
                         const std::string &unit)
      {
        AssertThrow(value >= 0,
                    ExcParameter(path,
                                 "must be zero or positive, not " +
                                   Units::to_string(value, unit, unit)));
      }



      // Entries of the chosen law only: the others are not used.
      void
      check_contact_law(const std::string &path, const JointParameters &p)
      {
        if (p.contact_force_law == "spring-damper")
          {
            constexpr double penetration = 1e-6;
            const double     slope       = 1.5 * std::sqrt(penetration) *
                                 compute_hertz_stiffness(p.pin_radius,
                                                         p.bushing_radius,
                                                         p.pin_material,
                                                         p.bushing_material);
            AssertThrow(
              p.contact_stiffness > 0,
              ExcParameter(
                path + "/Contact stiffness",
                "must be positive for the law 'spring-damper', "
                "not " +
                  Units::to_string(p.contact_stiffness, "N/m", "N/m") +
                  "; for comparison, Hertz' law has the slope " +
                  significant_digits(slope) +
                  " N/m at a penetration of 1 um here"));
            check_not_negative(path + "/Contact damping",
                               p.contact_damping,
                               "N s/m");
          }
        if (p.contact_force_law == "elastic foundation")
          {
            check_positive(path + "/Foundation length",
                           p.foundation_length,
                           "m");
            check_positive(path + "/Foundation thickness",
                           p.foundation_thickness,
                           "m");
            check_not_negative(path + "/Foundation modulus",
                               p.foundation_modulus,
                               "Pa");
          }
      }



      void
      check_friction_law(const std::string &path, const JointParameters &p)
      {
        check_not_negative(path + "/Friction coefficient",
                           p.friction_coefficient,
                           "");
        check_positive(path + "/Friction regularisation speed",
                       p.friction_regularisation_speed,
                       "m/s");
        if (p.friction_law == "Ambrosio")
          {
            check_not_negative(path + "/Friction lower speed",
                               p.friction_lower_speed,
                               "m/s");
            AssertThrow(
              p.friction_upper_speed > p.friction_lower_speed,
              ExcParameter(
                path + "/Friction upper speed",
                "must be above the lower speed of " +
                  Units::to_string(p.friction_lower_speed, "m/s", "mm/s") +
                  ", not " +
                  Units::to_string(p.friction_upper_speed, "m/s", "mm/s")));
          }
        if (p.friction_law == "Stribeck" || p.friction_law == "LuGre")
          {
            AssertThrow(
              p.static_friction_coefficient >= p.friction_coefficient,
              ExcParameter(
                path + "/Static friction coefficient",
                "must be at least the friction coefficient of " +
                  Units::to_string(p.friction_coefficient, "", "") + ", not " +
                  Units::to_string(p.static_friction_coefficient, "", "")));
            check_positive(path + "/Stribeck speed", p.stribeck_speed, "m/s");
            check_not_negative(path + "/Viscous friction",
                               p.viscous_friction,
                               "s/m");
          }
        if (p.friction_law == "LuGre")
          {
            // The bristles slip when they are bent by g/sigma_0.
            check_positive(path + "/Friction coefficient",
                           p.friction_coefficient,
                           "");
            check_positive(path + "/Bristle stiffness",
                           p.bristle_stiffness,
                           "m^-1");
            check_not_negative(path + "/Bristle damping",
                               p.bristle_damping,
                               "s/m");
          }
      }



      void
      check_restitution(const std::string &path, const JointParameters &p)
      {
        AssertThrow(
          p.restitution_coefficient > 0 && p.restitution_coefficient <= 1,
          ExcParameter(path + "/Restitution coefficient",
                       "must be above 0 and at most 1, not " +
                         Units::to_string(p.restitution_coefficient, "", "")));
      }



      void
      check_radii(const std::string &path, const JointParameters &p)
      {
        check_positive(path + "/Pin radius", p.pin_radius, "m", "mm");
        AssertThrow(
          p.bushing_radius >= p.pin_radius,
          ExcParameter(path + "/Pin radius",
                       "must be at most the bushing's radius of " +
                         Units::to_string(p.bushing_radius, "m", "mm") +
                         ", not " + Units::to_string(p.pin_radius, "m", "mm")));
        AssertThrow(p.has_clearance() || p.bushing_radius > p.pin_radius,
                    ExcParameter(path + "/Model",
                                 "'" + p.model +
                                   "' needs a clearance: the bushing's radius "
                                   "must be larger than the pin's, " +
                                   Units::to_string(p.pin_radius, "m", "mm")));
      }



      void
      check_clearance_joint(const std::string &path, const JointParameters &p)
      {
        check_restitution(path, p);
        check_positive(path + "/Minimum approach speed",
                       p.minimum_approach_speed,
                       "m/s");
        check_not_negative(path + "/Tangential damping",
                           p.tangential_damping,
                           "N s/m");
        p.pin_material.check();
        p.bushing_material.check();
        check_contact_law(path, p);
        check_friction_law(path, p);
      }



      void
      check_impact_joint(const std::string &path, const JointParameters &p)
      {
        check_restitution(path, p);
        check_positive(path + "/Capture speed", p.capture_speed, "m/s", "mm/s");
        check_not_negative(path + "/Friction coefficient",
                           p.friction_coefficient,
                           "");
      }
    } // namespace



    void
    JointParameters::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_choice(
        prm,
        "Type",
        type,
        {"revolute", "translational", "rigid", "point on line"},
        "'revolute': a pin turns in a bushing. "
        "'translational': a body slides along an axis of "
        "another one without turning. 'rigid': two bodies "
        "are welded together. 'point on line': a point of "
        "a body slides along an axis of another one, and "
        "both may turn. Entries that belong to other "
        "types are ignored.");
      add_markers_and_radii(prm, *this);
      add_contact(prm, *this);
      add_friction(prm, *this);
      add_further_friction(prm, *this);
      add_other_types(prm, *this);
    }



    void
    JointParameters::check() const
    {
      // Radii and laws of an ideal joint are not used: nothing to check.
      const std::string path = "Joint " + name;
      if (has_gap())
        check_radii(path, *this);
      if (has_clearance())
        check_clearance_joint(path, *this);
      else if (has_gap() && model != "massless link")
        check_impact_joint(path, *this);
    }
  } // namespace Multibody
} // namespace Tribody

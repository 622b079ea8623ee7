#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/multibody/contact_force_law.h>
#include <tribody/multibody/friction_law.h>
#include <tribody/multibody/joint_parameters.h>

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
          {"ideal", "clearance"},
          "Revolute joint: 'ideal' keeps the two centres together; with "
          "'clearance' the pin moves freely in the bushing until it touches "
          "it, and contact and friction forces act then.");
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
          "Normal force in contact. 'Hertz': F_N = K delta^1.5 with the "
          "penetration delta. 'Lankarani-Nikravesh': the same times 1 + 3/4 "
          "(1 - e_r^2) delta'/delta'_minus, which takes energy out of an "
          "impact; delta'_minus is the approach speed at which the contact "
          "began.");
        Parameters::add_quantity(
          prm,
          "Restitution coefficient",
          p.restitution_coefficient,
          "",
          "e_r of 'Lankarani-Nikravesh', between 0 and 1 (no loss). It is "
          "the law's parameter: for values below 0.9 a free impact leaves "
          "noticeably faster than e_r says.");
        Parameters::add_quantity(
          prm,
          "Minimum approach speed",
          p.minimum_approach_speed,
          "m/s",
          "Floor of delta'_minus. It is also its value for a motion that "
          "starts in contact. Without a floor a contact that begins gently "
          "would be damped without bound.",
          "mm/s");
        Parameters::add_choice(prm,
                               "Friction law",
                               p.friction_law,
                               friction_law_names(),
                               "'Coulomb regularised': F_mu = mu F_N "
                               "tanh(v_t/v_0) against the sliding of the two "
                               "surfaces at the contact.");
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
      check_clearance_joint(const std::string &path, const JointParameters &p)
      {
        AssertThrow(p.pin_radius > 0,
                    ExcParameter(path + "/Pin radius",
                                 "must be positive, not " +
                                   Units::to_string(p.pin_radius, "m", "mm")));
        AssertThrow(
          p.bushing_radius >= p.pin_radius,
          ExcParameter(path + "/Pin radius",
                       "must be at most the bushing's radius of " +
                         Units::to_string(p.bushing_radius, "m", "mm") +
                         ", not " + Units::to_string(p.pin_radius, "m", "mm")));
        AssertThrow(
          p.restitution_coefficient > 0 && p.restitution_coefficient <= 1,
          ExcParameter(path + "/Restitution coefficient",
                       "must be above 0 and at most 1, not " +
                         Units::to_string(p.restitution_coefficient, "", "")));
        const auto check_positive = [&](const std::string &entry,
                                        const double       value,
                                        const std::string &unit) {
          AssertThrow(value > 0,
                      ExcParameter(path + "/" + entry,
                                   "must be positive, not " +
                                     Units::to_string(value, unit, unit)));
        };
        check_positive("Minimum approach speed",
                       p.minimum_approach_speed,
                       "m/s");
        check_positive("Friction regularisation speed",
                       p.friction_regularisation_speed,
                       "m/s");
        const auto check_not_negative = [&](const std::string &entry,
                                            const double       value,
                                            const std::string &unit) {
          AssertThrow(value >= 0,
                      ExcParameter(path + "/" + entry,
                                   "must be zero or positive, not " +
                                     Units::to_string(value, unit, unit)));
        };
        check_not_negative("Friction coefficient", p.friction_coefficient, "");
        check_not_negative("Tangential damping", p.tangential_damping, "N s/m");
        p.pin_material.check();
        p.bushing_material.check();
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
      add_other_types(prm, *this);
    }



    void
    JointParameters::check() const
    {
      // Radii and laws of an ideal joint are not used: nothing to check.
      if (has_clearance())
        check_clearance_joint("Joint " + name, *this);
    }
  } // namespace Multibody
} // namespace Tribody

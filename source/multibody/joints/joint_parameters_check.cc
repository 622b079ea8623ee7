// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/base/significant_digits.h>
#include <tribody/base/units.h>
#include <tribody/multibody/joints/contact_force_law.h>
#include <tribody/multibody/joints/joint_parameters.h>

#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
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
                         const std::string &unit,
                         const std::string &shown_unit = "")
      {
        AssertThrow(value >= 0,
                    ExcParameter(path,
                                 "must be zero or positive, not " +
                                   Units::to_string(value,
                                                    unit,
                                                    shown_unit.empty()
                                                      ? unit
                                                      : shown_unit)));
      }



      // Entries of the chosen law only: the others are not used.
      void
      check_contact_law(const std::string &path, const JointParameters &p)
      {
        if (p.contact_force_law.is<SpringDamperLaw>())
          {
            constexpr double penetration = 1e-6;
            const double     slope       = 1.5 * std::sqrt(penetration) *
                                 compute_hertz_stiffness(p.pin_radius,
                                                         p.bushing_radius,
                                                         p.pin_material,
                                                         p.bushing_material,
                                                         RadiiCombination::sum);
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
        AssertThrow(
          p.radii_combination == RadiiCombination::sum || p.clearance() > 0,
          ExcParameter(path + "/Radii of contact stiffness",
                       "'difference' needs a bushing radius above the pin "
                       "radius of " +
                         Units::to_string(p.pin_radius, "m", "mm") +
                         ": without clearance the contact law's K has no "
                         "bound"));
        if (p.contact_force_law.is<ElasticFoundationLaw>())
          {
            check_positive(path + "/Foundation length",
                           p.foundation_length,
                           "m",
                           "mm");
            check_positive(path + "/Foundation thickness",
                           p.foundation_thickness,
                           "m",
                           "mm");
            check_not_negative(path + "/Foundation modulus",
                               p.foundation_modulus,
                               "Pa",
                               "GPa");
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
                       "m/s",
                       "mm/s");
        if (p.friction_law.is<AmbrosioFriction>())
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
        if (p.friction_law.is<StribeckFriction>() ||
            p.friction_law.is<LuGreFriction>())
          {
            AssertThrow(
              p.static_friction_coefficient >= p.friction_coefficient,
              ExcParameter(
                path + "/Static friction coefficient",
                "must be at least the friction coefficient of " +
                  Units::to_string(p.friction_coefficient, "", "") + ", not " +
                  Units::to_string(p.static_friction_coefficient, "", "")));
            check_positive(path + "/Stribeck speed",
                           p.stribeck_speed,
                           "m/s",
                           "mm/s");
            check_not_negative(path + "/Viscous friction",
                               p.viscous_friction,
                               "s/m");
          }
        if (p.friction_law.is<LuGreFriction>())
          {
            AssertThrow(p.friction_coefficient > 0,
                        ExcParameter(path + "/Friction coefficient",
                                     "must be positive for the law 'LuGre', "
                                     "whose bristles slip when they are bent "
                                     "by mu/sigma_0; without friction write "
                                     "'set Friction law = none'"));
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
                       "must be above 0 and at most 1 (no loss), not " +
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
        AssertThrow(p.has_contact_law() || p.clearance() > 0,
                    ExcParameter(path + "/Model",
                                 "'" + name_of(p.model) +
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
                       "m/s",
                       "mm/s");
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
    JointParameters::check() const
    {
      // Radii and laws of an ideal joint are not used: nothing to check.
      const std::string path = "Joint " + name;
      if (has_gap())
        check_radii(path, *this);
      if (has_contact_law())
        check_clearance_joint(path, *this);
      else if (has_gap() && model == JointModel::impact)
        check_impact_joint(path, *this);
    }
  } // namespace Multibody
} // namespace Tribody

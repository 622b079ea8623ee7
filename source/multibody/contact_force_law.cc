#include <tribody/base/exceptions.h>
#include <tribody/base/material.h>
#include <tribody/multibody/contact_force_law.h>
#include <tribody/multibody/joint_parameters.h>

#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    NormalForce
    HertzLaw::normal_force(const ContactKinematics &contact) const
    {
      if (contact.penetration <= 0)
        return {};
      const double slope = stiffness * std::sqrt(contact.penetration);
      return {slope * contact.penetration, 1.5 * slope, 0.};
    }



    NormalForce
    LankaraniNikraveshLaw::normal_force(const ContactKinematics &contact) const
    {
      const double d = 0.75 *
                       (1 - restitution_coefficient * restitution_coefficient) /
                       contact.approach_speed;
      const double factor = 1 + d * contact.penetration_rate;
      // Surfaces that separate faster than the law allows lose contact: they
      // do not attract each other.
      if (contact.penetration <= 0 || factor <= 0)
        return {};
      const double slope   = stiffness * std::sqrt(contact.penetration);
      const double elastic = slope * contact.penetration;
      return {elastic * factor, 1.5 * slope * factor, elastic * d};
    }



    std::vector<std::string>
    contact_force_law_names()
    {
      return {"Hertz", "Lankarani-Nikravesh"};
    }



    ContactForceLaw
    make_contact_force_law(const JointParameters &joint)
    {
      const double stiffness = compute_hertz_stiffness(joint.pin_radius,
                                                       joint.bushing_radius,
                                                       joint.pin_material,
                                                       joint.bushing_material);
      if (joint.contact_force_law == "Hertz")
        return HertzLaw{stiffness};
      if (joint.contact_force_law == "Lankarani-Nikravesh")
        return LankaraniNikraveshLaw{stiffness, joint.restitution_coefficient};
      AssertThrow(false,
                  ExcParameter("Joint " + joint.name + "/Contact force law",
                               "'" + joint.contact_force_law +
                                 "' is not known"));
      return HertzLaw{stiffness};
    }



    NormalForce
    compute_normal_force(const ContactForceLaw   &law,
                         const ContactKinematics &contact)
    {
      return std::visit(
        [&](const auto &chosen) { return chosen.normal_force(contact); }, law);
    }



    double
    compute_penetration(const ContactForceLaw &law,
                        const double           normal_force,
                        const double           penetration_rate,
                        const double           approach_speed)
    {
      const auto force = [&](const double penetration) {
        return compute_normal_force(
          law, {penetration, penetration_rate, approach_speed});
      };
      // Bracket the force, then Newton: all laws grow with the penetration,
      // faster than linearly, so that it converges from above.
      double penetration = 1e-12;
      while (force(penetration).value < normal_force && penetration < 1.)
        penetration *= 2.;
      for (unsigned int i = 0; i < 50; ++i)
        {
          const NormalForce f = force(penetration);
          if (!(f.d_penetration > 0))
            break;
          const double step = (f.value - normal_force) / f.d_penetration;
          penetration -= step;
          if (std::abs(step) < 1e-14 * penetration)
            break;
        }
      return penetration;
    }



    double
    compute_hertz_stiffness(const double    pin_radius,
                            const double    bushing_radius,
                            const Material &pin,
                            const Material &bushing)
    {
      const auto compliance = [](const Material &material) {
        return (1 - material.poissons_ratio * material.poissons_ratio) /
               material.youngs_modulus;
      };
      return 4. / (3. * (compliance(pin) + compliance(bushing))) *
             std::sqrt(pin_radius * bushing_radius /
                       (pin_radius + bushing_radius));
    }
  } // namespace Multibody
} // namespace Tribody

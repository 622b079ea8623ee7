// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/material/material.h>
#include <tribody/multibody/joints/contact_force_law.h>
#include <tribody/multibody/joints/joint_parameters.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      double
      hertz_stiffness(const JointParameters &joint)
      {
        return compute_hertz_stiffness(joint.pin_radius,
                                       joint.bushing_radius,
                                       joint.pin_material,
                                       joint.bushing_material,
                                       joint.radii_combination);
      }



      // An elastic force with its slope, times the factor 1 + d delta'/delta'-.
      // Surfaces that separate faster than the law allows lose contact: they do
      // not attract each other.
      NormalForce
      with_hysteresis(const double             elastic,
                      const double             slope,
                      const double             d,
                      const ContactKinematics &contact)
      {
        const double per_rate = d / contact.approach_speed;
        const double factor   = 1 + per_rate * contact.penetration_rate;
        if (contact.penetration <= 0 || factor <= 0)
          return {};
        return {elastic * factor, slope * factor, elastic * per_rate};
      }



      NormalForce
      hertz_with_hysteresis(const double             stiffness,
                            const double             d,
                            const ContactKinematics &contact)
      {
        const double slope =
          stiffness * std::sqrt(std::max(0., contact.penetration));
        return with_hysteresis(slope * contact.penetration,
                               1.5 * slope,
                               d,
                               contact);
      }



      // Of Lankarani and Nikravesh.
      double
      hysteresis(const double restitution_coefficient)
      {
        return 0.75 * (1 - restitution_coefficient * restitution_coefficient);
      }



      // x - sin x; by its series where the difference would lose its digits.
      double
      minus_sine(const double x)
      {
        if (std::abs(x) > 0.5)
          return x - std::sin(x);
        const double y = x * x;
        return x * y / 6 *
               (1 - y / 20 * (1 - y / 42 * (1 - y / 72 * (1 - y / 110))));
      }
    } // namespace



    HertzLaw
    HertzLaw::make(const JointParameters &joint)
    {
      return {hertz_stiffness(joint)};
    }



    NormalForce
    HertzLaw::normal_force(const ContactKinematics &contact) const
    {
      if (contact.penetration <= 0)
        return {};
      const double slope = stiffness * std::sqrt(contact.penetration);
      return {slope * contact.penetration, 1.5 * slope, 0.};
    }



    LankaraniNikraveshLaw
    LankaraniNikraveshLaw::make(const JointParameters &joint)
    {
      return {hertz_stiffness(joint), joint.restitution_coefficient};
    }



    NormalForce
    LankaraniNikraveshLaw::normal_force(const ContactKinematics &contact) const
    {
      return hertz_with_hysteresis(stiffness,
                                   hysteresis(restitution_coefficient),
                                   contact);
    }



    HuntCrossleyLaw
    HuntCrossleyLaw::make(const JointParameters &joint)
    {
      return {hertz_stiffness(joint), joint.restitution_coefficient};
    }



    NormalForce
    HuntCrossleyLaw::normal_force(const ContactKinematics &contact) const
    {
      return hertz_with_hysteresis(stiffness,
                                   1.5 * (1 - restitution_coefficient),
                                   contact);
    }



    FloresLaw
    FloresLaw::make(const JointParameters &joint)
    {
      return {hertz_stiffness(joint), joint.restitution_coefficient};
    }



    NormalForce
    FloresLaw::normal_force(const ContactKinematics &contact) const
    {
      return hertz_with_hysteresis(stiffness,
                                   1.6 * (1 - restitution_coefficient) /
                                     restitution_coefficient,
                                   contact);
    }



    SpringDamperLaw
    SpringDamperLaw::make(const JointParameters &joint)
    {
      return {joint.contact_stiffness, joint.contact_damping};
    }



    NormalForce
    SpringDamperLaw::normal_force(const ContactKinematics &contact) const
    {
      const double force =
        stiffness * contact.penetration + damping * contact.penetration_rate;
      if (contact.penetration < 0 || force <= 0)
        return {};
      return {force, stiffness, damping};
    }



    ElasticFoundationLaw
    ElasticFoundationLaw::make(const JointParameters &joint)
    {
      const double modulus = joint.foundation_modulus > 0
                               ? joint.foundation_modulus
                               : compute_layer_modulus(joint.bushing_material);
      return {joint.clearance(),
              joint.bushing_radius,
              joint.foundation_length,
              modulus / joint.foundation_thickness,
              joint.restitution_coefficient};
    }



    double
    ElasticFoundationLaw::half_angle(const double penetration) const
    {
      if (penetration <= 0)
        return 0.;
      // The arc cosine of nearly one has no digits.
      return std::atan2(std::sqrt(penetration * (2 * clearance + penetration)),
                        clearance);
    }



    NormalForce
    ElasticFoundationLaw::normal_force(const ContactKinematics &contact) const
    {
      const double t_0   = half_angle(contact.penetration);
      const double scale = foundation_modulus * length * bore_radius;
      // With c = (c + delta) cos t_0.
      const double elastic =
        scale * (clearance + contact.penetration) * minus_sine(2 * t_0) / 2;
      return with_hysteresis(elastic,
                             scale * (t_0 + std::sin(2 * t_0) / 2),
                             hysteresis(restitution_coefficient),
                             contact);
    }



    FiniteElementLaw
    FiniteElementLaw::make(const JointParameters &joint)
    {
      return {joint.restitution_coefficient};
    }



    NormalForce
    FiniteElementLaw::normal_force(const ContactKinematics &contact) const
    {
      const NormalForce f = with_hysteresis(contact.elastic_force,
                                            1.,
                                            hysteresis(restitution_coefficient),
                                            contact);
      return {f.value, 0., f.d_penetration_rate, f.d_penetration};
    }



    double
    ElasticFoundationLaw::pressure(const double             angle,
                                   const ContactKinematics &contact) const
    {
      const double indentation =
        (clearance + contact.penetration) * std::cos(angle) - clearance;
      return with_hysteresis(foundation_modulus * std::max(0., indentation),
                             0.,
                             hysteresis(restitution_coefficient),
                             contact)
        .value;
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
      // Bracket the force, then Newton: all laws grow with the penetration, not
      // slower than linearly, so that it converges from above.
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
      // A damper alone may press harder than that.
      return std::max(0., penetration);
    }



    double
    compute_layer_modulus(const Material &material)
    {
      const double nu = material.poissons_ratio;
      return (1 - nu) * material.youngs_modulus / ((1 + nu) * (1 - 2 * nu));
    }



    double
    compute_hertz_stiffness(const double           pin_radius,
                            const double           bushing_radius,
                            const Material        &pin,
                            const Material        &bushing,
                            const RadiiCombination radii)
    {
      const double combined   = radii == RadiiCombination::sum
                                  ? pin_radius + bushing_radius
                                  : bushing_radius - pin_radius;
      const auto   compliance = [](const Material &material) {
        return (1 - material.poissons_ratio * material.poissons_ratio) /
               material.youngs_modulus;
      };
      return 4. / (3. * (compliance(pin) + compliance(bushing))) *
             std::sqrt(pin_radius * bushing_radius / combined);
    }



    std::optional<double>
    find_hertz_stiffness(const ContactForceLaw &law)
    {
      if (const auto *hertz = std::get_if<HertzLaw>(&law))
        return hertz->stiffness;
      if (const auto *lankarani = std::get_if<LankaraniNikraveshLaw>(&law))
        return lankarani->stiffness;
      if (const auto *hunt = std::get_if<HuntCrossleyLaw>(&law))
        return hunt->stiffness;
      if (const auto *flores = std::get_if<FloresLaw>(&law))
        return flores->stiffness;
      return {};
    }
  } // namespace Multibody
} // namespace Tribody

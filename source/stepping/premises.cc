// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/significant_digits.h>
#include <tribody/base/units.h>
#include <tribody/stepping/premises.h>

#include <algorithm>
#include <limits>

namespace Tribody
{
  namespace Coupling
  {
    double
    Strains::largest() const
    {
      return std::max(pressure, displacement);
    }



    void
    Strains::widen(const Strains &other)
    {
      pressure     = std::max(pressure, other.pressure);
      displacement = std::max(displacement, other.displacement);
    }



    namespace
    {
      Strains
      strains_under(const WearingBushing            &bushing,
                    const Multibody::JointDutyCycle &cycle,
                    const double                     pressure)
      {
        const Material &material = bushing.joint_parameters().bushing_material;
        Strains         strains;
        strains.pressure =
          pressure / bushing.youngs_modulus() *
          (1. - material.poissons_ratio * material.poissons_ratio);
        if (cycle.has_contact_law)
          strains.displacement =
            std::max(0., cycle.penetration.maxCoeff()) / bushing.wall();
        return strains;
      }
    } // namespace



    Strains
    compute_strains(const WearingBushing            &bushing,
                    const Multibody::JointDutyCycle &cycle,
                    const CycleContact              &contact)
    {
      return strains_under(bushing, cycle, contact.max_pressure);
    }



    Strains
    compute_least_strains(const WearingBushing            &bushing,
                          const Multibody::JointDutyCycle &cycle)
    {
      return strains_under(bushing,
                           cycle,
                           cycle.normal_force.maxCoeff() /
                             (2. * bushing.joint_parameters().bushing_radius *
                              bushing.bushing_parameters().axial_length));
    }



    std::string
    describe(const Strains &strains)
    {
      if (strains.largest() <= Strains::noted)
        return "";
      return "largest pressure " +
             significant_digits(100. * strains.pressure, 2) +
             " % of the bushing's modulus, penetration " +
             significant_digits(100. * strains.displacement, 2) +
             " % of its wall: " +
             (strains.largest() <= Strains::doubtful
                ? "near the limits of linear elasticity and small displacements"
                : "linear elasticity and small displacements, which pressures "
                  "rest on, do not hold, and these may be wrong by as much; "
                  "take a stiffer or longer bushing");
    }



    void
    check_strains(const Strains &strains, const std::string &bushing)
    {
      AssertThrow(strains.largest() <= Strains::largest_allowed,
                  ExcRun("Bushing " + bushing + ": the largest pressure is " +
                         significant_digits(100. * strains.pressure, 2) +
                         " % of its modulus, the penetration " +
                         significant_digits(100. * strains.displacement, 2) +
                         " % of its wall. Beyond " +
                         significant_digits(100. * Strains::largest_allowed) +
                         " % neither linear elasticity nor small displacements "
                         "hold, and there is no result. It takes smaller "
                         "loads or speeds, or a stiffer or larger bushing"));
    }



    void
    check_pin_in_bore(const WearingBushing            &bushing,
                      const Multibody::JointDutyCycle &cycle,
                      const Eigen::VectorXd           &time)
    {
      if (!cycle.has_gap)
        return;
      Eigen::Index sample;
      const double farthest = cycle.eccentricity.maxCoeff(&sample);
      const double allowed =
        bushing.largest_clearance(bushing.depth()) + bushing.wall();
      AssertThrow(
        farthest <= allowed,
        ExcRun("Joint " + bushing.name() + ": at time " +
               significant_digits(time[sample], 6) + " s the pin's centre is " +
               Units::to_string(farthest, "m", "mm") +
               " from the bushing's. Clearance and wall together are " +
               Units::to_string(allowed, "m", "mm") +
               ": the pin has left its bore, which its contact force "
               "law does not hold. Look at loads, speed, radii and "
               "moduli"));
    }



    void
    check_warmth(const WearingBushing &bushing, const Warmth &warmth)
    {
      bushing.warm_bushing()->modulus_factor(warmth);
      bushing.warm_bushing()->friction_factor(warmth);

      const PeriodicProfile cold      = bushing.clearance_profile();
      double                narrowest = std::numeric_limits<double>::max();
      for (const double angle : bushing.node_angles())
        narrowest =
          std::min(narrowest,
                   cold.value(angle) + cold.value(angle + dealii::numbers::PI));
      narrowest -= 2. * warmth.closing;
      if (const WearingPin *pin = bushing.wearing_pin())
        narrowest += 2. * pin->profile().depth.minCoeff();
      const auto celsius = [](const double temperature) {
        return Units::to_string(temperature, "K", "degC", 4);
      };
      AssertThrow(
        narrowest > 0.,
        ExcRun("Joint " + bushing.name() +
               ": no clearance is left when it is warm. At " +
               celsius(warmth.contact_temperature) + " in the contact and " +
               celsius(warmth.mean_temperature) +
               " in the bushing, pin and bore have come nearer by " +
               Units::to_string(warmth.closing, "m", "mm", 4) +
               ", of a clearance of " +
               Units::to_string(
                 bushing.joint_parameters().clearance(), "m", "mm", 4) +
               " at the 'Reference temperature'. It takes more clearance, "
               "less friction, load or speed, a better path for the heat, or a "
               "material that expands less"));
    }
  } // namespace Coupling
} // namespace Tribody

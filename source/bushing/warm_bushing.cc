// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/bushing/warm_bushing.h>

#include <limits>
#include <string>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // Through the rim [W/(m^2 K)].
      double
      heat_transfer_coefficient(const Thermal::HeatParameters  &heat,
                                const dealii::Triangulation<2> &mesh,
                                const BushingParameters        &parameters)
      {
        if (heat.rim != Thermal::RimCooling::transfer)
          return std::numeric_limits<double>::infinity();
        if (heat.heat_transfer_coefficient > 0.)
          return heat.heat_transfer_coefficient;
        const double area =
          Thermal::rim_length(mesh, parameters.element_degree) *
          parameters.axial_length;
        return 1. / (heat.thermal_resistance * area);
      }



      std::string
      path_of(const BushingParameters &parameters, const std::string &entry)
      {
        return "Bushing " + parameters.name + "/Heat/" + entry;
      }
    } // namespace



    WarmBushing::WarmBushing(const BushingParameters          &parameters,
                             const Multibody::JointParameters &joint,
                             const ElasticJoint               &elastic)
      : heat(parameters.heat)
      , bushing_material(joint.bushing_material)
      , axial_length(parameters.axial_length)
      , pin_radius(joint.pin_radius)
      , pin_expansion(joint.pin_material.thermal_expansion)
      , elastic(elastic)
      , conduction(elastic.mesh(),
                   parameters.element_degree,
                   joint.bushing_material.thermal_conductivity,
                   heat_transfer_coefficient(parameters.heat,
                                             elastic.mesh(),
                                             parameters))
      , modulus(path_of(parameters, "Modulus factor"), heat.modulus_factor)
      , friction(path_of(parameters, "Friction factor"), heat.friction_factor)
    {}



    Warmth
    WarmBushing::compute(const Eigen::VectorXd &heat_shape,
                         const double           power,
                         const double           ambient_temperature) const
    {
      const Eigen::Index    n     = heat_shape.size();
      const double          sum   = heat_shape.sum();
      const Eigen::VectorXd parts = sum > 0.
                                      ? Eigen::VectorXd(heat_shape / sum)
                                      : Eigen::VectorXd::Constant(n, 1. / n);

      Warmth warmth;
      warmth.power                                = power;
      warmth.ambient_temperature                  = ambient_temperature;
      const Thermal::TemperatureRise rise         = compute_rise(parts, power);
      const double                   contact_rise = parts.dot(rise.at_bore);
      warmth.shaft_power         = heat.shaft_conductance * contact_rise;
      warmth.contact_temperature = ambient_temperature + contact_rise;
      warmth.max_temperature  = ambient_temperature + rise.at_bore.maxCoeff();
      warmth.mean_temperature = ambient_temperature + rise.mean;
      warmth.temperature      = rise.field;
      warmth.temperature.add(ambient_temperature);
      warmth.closing = compute_closing(rise, warmth);
      return warmth;
    }



    Thermal::TemperatureRise
    WarmBushing::compute_rise(const Eigen::VectorXd &parts,
                              const double           power) const
    {
      // Nothing flows in a bushing without a way out; it has the temperature
      // at which all leaves through the shaft.
      if (heat.rim == Thermal::RimCooling::insulated)
        return conduction.uniform(power / heat.shaft_conductance);
      Thermal::TemperatureRise rise =
        conduction.solve(elastic.mapping(), parts * (power / axial_length));
      const double to_shaft =
        power > 0. ? heat.shaft_conductance * parts.dot(rise.at_bore) / power
                   : 0.;
      const double through_bushing = 1. / (1. + to_shaft);
      rise.field *= through_bushing;
      rise.at_bore *= through_bushing;
      rise.mean *= through_bushing;
      return rise;
    }



    Eigen::VectorXd
    WarmBushing::compute_closing(const Thermal::TemperatureRise &rise,
                                 const Warmth                   &warmth) const
    {
      const double growth_of_pin =
        pin_expansion * pin_radius *
        (warmth.contact_temperature - heat.reference_temperature);
      Eigen::VectorXd closing =
        Eigen::VectorXd::Constant(rise.at_bore.size(), growth_of_pin);
      if (bushing_material.thermal_expansion > 0.)
        {
          dealii::Vector<double> above_reference = rise.field;
          above_reference.add(warmth.ambient_temperature -
                              heat.reference_temperature);
          closing -=
            elastic.thermal_displacement(conduction.get_dof_handler(),
                                         above_reference,
                                         bushing_material.thermal_expansion);
        }
      return closing;
    }



    double
    WarmBushing::modulus_factor(const Warmth &warmth) const
    {
      return modulus.is_one() ? 1. : modulus.value(warmth.mean_temperature);
    }



    double
    WarmBushing::friction_factor(const Warmth &warmth) const
    {
      return friction.is_one() ? 1.
                               : friction.value(warmth.contact_temperature);
    }
  } // namespace Coupling
} // namespace Tribody

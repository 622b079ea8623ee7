// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/ranks.h>
#include <tribody/bushing/warm_bushing.h>

#include <algorithm>
#include <array>
#include <cmath>
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



    Warmth
    between(const Warmth &from, const Warmth &to, const double part)
    {
      Warmth result = to;
      for (double Warmth::*value : {&Warmth::contact_temperature,
                                    &Warmth::max_temperature,
                                    &Warmth::mean_temperature,
                                    &Warmth::closing})
        result.*value = from.*value + part * (to.*value - from.*value);
      result.temperature.sadd(part, 1. - part, from.temperature);
      return result;
    }



    Warmth
    correct(const Warmth    &warmth,
            const Warmth    &found,
            WarmthIteration &iteration)
    {
      // Beyond, the last two differences tell nothing.
      constexpr double smallest = 0.2, largest = 5.;

      const double difference =
        found.contact_temperature - warmth.contact_temperature;
      double residual =
        std::max({std::abs(difference),
                  std::abs(found.max_temperature - warmth.max_temperature),
                  std::abs(found.mean_temperature - warmth.mean_temperature)});
      const double decrease = iteration.difference - difference;
      if (iteration.difference != 0. && decrease != 0.)
        {
          const double exact =
            iteration.relaxation * iteration.difference / decrease;
          iteration.relaxation = std::clamp(exact, smallest, largest);
          // So far is the end, and farther than the difference where that
          // hardly becomes smaller.
          residual *= std::max(1., exact);
        }
      iteration.difference = difference;
      Warmth result        = between(warmth, found, iteration.relaxation);
      result.residual      = residual;
      return result;
    }



    namespace
    {
      // What roundings of ranks may not tell apart: they go on together.
      void
      take_from_first_rank(Warmth &warmth, const MPI_Comm &communicator)
      {
        const std::array<double *, 8> values = {{&warmth.power,
                                                 &warmth.shaft_power,
                                                 &warmth.ambient_temperature,
                                                 &warmth.contact_temperature,
                                                 &warmth.max_temperature,
                                                 &warmth.mean_temperature,
                                                 &warmth.closing,
                                                 &warmth.out_of_round}};
        const auto      n = static_cast<Eigen::Index>(values.size());
        Eigen::VectorXd all(n + warmth.temperature.size());
        for (Eigen::Index i = 0; i < n; ++i)
          all[i] = *values[i];
        std::copy(warmth.temperature.begin(),
                  warmth.temperature.end(),
                  all.begin() + n);
        Ranks::broadcast(all, 0, communicator);
        for (Eigen::Index i = 0; i < n; ++i)
          *values[i] = all[i];
        std::copy(all.begin() + n, all.end(), warmth.temperature.begin());
      }
    } // namespace



    WarmBushing::WarmBushing(const BushingParameters          &parameters,
                             const Multibody::JointParameters &joint,
                             const ElasticJoint               &elastic,
                             const MPI_Comm                   &communicator)
      : communicator(communicator)
      , heat(parameters.heat)
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
    {
      follow_geometry();
    }



    void
    WarmBushing::follow_geometry()
    {
      if (heat.rim != Thermal::RimCooling::insulated)
        conduction.reinit(elastic.mapping());
    }



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
      set_closing(warmth, rise);
      take_from_first_rank(warmth, communicator);
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
        conduction.solve(parts * (power / axial_length));
      const double to_shaft =
        power > 0. ? heat.shaft_conductance * parts.dot(rise.at_bore) / power
                   : 0.;
      const double through_bushing = 1. / (1. + to_shaft);
      rise.field *= through_bushing;
      rise.at_bore *= through_bushing;
      rise.mean *= through_bushing;
      return rise;
    }



    void
    WarmBushing::set_closing(Warmth                         &warmth,
                             const Thermal::TemperatureRise &rise) const
    {
      const double from_reference =
        warmth.ambient_temperature - heat.reference_temperature;
      warmth.closing =
        pin_expansion * pin_radius *
        (warmth.contact_temperature - heat.reference_temperature);
      if (bushing_material.thermal_expansion == 0.)
        return;
      dealii::Vector<double> above_reference = rise.field;
      above_reference.add(from_reference);
      const Eigen::VectorXd outwards =
        elastic.thermal_displacement(conduction.get_dof_handler(),
                                     above_reference,
                                     bushing_material.thermal_expansion);
      const Eigen::VectorXd &weights = elastic.bore().weights;
      warmth.closing -= outwards.dot(weights) / weights.sum();
      warmth.out_of_round = outwards.maxCoeff() - outwards.minCoeff();
    }



    double
    WarmBushing::modulus_factor(const Warmth &warmth) const
    {
      return modulus.is_one() || !warmth.is_known()
               ? 1.
               : modulus.value(warmth.mean_temperature);
    }



    double
    WarmBushing::friction_factor(const Warmth &warmth) const
    {
      return friction.is_one() || !warmth.is_known()
               ? 1.
               : friction.value(warmth.contact_temperature);
    }
  } // namespace Coupling
} // namespace Tribody

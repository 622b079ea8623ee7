// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/results/run_results.h>
#include <tribody/wear/crescent.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      Eigen::Vector2d
      direction(const Multibody::JointDutyCycle &cycle, const Eigen::Index j)
      {
        const double angle = cycle.contact_angle_bushing[j];
        return {std::cos(angle), std::sin(angle)};
      }



      // The closed form knows one direction of the force, one constant wear
      // coefficient and no elasticity: contact within 45 deg of its mean
      // direction, and wear deeper than the clearance.
      bool
      crescent_applies(const WearingBushing            &bushing,
                       const Multibody::JointDutyCycle &cycle,
                       const double                     clearance)
      {
        if (bushing.wearing_pin() != nullptr ||
            !bushing.surfaces().front().law.is_constant() ||
            !(clearance > 0.) || bushing.profile().max_depth() < clearance)
          return false;
        Eigen::Vector2d mean = Eigen::Vector2d::Zero();
        for (Eigen::Index j = 0; j < cycle.normal_force.size(); ++j)
          mean += cycle.normal_force[j] * direction(cycle, j);
        for (Eigen::Index j = 0; j < cycle.normal_force.size(); ++j)
          if (cycle.normal_force[j] > 0. &&
              direction(cycle, j).dot(mean) < std::sqrt(0.5) * mean.norm())
            return false;
        return true;
      }



      std::optional<CrescentResults>
      compute_crescent(const WearingBushing            &bushing,
                       const Multibody::JointDutyCycle &cycle,
                       const JointTotals               &totals)
      {
        const BushingParameters &parameters     = bushing.bushing_parameters();
        const Multibody::JointParameters &joint = bushing.joint_parameters();
        const double                      clearance = joint.clearance();
        if (!crescent_applies(bushing, cycle, clearance))
          return {};
        const Wear::Crescent crescent{joint.bushing_radius,
                                      clearance,
                                      parameters.axial_length,
                                      parameters.wear_coefficient,
                                      totals.force_over_sliding /
                                        totals.sliding_distance};
        const double         depth = crescent.depth(totals.sliding_distance);
        return CrescentResults{crescent.normal_force,
                               depth,
                               crescent.volume(depth)};
      }



      SurfaceResults
      measure_surface(const WearingSurface  &surface,
                      const Eigen::VectorXd &node_angles,
                      const double           worn_volume,
                      const JointTotals     &totals,
                      const SurfaceTotals   &surface_totals)
      {
        const Eigen::Index deepest = surface.profile.deepest_node();
        SurfaceResults     results;
        results.max_wear_depth = surface.profile.max_depth();
        results.max_wear_angle = node_angles[deepest];
        results.worn_volume    = worn_volume;
        results.worn_mass      = worn_volume * surface.density;
        if (surface_totals.removed_volume > 0.)
          results.volume_balance_relative_error =
            std::abs(worn_volume / surface_totals.removed_volume - 1.);
        results.depth_error  = surface.part_of(totals.depth_error)[deepest];
        results.volume_error = surface_totals.volume_error;
        return results;
      }



      BushingResults
      compute_bushing_results(const WearingBushing            &bushing,
                              const std::size_t                number,
                              const JointState                &joint,
                              const Multibody::JointDutyCycle &cycle)
      {
        const std::vector<WearingSurface> surfaces = bushing.surfaces();

        BushingResults results;
        results.name    = bushing.name();
        results.number  = number;
        results.bushing = measure_surface(surfaces[0],
                                          bushing.node_angles(),
                                          bushing.worn_volume(),
                                          joint.totals,
                                          joint.totals.surfaces[0]);
        if (const WearingPin *pin = bushing.wearing_pin())
          results.pin = measure_surface(surfaces[1],
                                        pin->node_angles(),
                                        bushing.pin_worn_volume(),
                                        joint.totals,
                                        joint.totals.surfaces[1]);
        results.crescent  = compute_crescent(bushing, cycle, joint.totals);
        results.clearance = bushing.largest_clearance(joint.depth);
        results.mesh_oscillation =
          Wear::mesh_oscillation(surfaces[0].part_of(joint.contact.wear_rate));
        return results;
      }
    } // namespace



    double
    BushingResults::depth_relative_error() const
    {
      double depth = bushing.max_wear_depth, error = bushing.depth_error;
      if (pin)
        {
          depth = std::max(depth, pin->max_wear_depth);
          error = std::max(error, pin->depth_error);
        }
      return depth > 0. ? error / depth : 0.;
    }



    double
    BushingResults::volume_relative_error() const
    {
      double volume = bushing.worn_volume, error = bushing.volume_error;
      if (pin)
        {
          volume += pin->worn_volume;
          error += pin->volume_error;
        }
      return volume > 0. ? error / volume : 0.;
    }



    const BushingResults *
    RunResults::bushing(const std::string &name) const
    {
      for (const BushingResults &results : bushings)
        if (results.name == name)
          return &results;
      return nullptr;
    }



    double
    RunResults::depth_relative_error() const
    {
      double largest = 0.;
      for (const BushingResults &results : bushings)
        largest = std::max(largest, results.depth_relative_error());
      return largest;
    }



    double
    RunResults::volume_relative_error() const
    {
      double largest = 0.;
      for (const BushingResults &results : bushings)
        largest = std::max(largest, results.volume_relative_error());
      return largest;
    }



    RunResults
    make_run_results(const WearProcess &process)
    {
      RunResults results;
      results.state = process.state();
      for (std::size_t j = 0; j < process.bushings().size(); ++j)
        {
          const WearingBushing &bushing = process.bushings()[j];
          const JointState     &joint   = process.state().joints[j];
          if (!joint.contact.samples.empty())
            results.bushings.push_back(compute_bushing_results(
              bushing,
              j,
              joint,
              process.state().duty_cycle.joint(bushing.name())));
        }
      return results;
    }
  } // namespace Coupling
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/significant_digits.h>
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
      // coefficient, no elasticity and no temperature: contact within 45 deg of
      // its mean direction, and wear deeper than the clearance.
      bool
      crescent_applies(const WearingBushing            &bushing,
                       const Multibody::JointDutyCycle &cycle,
                       const double                     clearance)
      {
        if (bushing.wearing_pin() != nullptr || bushing.warmth().is_known() ||
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
        const Wear::Crescent crescent{
          joint.bushing_radius,
          clearance,
          parameters.axial_length,
          bushing.surfaces().front().law.archard.wear_coefficient,
          totals.force_over_sliding / totals.sliding_distance};
        const double depth = crescent.depth(totals.sliding_distance);
        return CrescentResults{crescent.normal_force,
                               depth,
                               crescent.volume(depth)};
      }



      SurfaceResults
      measure_surface(const WearingSurface  &surface,
                      const Eigen::VectorXd &node_angles,
                      const double           worn_volume,
                      const JointTotals     &totals,
                      const SurfaceTotals   &surface_totals,
                      const double           bore_volume)
      {
        // Of the bore: less is not told from what roundings leave in the place
        // of its surface.
        constexpr double noticeable = 1e-12;

        const Eigen::Index deepest = surface.profile.deepest_node();
        SurfaceResults     results;
        results.max_wear_depth = surface.profile.max_depth();
        results.max_wear_angle = node_angles[deepest];
        results.worn_volume    = worn_volume;
        results.worn_mass      = worn_volume * surface.density;
        if (surface.law.is_constant())
          results.archard_volume =
            surface.law.archard.wear_coefficient * totals.force_over_sliding;
        if (surface_totals.removed_volume > noticeable * bore_volume)
          results.volume_balance_relative_error =
            std::abs(worn_volume / surface_totals.removed_volume - 1.);
        results.depth_error  = surface.part_of(totals.depth_error)[deepest];
        results.volume_error = surface_totals.volume_error;
        return results;
      }



      BushingResults
      compute_bushing_results(const WearingBushing &bushing,
                              const std::size_t     number,
                              const WearProcess    &process)
      {
        const RunState                   &state    = process.state();
        const JointState                 &joint    = state.joints[number];
        const std::vector<WearingSurface> surfaces = bushing.surfaces();
        const double radius      = bushing.joint_parameters().bushing_radius;
        const double bore_volume = dealii::numbers::PI * radius * radius *
                                   bushing.bushing_parameters().axial_length;

        BushingResults results;
        results.name    = bushing.name();
        results.number  = number;
        results.bushing = measure_surface(surfaces[0],
                                          bushing.node_angles(),
                                          bushing.worn_volume(),
                                          joint.totals,
                                          joint.totals.surfaces[0],
                                          bore_volume);
        if (const WearingPin *pin = bushing.wearing_pin())
          results.pin = measure_surface(surfaces[1],
                                        pin->node_angles(),
                                        bushing.pin_worn_volume(),
                                        joint.totals,
                                        joint.totals.surfaces[1],
                                        bore_volume);
        // It knows one load case.
        if (process.wear_factors() == std::vector<double>{1.})
          results.crescent =
            compute_crescent(bushing,
                             state.duty_cycles.front().joint(bushing.name()),
                             joint.totals);
        results.clearance = bushing.largest_clearance(joint.depth);
        results.mesh_oscillation =
          Wear::mesh_oscillation(surfaces[0].part_of(joint.contact.wear_rate));
        if (state.cycles > 0.)
          results.duty_errors = joint.totals.duty_errors.over(state.cycles);
        if (number < state.mesh_errors.size() &&
            state.mesh_errors[number].covers_whole_run)
          results.mesh_error = state.mesh_errors[number].wear_depth;
        return results;
      }



      /// @throws ExcRun where it has something that is not a finite number.
      void
      check_motion(const Multibody::DutyCycle &cycle)
      {
        const std::string advice =
          " is not a finite number. Look at masses, stiffnesses, speeds and "
          "expressions";
        // Their sizes too, which have squares.
        for (const Multibody::JointDutyCycle &joint : cycle.joints)
          AssertThrow(joint.force().allFinite() &&
                        joint.normal_force.allFinite() &&
                        joint.moment.allFinite(),
                      ExcRun("Joint " + joint.name + ": a force" + advice));
        for (const Multibody::DriverDutyCycle &driver : cycle.drivers)
          AssertThrow(driver.force_x.allFinite() &&
                        driver.force_y.allFinite() &&
                        driver.moment.allFinite() && driver.power.allFinite(),
                      ExcRun("Driver " + driver.name + ": a force" + advice));
        AssertThrow(cycle.coordinates.allFinite() &&
                      cycle.velocities.allFinite() &&
                      cycle.accelerations.allFinite(),
                    ExcRun("A position, velocity or acceleration" + advice));
      }
    } // namespace



    double
    BushingResults::depth_relative_error() const
    {
      return step_error() + mesh_error + duty_errors.sum();
    }



    double
    BushingResults::step_error() const
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



    void
    check_results(const RunResults &results)
    {
      constexpr double largest_volume_error = 0.01, largest_energy_error = 0.1;

      for (const Multibody::DutyCycle &cycle : results.state.duty_cycles)
        check_motion(cycle);
      for (const BushingResults &bushing : results.bushings)
        {
          AssertThrow(results.state.joints[bushing.number].depth.allFinite(),
                      ExcRun(
                        "Bushing " + bushing.name +
                        ": a depth is not a finite number. Look at the "
                        "wear coefficient and at the forces of the joint"));
          double error = bushing.bushing.volume_balance_relative_error;
          if (bushing.pin)
            error = std::max(error, bushing.pin->volume_balance_relative_error);
          AssertThrow(error <= largest_volume_error,
                      ExcRun("Bushing " + bushing.name +
                             ": what the wear law has removed and what the "
                             "surfaces have lost differ by " +
                             significant_digits(100. * error, 3) +
                             " %. Shorter wear steps or a finer mesh may "
                             "help"));
        }
      for (const Multibody::DutyCycle &cycle : results.state.duty_cycles)
        AssertThrow(
          !cycle.energy.cycle.has_work ||
            cycle.energy.relative_error <= largest_energy_error,
          ExcRun("The energies of the recorded cycle miss their balance "
                 "by " +
                 significant_digits(100. * cycle.energy.relative_error, 3) +
                 " % of the largest of them: the motion is not right. "
                 "Look for drivers or forces that jump, and for a "
                 "smaller 'Dynamics/Accuracy'"));
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
            results.bushings.push_back(
              compute_bushing_results(bushing, j, process));
        }
      return results;
    }
  } // namespace Coupling
} // namespace Tribody

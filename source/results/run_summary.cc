// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/units.h>
#include <tribody/results/run_summary.h>
#include <tribody/wear/crescent.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

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
      crescent_applies(const Multibody::JointDutyCycle &cycle,
                       const Wear::WearProfile         &profile,
                       const double                     clearance)
      {
        if (!(clearance > 0.) || profile.max_depth() < clearance)
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



      // What the surface has lost against what the law has removed.
      double
      volume_balance(const double worn_volume, const SurfaceTotals &totals)
      {
        return totals.removed_volume > 0.
                 ? std::abs(worn_volume / totals.removed_volume - 1.)
                 : 0.;
      }



      BushingSummary
      summarise_bushing(const WearingBushing            &bushing,
                        const Multibody::JointDutyCycle &cycle,
                        const CycleContact              &contact,
                        const BushingTotals             &totals)
      {
        const BushingParameters &parameters     = bushing.bushing_parameters();
        const Multibody::JointParameters &joint = bushing.joint_parameters();
        const Wear::WearProfile          &profile = bushing.profile();

        BushingSummary summary;
        summary.max_wear_depth = profile.max_depth();
        summary.max_wear_angle = bushing.node_angles()[profile.deepest_node()];
        summary.worn_volume    = bushing.worn_volume();
        summary.worn_mass =
          summary.worn_volume * joint.bushing_material.density;
        summary.pressure_model     = name_of(parameters.pressure_model);
        summary.max_pressure       = contact.max_pressure;
        summary.contact_half_angle = contact.at_peak_force().half_angle;
        summary.mesh_oscillation   = Wear::mesh_oscillation(
          bushing.surfaces().front().part_of(contact.wear_rate));
        summary.volume_balance_relative_error =
          volume_balance(summary.worn_volume, totals.surfaces[0]);
        summary.comparison = parameters.comparison;

        const double unworn = joint.clearance();
        if (bushing.wearing_pin() == nullptr &&
            bushing.surfaces().front().law.is_constant() &&
            crescent_applies(cycle, profile, unworn))
          {
            const Wear::Crescent crescent{joint.bushing_radius,
                                          unworn,
                                          parameters.axial_length,
                                          parameters.wear_coefficient,
                                          totals.force_over_sliding /
                                            totals.sliding_distance};
            summary.crescent_normal_force = crescent.normal_force;
            summary.crescent_max_wear_depth =
              crescent.depth(totals.sliding_distance);
            summary.crescent_worn_volume =
              crescent.volume(summary.crescent_max_wear_depth);
          }
        return summary;
      }



      // Of the deepest node, relative to @p depth.
      double
      relative_error(const WearingSurface &surface,
                     const BushingTotals  &totals,
                     const double          depth)
      {
        const Eigen::VectorXd error = surface.part_of(totals.depth_error);
        return depth > 0. ? error[surface.profile.deepest_node()] / depth : 0.;
      }



      PinSummary
      summarise_pin(const WearingBushing &bushing, const BushingTotals &totals)
      {
        PinSummary summary;
        if (bushing.wearing_pin() == nullptr)
          return summary;
        const WearingSurface surface = bushing.surfaces().back();
        summary.wears                = true;
        summary.max_wear_depth       = surface.profile.max_depth();
        summary.max_wear_angle =
          bushing.wearing_pin()->node_angles()[surface.profile.deepest_node()];
        summary.worn_volume = bushing.pin_worn_volume();
        summary.worn_mass   = summary.worn_volume * surface.density;
        summary.volume_balance_relative_error =
          volume_balance(summary.worn_volume, totals.surfaces[1]);
        summary.max_wear_depth_relative_error =
          relative_error(surface, totals, summary.max_wear_depth);
        if (summary.worn_volume > 0.)
          summary.worn_volume_relative_error =
            totals.surfaces[1].volume_error / summary.worn_volume;
        return summary;
      }



      // Of either surface, relative to the deepest and to what both have lost.
      void
      add_errors(const WearingBushing &bushing,
                 const JointSummary   &joint,
                 const BushingTotals  &totals,
                 RunSummary           &summary)
      {
        const double depth = bushing.depth().maxCoeff();
        for (const WearingSurface &surface : bushing.surfaces())
          summary.max_wear_depth_relative_error =
            std::max(summary.max_wear_depth_relative_error,
                     relative_error(surface, totals, depth));
        const double volume = joint.bushing.worn_volume + joint.pin.worn_volume;
        if (volume > 0.)
          summary.worn_volume_relative_error =
            std::max(summary.worn_volume_relative_error,
                     (totals.surfaces[0].volume_error +
                      totals.surfaces[1].volume_error) /
                       volume);
      }



      DynamicsSummary
      summarise_dynamics(const Multibody::DutyCycle &cycle)
      {
        DynamicsSummary summary;
        summary.settling_cycles  = cycle.settling.n_cycles;
        summary.averaged_cycles  = cycle.settling.n_averaged_cycles;
        summary.n_steps          = cycle.statistics.n_steps;
        summary.n_steps_in_cycle = cycle.n_steps_in_cycle;
        summary.n_residuals      = cycle.statistics.n_residuals;
        summary.n_jacobians      = cycle.statistics.n_jacobians;
        if (cycle.statistics.n_starts > 0)
          summary.n_restarts = cycle.statistics.n_starts - 1;
        const Multibody::EnergyRecord &energy = cycle.energy.cycle;
        summary.has_energy                    = energy.has_work;
        summary.work                          = energy.work();
        summary.dissipated                    = energy.dissipated();
        summary.damper_loss                   = energy.damper_loss;
        summary.impact_loss                   = energy.impact_loss;
        if (cycle.energy.kinetic.size() > 0)
          {
            summary.min_kinetic_energy = cycle.energy.kinetic.minCoeff();
            summary.max_kinetic_energy = cycle.energy.kinetic.maxCoeff();
          }
        summary.energy_balance_relative_error = cycle.energy.relative_error;
        summary.energy_balance_relative_error_since_start =
          cycle.energy.relative_error_since_start;
        return summary;
      }



      // What the cycle tells of one joint, without its bushing.
      JointSummary
      summarise_joint(const Multibody::JointDutyCycle &cycle,
                      const Eigen::VectorXd           &phase)
      {
        using Multibody::ContactState;
        JointSummary joint;
        joint.name                   = cycle.name;
        joint.has_clearance          = cycle.has_gap;
        joint.has_contact_law        = cycle.has_contact_law;
        joint.peak_force             = cycle.peak_force();
        joint.peak_phase             = phase[cycle.peak_sample()];
        joint.mean_force             = cycle.mean_force();
        joint.mean_peak_force        = cycle.mean_peak_force;
        joint.peak_force_deviation   = cycle.peak_force_deviation;
        joint.mean_force_deviation   = cycle.mean_force_deviation;
        joint.residual_ringing       = cycle.residual_ringing;
        joint.peak_force_since_start = cycle.peak_force_since_start;
        joint.share_free             = cycle.share_of(ContactState::free);
        joint.share_impact           = cycle.share_of(ContactState::impact);
        joint.share_following        = cycle.share_of(ContactState::following);
        joint.n_onsets               = cycle.n_onsets;
        joint.n_losses               = cycle.n_losses;
        for (const Multibody::ContactInterval &contact : cycle.contacts)
          joint.max_approach_speed =
            std::max(joint.max_approach_speed, contact.approach_speed);
        return joint;
      }



      // "+0.3 %": how much @p value differs from @p reference.
      std::string
      difference(const double value, const double reference)
      {
        std::ostringstream out;
        out << std::showpos << std::fixed << std::setprecision(2)
            << 100. * (value / reference - 1.) << " %";
        return out.str();
      }



      void
      print_bushing(std::ostream &out, const JointSummary &joint)
      {
        const BushingSummary &bushing = joint.bushing;
        out << "    bushing: maximum depth " << std::setprecision(4)
            << bushing.max_wear_depth * 1e3 << " mm at "
            << Units::degrees(bushing.max_wear_angle) << " deg, volume "
            << bushing.worn_volume * 1e9 << " mm^3, mass "
            << bushing.worn_mass * 1e3 << " g" << std::endl
            << "    contact (" << bushing.pressure_model
            << "): largest pressure " << bushing.max_pressure * 1e-6
            << " MPa, half-angle at the largest force "
            << Units::degrees(bushing.contact_half_angle) << " deg"
            << std::endl;
        if (joint.pin.wears)
          out << "    pin: maximum depth " << std::setprecision(4)
              << joint.pin.max_wear_depth * 1e3 << " mm at "
              << Units::degrees(joint.pin.max_wear_angle)
              << " deg of its own frame, volume " << joint.pin.worn_volume * 1e9
              << " mm^3, mass " << joint.pin.worn_mass * 1e3 << " g"
              << std::endl;
        if (bushing.crescent_max_wear_depth > 0.)
          out << "    crescent closed form (stiff bushing, constant force "
              << bushing.crescent_normal_force
              << " N, the mean over the sliding distance): depth "
              << bushing.crescent_max_wear_depth * 1e3 << " mm (result "
              << difference(bushing.max_wear_depth,
                            bushing.crescent_max_wear_depth)
              << "), volume " << bushing.crescent_worn_volume * 1e9
              << " mm^3 (result "
              << difference(bushing.worn_volume, bushing.crescent_worn_volume)
              << ")" << std::endl;
        if (bushing.comparison.max_wear_depth > 0.)
          out << "    comparison: depth "
              << bushing.comparison.max_wear_depth * 1e3 << " mm (result "
              << difference(bushing.max_wear_depth,
                            bushing.comparison.max_wear_depth)
              << "), " << bushing.comparison.source << std::endl;
        if (bushing.comparison.worn_mass > 0.)
          out << "    comparison: mass " << bushing.comparison.worn_mass * 1e3
              << " g (result "
              << difference(bushing.worn_mass, bushing.comparison.worn_mass)
              << "), " << bushing.comparison.source << std::endl;
        out << std::setprecision(2) << "    checks: volume balance "
            << std::max(bushing.volume_balance_relative_error,
                        joint.pin.volume_balance_relative_error)
            << ", mesh-size oscillation of the wear rate "
            << bushing.mesh_oscillation
            << ", losses of contact in the recorded cycles "
            << joint.contact_losses << std::endl;
        const MeshError &mesh = bushing.mesh_error;
        if (mesh.n_coarse_nodes > 0)
          out << "    mesh: with " << mesh.n_coarse_nodes << " instead of "
              << mesh.n_nodes
              << " bore nodes the largest pressure of the first cycle differs "
                 "by "
              << 100. * mesh.max_pressure << " %, the maximum depth of "
              << (mesh.covers_whole_run ? "the run" : "that cycle") << " by "
              << 100. * mesh.wear_depth << " %" << std::endl;
      }



      // A table of the joints.
      void
      print_joint_table(std::ostream                    &out,
                        const std::vector<JointSummary> &joints)
      {
        std::size_t width = 6;
        for (const JointSummary &joint : joints)
          width = std::max(width, joint.name.size());
        const auto cell = [&out](const auto &value, const int columns) {
          out << std::setw(columns) << value;
        };
        out << "  " << std::left << std::setw(width) << "joint" << std::right;
        for (const char *title :
             {"peak [N]", "at [deg]", "mean [N]", "ringing [%]"})
          cell(title, 13);
        out << std::endl;
        for (const JointSummary &joint : joints)
          {
            out << "  " << std::left << std::setw(width) << joint.name
                << std::right << std::setprecision(5);
            cell(joint.peak_force, 13);
            cell(joint.peak_phase, 13);
            cell(joint.mean_force, 13);
            out << std::setprecision(2);
            cell(100. * joint.residual_ringing, 13);
            out << std::endl;
          }
      }



      // What a pin does in its bushing during the cycle.
      void
      print_contacts(std::ostream &out, const JointSummary &joint)
      {
        out << "  " << joint.name << ": " << std::fixed << std::setprecision(2)
            << 100. * joint.share_free << " % of the time in free flight, "
            << 100. * joint.share_impact << " % in impacts, "
            << 100. * joint.share_following << " % following the bore"
            << std::defaultfloat << std::endl
            << "    contact began " << joint.n_onsets << " and ended "
            << joint.n_losses << " times";
        if (joint.n_onsets > 0)
          out << ", approach at up to " << std::setprecision(3)
              << 1e3 * joint.max_approach_speed << " mm/s";
        out << std::endl;
      }



      // Of a motion that does not repeat.
      void
      print_averages(std::ostream &out, const RunSummary &summary)
      {
        out << "    averages and standard deviations over "
            << summary.dynamics.averaged_cycles << " cycles" << std::endl;
        for (const JointSummary &joint : summary.joints)
          out << "    " << joint.name << ": largest force "
              << std::setprecision(4) << joint.mean_peak_force << " +- "
              << std::setprecision(3) << joint.peak_force_deviation
              << " N, mean " << std::setprecision(4) << joint.mean_force
              << " +- " << std::setprecision(3) << joint.mean_force_deviation
              << " N" << std::endl;
      }



      void
      print_energy(std::ostream &out, const RunSummary &summary)
      {
        const DynamicsSummary &dynamics = summary.dynamics;
        // What is left over of a motion that neither takes nor gives energy.
        const auto without_noise = [&dynamics](const double energy) {
          return std::abs(energy) < 1e-10 * dynamics.max_kinetic_energy
                   ? 0.
                   : energy;
        };
        out << std::setprecision(5) << "  energy in the recorded cycle"
            << (dynamics.averaged_cycles > 1 ? "s" : "") << ": work "
            << without_noise(dynamics.work) << " J, dissipated "
            << without_noise(dynamics.dissipated) << " J; kinetic between "
            << dynamics.min_kinetic_energy << " and "
            << dynamics.max_kinetic_energy << " J" << std::endl;
        for (const JointSummary &joint : summary.joints)
          if (joint.has_contact_law)
            out << "    " << joint.name << ": friction " << joint.friction_loss
                << " J, hysteresis " << joint.normal_loss << " J" << std::endl;
        if (dynamics.damper_loss != 0.)
          out << "    dampers: " << dynamics.damper_loss << " J" << std::endl;
        if (dynamics.impact_loss != 0.)
          out << "    impacts: " << dynamics.impact_loss << " J" << std::endl;
        out << std::setprecision(2) << "    balance: relative error "
            << dynamics.energy_balance_relative_error << ", "
            << dynamics.energy_balance_relative_error_since_start
            << " since the start" << std::endl;
      }



      // The joints, and what the motion has cost.
      void
      print_dynamics(std::ostream &out, const RunSummary &summary)
      {
        print_joint_table(out, summary.joints);
        for (const JointSummary &joint : summary.joints)
          if (joint.has_clearance)
            print_contacts(out, joint);
        const DynamicsSummary &dynamics = summary.dynamics;
        if (dynamics.n_steps > 0)
          {
            out << "  motion: recorded in cycle ";
            if (dynamics.averaged_cycles > 1)
              out << dynamics.settling_cycles - dynamics.averaged_cycles + 1
                  << " to ";
            out << dynamics.settling_cycles;
            if (dynamics.settling_cycles > 1 && dynamics.averaged_cycles == 1)
              out << ", forces differ from those of the cycle before by "
                  << std::setprecision(2) << 100. * summary.settling_difference
                  << " %";
            out << std::endl
                << "    " << dynamics.n_steps << " integration steps ("
                << dynamics.n_steps_in_cycle << " per recorded cycle), "
                << dynamics.n_residuals << " residual and "
                << dynamics.n_jacobians << " Jacobian evaluations, "
                << dynamics.n_restarts << " restarts" << std::endl;
          }
        if (dynamics.averaged_cycles > 1)
          print_averages(out, summary);
        if (dynamics.has_energy)
          print_energy(out, summary);
      }



      void
      print_joints(std::ostream &out, const RunSummary &summary)
      {
        for (const JointSummary &joint : summary.joints)
          {
            out << "  " << joint.name << ": force in the cycle, largest "
                << std::setprecision(5) << joint.peak_force << " N, mean "
                << joint.mean_force << " N";
            if (joint.sliding_per_cycle > 0.)
              out << "; sliding " << joint.sliding_per_cycle * 1e3
                  << " mm per cycle";
            out << std::endl;
            if (joint.has_bushing)
              print_bushing(out, joint);
          }
      }
    } // namespace



    RunSummary
    make_run_summary(const CaseParameters            &parameters,
                     const RunState                  &state,
                     const std::list<WearingBushing> &bushings)
    {
      RunSummary summary;
      summary.case_name           = parameters.title;
      summary.cycles              = state.cycles;
      summary.is_dynamics_only    = parameters.cycles == 0;
      summary.wear_steps          = state.counts.wear_steps;
      summary.rate_evaluations    = state.counts.rate_evaluations;
      summary.dynamics_cycles     = state.counts.dynamics_cycles;
      summary.contact_solves      = state.counts.contact_solves;
      summary.constraint_drift    = state.constraint_drift;
      summary.all_settled         = state.all_settled;
      summary.settling_message    = state.settling_message;
      summary.settling_difference = state.duty_cycle.settling.repeat_difference;

      summary.dynamics = summarise_dynamics(state.duty_cycle);

      const Multibody::EnergyRecord &energy = state.duty_cycle.energy.cycle;
      Eigen::Index                   n_contact_laws = 0;
      for (std::size_t j = 0; j < state.duty_cycle.joints.size(); ++j)
        {
          const Multibody::JointDutyCycle &cycle = state.duty_cycle.joints[j];

          JointSummary joint = summarise_joint(cycle, state.duty_cycle.phase);
          if (cycle.has_contact_law && energy.has_work)
            {
              joint.normal_loss   = energy.normal_loss[n_contact_laws];
              joint.friction_loss = energy.friction_loss[n_contact_laws];
            }
          n_contact_laws += cycle.has_contact_law;
          if (cycle.has_gap)
            joint.sliding_per_cycle = cycle.sliding_distance();
          if (cycle.has_gap)
            {
              const Multibody::JointParameters &of_joint =
                parameters.joint(cycle.name);
              joint.mean_normal_force = cycle.mean_normal_force();
              joint.clearance         = of_joint.clearance();
              joint.contact_losses    = state.contact_losses[j];
            }

          std::size_t b = 0;
          for (const WearingBushing &bushing : bushings)
            {
              if (bushing.name() == cycle.name && b < state.contacts.size())
                {
                  joint.has_bushing = true;
                  joint.bushing     = summarise_bushing(bushing,
                                                    cycle,
                                                    state.contacts[b],
                                                    state.totals[b]);
                  joint.bushing.max_stable_wear_step = state.max_stable_step;
                  joint.pin       = summarise_pin(bushing, state.totals[b]);
                  joint.clearance = bushing.largest_clearance(bushing.depth());
                  if (b < state.mesh_errors.size())
                    joint.bushing.mesh_error = state.mesh_errors[b];
                  summary.compliance_builds += bushing.n_compliance_builds();
                  add_errors(bushing, joint, state.totals[b], summary);
                }
              ++b;
            }
          summary.joints.push_back(joint);
        }
      return summary;
    }



    void
    print_results(std::ostream &out, const RunSummary &summary)
    {
      const std::ios_base::fmtflags flags     = out.flags();
      const std::streamsize         precision = out.precision();

      out << std::endl
          << (summary.is_dynamics_only
                ? "Results of the dynamics"
                : "Results after " +
                    std::to_string(std::lround(summary.cycles)) + " cycles")
          << (summary.message.empty()
                ? ""
                : " (" + summary.status + ": " + summary.message + ")")
          << std::endl;
      if (summary.is_dynamics_only)
        print_dynamics(out, summary);
      else
        print_joints(out, summary);
      if (summary.wear_steps > 0)
        out << "  estimated error by the wear steps: depth "
            << std::setprecision(2)
            << 100. * summary.max_wear_depth_relative_error << " %, volume "
            << 100. * summary.worn_volume_relative_error << " %" << std::endl;
      if (summary.is_dynamics_only)
        {
          if (!summary.settling_message.empty())
            out << "  WARNING: " << summary.settling_message << "."
                << std::endl;
        }
      else
        {
          if (!summary.all_settled)
            out << "  WARNING: not every duty cycle settled: "
                << summary.settling_message << "." << std::endl;
          out << "  " << summary.wear_steps << " wear steps, "
              << summary.dynamics_cycles << " cycles of dynamics, "
              << summary.contact_solves << " contact problems, "
              << summary.compliance_builds << " compliance builds" << std::endl;
        }
      out << "  wall time " << std::setprecision(3) << summary.wall_time << " s"
          << std::endl;

      out.flags(flags);
      out.precision(precision);
    }
  } // namespace Coupling
} // namespace Tribody

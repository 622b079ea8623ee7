#include <tribody/base/units.h>
#include <tribody/coupling/run_summary.h>
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



      // The closed form knows one direction of the force and no elasticity:
      // contact within 45 deg of its mean direction, and wear deeper than the
      // clearance.
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



      Output::BushingSummary
      summarise_bushing(const WearingBushing            &bushing,
                        const Multibody::JointDutyCycle &cycle,
                        const CycleContact              &contact,
                        const BushingTotals             &totals)
      {
        const BushingParameters &parameters     = bushing.bushing_parameters();
        const Multibody::JointParameters &joint = bushing.joint_parameters();
        const Wear::WearProfile          &profile = bushing.profile();

        Output::BushingSummary summary;
        summary.max_wear_depth = profile.max_depth();
        summary.max_wear_angle = bushing.node_angles()[profile.deepest_node()];
        summary.worn_volume    = bushing.worn_volume();
        summary.worn_mass =
          summary.worn_volume * joint.bushing_material.density;
        summary.max_pressure       = contact.max_pressure;
        summary.contact_half_angle = contact.at_peak_force().half_angle;
        summary.mesh_oscillation   = Wear::mesh_oscillation(contact.wear_rate);
        if (totals.removed_volume > 0.)
          summary.volume_balance_relative_error =
            std::abs(summary.worn_volume / totals.removed_volume - 1.);
        summary.comparison = parameters.comparison;

        const double unworn = joint.bushing_radius - joint.pin_radius;
        if (crescent_applies(cycle, profile, unworn))
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



      // Of the deepest node.
      double
      relative_error(const Eigen::VectorXd   &depth_error,
                     const Wear::WearProfile &profile)
      {
        return profile.max_depth() > 0.
                 ? std::abs(depth_error[profile.deepest_node()]) /
                     profile.max_depth()
                 : 0.;
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
      print_bushing(std::ostream &out, const Output::JointSummary &joint)
      {
        const Output::BushingSummary &bushing = joint.bushing;
        out << "    bushing: maximum depth " << std::setprecision(4)
            << bushing.max_wear_depth * 1e3 << " mm at "
            << Units::degrees(bushing.max_wear_angle) << " deg, volume "
            << bushing.worn_volume * 1e9 << " mm^3, mass "
            << bushing.worn_mass * 1e3 << " g" << std::endl
            << "    contact: largest pressure " << bushing.max_pressure * 1e-6
            << " MPa, half-angle at the largest force "
            << Units::degrees(bushing.contact_half_angle) << " deg"
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
            << bushing.volume_balance_relative_error
            << ", mesh-size oscillation of the wear rate "
            << bushing.mesh_oscillation
            << ", losses of contact in the recorded cycles "
            << joint.contact_losses << std::endl;
      }
    } // namespace



    Output::RunSummary
    make_run_summary(const CaseParameters            &parameters,
                     const RunState                  &state,
                     const std::list<WearingBushing> &bushings)
    {
      Output::RunSummary summary;
      summary.case_name           = parameters.title;
      summary.cycles              = state.cycles;
      summary.wear_steps          = state.counts.wear_steps;
      summary.rate_evaluations    = state.counts.rate_evaluations;
      summary.dynamics_cycles     = state.counts.dynamics_cycles;
      summary.contact_solves      = state.counts.contact_solves;
      summary.constraint_drift    = state.constraint_drift;
      summary.all_settled         = state.all_settled;
      summary.settling_message    = state.settling_message;
      summary.settling_difference = state.duty_cycle.settling.repeat_difference;

      for (std::size_t j = 0; j < state.duty_cycle.joints.size(); ++j)
        {
          const Multibody::JointDutyCycle &cycle = state.duty_cycle.joints[j];

          Output::JointSummary joint;
          joint.name          = cycle.name;
          joint.has_clearance = cycle.has_clearance;
          joint.peak_force    = cycle.peak_force();
          joint.mean_force    = cycle.mean_force();
          if (cycle.has_clearance)
            joint.sliding_per_cycle = cycle.sliding_distance();
          if (cycle.has_clearance)
            {
              const Multibody::JointParameters &of_joint =
                parameters.joint(cycle.name);
              joint.mean_normal_force = cycle.mean_normal_force();
              joint.clearance = of_joint.bushing_radius - of_joint.pin_radius;
              joint.contact_losses = state.contact_losses[j];
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
                  joint.clearance += joint.bushing.max_wear_depth;
                  summary.compliance_builds += bushing.n_compliance_builds();
                  summary.max_wear_depth_relative_error =
                    std::max(summary.max_wear_depth_relative_error,
                             relative_error(state.totals[b].depth_error,
                                            bushing.profile()));
                }
              ++b;
            }
          summary.joints.push_back(joint);
        }
      return summary;
    }



    void
    print_results(std::ostream &out, const Output::RunSummary &summary)
    {
      const std::ios_base::fmtflags flags     = out.flags();
      const std::streamsize         precision = out.precision();

      out << std::endl
          << "Results after " << std::lround(summary.cycles) << " cycles"
          << (summary.message.empty()
                ? ""
                : " (" + summary.status + ": " + summary.message + ")")
          << std::endl;
      for (const Output::JointSummary &joint : summary.joints)
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
      if (summary.wear_steps > 0)
        out << "  estimated error of the depth by the wear steps: "
            << std::setprecision(2)
            << 100. * summary.max_wear_depth_relative_error << " %"
            << std::endl;
      if (!summary.all_settled)
        out << "  WARNING: not every duty cycle settled: "
            << summary.settling_message << "." << std::endl;
      out << "  " << summary.wear_steps << " wear steps, "
          << summary.dynamics_cycles << " cycles of dynamics, "
          << summary.contact_solves << " contact problems, "
          << summary.compliance_builds << " compliance builds; "
          << std::setprecision(3) << summary.wall_time << " s" << std::endl;

      out.flags(flags);
      out.precision(precision);
    }
  } // namespace Coupling
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/significant_digits.h>
#include <tribody/base/units.h>
#include <tribody/results/printed_summary.h>
#include <tribody/results/rating.h>
#include <tribody/results/warnings.h>

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
      // "+0.3 %": how much @p value differs from @p reference.
      std::string
      difference(const double value, const double reference)
      {
        std::ostringstream out;
        out << std::showpos << std::fixed << std::setprecision(2)
            << 100. * (value / reference - 1.) << " %";
        return out.str();
      }



      bool
      knows_mesh_error(const BushingResults &results, const RunState &state)
      {
        return results.number < state.mesh_errors.size() &&
               state.mesh_errors[results.number].covers_whole_run;
      }



      std::string
      describe_depth_error(const BushingResults &results, const RunState &state)
      {
        return significant_digits(100. * results.depth_relative_error(), 2) +
               (knows_mesh_error(results, state)
                  ? " %"
                  : " % and the unknown error of the mesh");
      }



      void
      print_surface(std::ostream         &out,
                    const char           *name,
                    const char           *frame,
                    const SurfaceResults &surface,
                    const std::string    &depth_error)
      {
        out << "    " << name << ": maximum depth " << std::setprecision(4)
            << surface.max_wear_depth * 1e3 << " mm";
        if (surface.max_wear_depth > 0.)
          out << " \u00b1 " << depth_error;
        out << " at " << Units::degrees(surface.max_wear_angle) << " deg"
            << frame << ", volume " << surface.worn_volume * 1e9
            << " mm^3, mass " << surface.worn_mass * 1e3 << " g" << std::endl;
        if (surface.archard_volume > 0.)
          out << "      k F s = " << surface.archard_volume * 1e9
              << " mm^3; the volume is "
              << surface.worn_volume / surface.archard_volume
              << " times that (1 for a narrow contact, 4/pi for one that has "
                 "worn in over half the bore)"
              << std::endl;
      }



      // Those of the joint; of all where it is empty.
      void
      print_warnings(std::ostream               &out,
                     const std::vector<Warning> &warnings,
                     const std::string          &joint)
      {
        for (const Warning &warning : warnings)
          if (warning.joint == joint)
            out << (joint.empty() ? "  " : "    ")
                << "WARNING: " << warning.message << "." << std::endl;
      }



      // The law that the motion is integrated with, and its constant.
      void
      print_contact_law(std::ostream                     &out,
                        const Multibody::JointParameters &joint)
      {
        const auto K =
          Multibody::find_hertz_stiffness(joint.contact_force_law.make(joint));
        out << "    contact force law: " << name_of(joint.contact_force_law);
        if (K)
          out << ", K = " << std::setprecision(4) << *K << " N/m^1.5 ("
              << name_of(joint.radii_combination) << " of the radii)";
        out << std::endl;
      }



      void
      print_references(std::ostream         &out,
                       const BushingResults &results,
                       const Comparison     &comparison)
      {
        const SurfaceResults &bushing = results.bushing;
        if (results.crescent)
          {
            const CrescentResults &crescent = *results.crescent;
            out << "    crescent closed form (stiff bushing, constant force "
                << crescent.normal_force
                << " N, the mean over the sliding distance): depth "
                << crescent.max_wear_depth * 1e3 << " mm (result "
                << difference(bushing.max_wear_depth, crescent.max_wear_depth)
                << "), volume " << crescent.worn_volume * 1e9
                << " mm^3 (result "
                << difference(bushing.worn_volume, crescent.worn_volume) << ")"
                << std::endl;
          }
        if (comparison.max_wear_depth > 0.)
          out << "    comparison: depth " << comparison.max_wear_depth * 1e3
              << " mm (result "
              << difference(bushing.max_wear_depth, comparison.max_wear_depth)
              << "), " << comparison.source << std::endl;
        if (comparison.worn_mass > 0.)
          out << "    comparison: mass " << comparison.worn_mass * 1e3
              << " g (result "
              << difference(bushing.worn_mass, comparison.worn_mass) << "), "
              << comparison.source << std::endl;
      }



      void
      print_mesh_error(std::ostream &out, const MeshError &mesh)
      {
        if (mesh.n_coarse_nodes > 0)
          out << "    mesh: with " << mesh.n_coarse_nodes << " instead of "
              << mesh.n_nodes
              << " bore nodes the largest pressure of the first cycle differs "
                 "by "
              << 100. * mesh.max_pressure << " %, the maximum depth of "
              << (mesh.covers_whole_run ? "the run" : "that cycle") << " by "
              << 100. * mesh.wear_depth << " %" << std::endl;
      }



      void
      print_heat(std::ostream &out, const Warmth &warmth)
      {
        const auto celsius = [](const double temperature) {
          return Units::to_string(temperature, "K", "degC", 4);
        };
        out << "    heat: friction " << significant_digits(warmth.power, 4)
            << " W";
        if (warmth.shaft_power > 0.)
          out << ", of which " << significant_digits(warmth.shaft_power, 3)
              << " W leave through the shaft";
        out << "; " << celsius(warmth.contact_temperature)
            << " in the contact, at most " << celsius(warmth.max_temperature)
            << ", bushing " << celsius(warmth.mean_temperature)
            << " in the mean, surroundings "
            << celsius(warmth.ambient_temperature)
            << "; pin and bore are nearer by "
            << significant_digits(1e3 * warmth.closing, 3) << " mm";
        if (warmth.out_of_round > 0.)
          out << "; uneven heat makes the bore out of round by "
              << significant_digits(1e3 * warmth.out_of_round, 2)
              << " mm, which is left out";
        out << std::endl;
      }



      void
      print_bushing(std::ostream            &out,
                    const BushingParameters &parameters,
                    const BushingResults    &results,
                    const RunState          &state,
                    const unsigned int       contact_losses)
      {
        const CycleContact &contact     = state.joints[results.number].contact;
        const std::string   depth_error = describe_depth_error(results, state);
        print_surface(out, "bushing", "", results.bushing, depth_error);
        out << "    contact (" << name_of(parameters.pressure_model)
            << "): largest pressure " << contact.max_pressure * 1e-6
            << " MPa, half-angle at the largest force "
            << Units::degrees(contact.at_peak_force().half_angle) << " deg"
            << std::endl;
        if (const Warmth &warmth = state.joints[results.number].warmth;
            warmth.is_known())
          print_heat(out, warmth);
        double balance = results.bushing.volume_balance_relative_error;
        if (results.pin)
          {
            print_surface(
              out, "pin", " of its own frame", *results.pin, depth_error);
            balance =
              std::max(balance, results.pin->volume_balance_relative_error);
          }
        print_references(out, results, parameters.comparison);
        out << std::setprecision(2) << "    checks: volume balance " << balance
            << ", mesh-size oscillation of the wear rate "
            << results.mesh_oscillation
            << ", losses of contact in the recorded cycles " << contact_losses
            << std::endl;
        if (results.number < state.mesh_errors.size())
          print_mesh_error(out, state.mesh_errors[results.number]);
        const Strains    &strains = state.joints[results.number].totals.strains;
        const std::string validity = describe(strains);
        if (!validity.empty() && strains.largest() <= Strains::doubtful)
          out << "    note: " << validity << std::endl;
      }



      // A table of the joints.
      void
      print_joint_table(std::ostream &out, const Multibody::DutyCycle &cycle)
      {
        std::size_t width = 6;
        for (const Multibody::JointDutyCycle &joint : cycle.joints)
          width = std::max(width, joint.name.size());
        const auto cell = [&out](const auto &value, const int columns) {
          out << std::setw(columns) << value;
        };
        out << "  " << std::left << std::setw(width) << "joint" << std::right;
        for (const char *title :
             {"peak [N]", "at [deg]", "mean [N]", "ringing [%]"})
          cell(title, 13);
        out << std::endl;
        for (const Multibody::JointDutyCycle &joint : cycle.joints)
          {
            out << "  " << std::left << std::setw(width) << joint.name
                << std::right << std::setprecision(5);
            cell(joint.peak_force(), 13);
            cell(cycle.phase[joint.peak_sample()], 13);
            cell(joint.mean_force(), 13);
            out << std::setprecision(2);
            cell(100. * joint.residual_ringing, 13);
            out << std::endl;
          }
      }



      // What a pin does in its bushing during the cycle.
      void
      print_contacts(std::ostream &out, const Multibody::JointDutyCycle &joint)
      {
        using Multibody::ContactState;
        out << "  " << joint.name << ": " << std::fixed << std::setprecision(2)
            << 100. * joint.share_of(ContactState::free)
            << " % of the time in free flight, "
            << 100. * joint.share_of(ContactState::impact) << " % in impacts, "
            << 100. * joint.share_of(ContactState::following)
            << " % following the bore" << std::defaultfloat << std::endl
            << "    contact began " << joint.n_onsets << " and ended "
            << joint.n_losses << " times";
        if (joint.n_onsets > 0)
          out << ", approach at up to " << std::setprecision(3)
              << 1e3 * joint.max_approach_speed() << " mm/s";
        out << std::endl;
      }



      void
      print_watched_paths(std::ostream               &out,
                          const LoadCase             &load_case,
                          const Multibody::DutyCycle &cycle)
      {
        for (const Multibody::WatchedPath &path : cycle.watched_paths)
          {
            // What Newton's method leaves in either position is no deviation.
            const double noise = 1e-12 * path.position.cwiseAbs().maxCoeff();
            out << "  " << path.name
                << (load_case.name.empty() ? "" : ", load case ")
                << load_case.name
                << ": deviation from the path with ideal joints";
            if (path.largest_deviation() > noise)
              out << ", largest " << std::setprecision(4)
                  << path.largest_deviation() * 1e3 << " mm at "
                  << cycle.phase[path.largest_sample()] << " deg, rms "
                  << path.rms_deviation() * 1e3 << " mm" << std::endl;
            else
              out << ": none" << std::endl;
          }
      }



      // Of a motion that does not repeat.
      void
      print_averages(std::ostream &out, const Multibody::DutyCycle &cycle)
      {
        out << "    averages and standard deviations over "
            << cycle.settling.n_averaged_cycles << " cycles" << std::endl;
        for (const Multibody::JointDutyCycle &joint : cycle.joints)
          out << "    " << joint.name << ": largest force "
              << std::setprecision(4) << joint.mean_peak_force << " +- "
              << std::setprecision(3) << joint.peak_force_deviation
              << " N, mean " << std::setprecision(4) << joint.mean_force()
              << " +- " << std::setprecision(3) << joint.mean_force_deviation
              << " N" << std::endl;
      }



      void
      print_energy(std::ostream &out, const Multibody::DutyCycle &cycle)
      {
        const Multibody::EnergyRecord &energy  = cycle.energy.cycle;
        const Eigen::VectorXd         &kinetic = cycle.energy.kinetic;
        // What is left over of a motion that neither takes nor gives energy.
        const auto without_noise = [&kinetic](const double value) {
          return std::abs(value) < 1e-10 * kinetic.maxCoeff() ? 0. : value;
        };
        out << std::setprecision(5) << "  energy in the recorded cycle"
            << (cycle.settling.n_averaged_cycles > 1 ? "s" : "") << ": work "
            << without_noise(energy.work()) << " J, dissipated "
            << without_noise(energy.dissipated()) << " J; kinetic between "
            << kinetic.minCoeff() << " and " << kinetic.maxCoeff() << " J"
            << std::endl;
        for (std::size_t j = 0; j < cycle.joints.size(); ++j)
          if (cycle.joints[j].has_contact_law)
            {
              const Eigen::Index law = cycle.contact_law_number(j);
              out << "    " << cycle.joints[j].name << ": friction "
                  << energy.friction_loss[law] << " J, hysteresis "
                  << energy.normal_loss[law] << " J" << std::endl;
            }
        if (energy.damper_loss != 0.)
          out << "    dampers: " << energy.damper_loss << " J" << std::endl;
        if (energy.impact_loss != 0.)
          out << "    impacts: " << energy.impact_loss << " J" << std::endl;
        out << std::setprecision(2) << "    balance: relative error "
            << cycle.energy.relative_error << ", "
            << cycle.energy.relative_error_since_start << " since the start"
            << std::endl;
      }



      // The joints, and what the motion has cost.
      void
      print_dynamics(std::ostream               &out,
                     const CaseParameters       &parameters,
                     const Multibody::DutyCycle &cycle,
                     const std::vector<Warning> &warnings)
      {
        print_joint_table(out, cycle);
        for (const Multibody::JointDutyCycle &joint : cycle.joints)
          {
            if (joint.has_gap)
              print_contacts(out, joint);
            if (joint.has_contact_law)
              print_contact_law(out, parameters.joint(joint.name));
            print_warnings(out, warnings, joint.name);
          }
        const Multibody::SettlingReport      &settling   = cycle.settling;
        const Sundials::IntegratorStatistics &statistics = cycle.statistics;
        if (statistics.n_steps > 0)
          {
            out << "  motion: recorded in cycle ";
            if (settling.n_averaged_cycles > 1)
              out << settling.n_cycles - settling.n_averaged_cycles + 1
                  << " to ";
            out << settling.n_cycles;
            if (settling.n_cycles > 1 && settling.n_averaged_cycles == 1)
              out << ", forces differ from those of the cycle before by "
                  << std::setprecision(2) << 100. * settling.repeat_difference
                  << " %";
            out << std::endl
                << "    " << statistics.n_steps << " integration steps ("
                << cycle.n_steps_in_cycle << " per recorded cycle), "
                << statistics.n_residuals << " residual and "
                << statistics.n_jacobians << " Jacobian evaluations, "
                << statistics.n_restarts() << " restarts" << std::endl;
          }
        if (settling.n_averaged_cycles > 1)
          print_averages(out, cycle);
        if (cycle.energy.cycle.has_work)
          print_energy(out, cycle);
      }



      // One after the other.
      void
      print_motions(std::ostream               &out,
                    const CaseParameters       &parameters,
                    const RunResults           &results,
                    const std::vector<Warning> &warnings)
      {
        const auto &cycles = results.state.duty_cycles;
        for (std::size_t i = 0; i < cycles.size(); ++i)
          {
            if (const LoadCase &load_case = parameters.load_cases[i];
                !load_case.name.empty())
              out << load_case.subsection() << std::endl;
            print_dynamics(out, parameters, cycles[i], warnings);
          }
      }



      // Beside the catalogue of the bushing's maker.
      void
      print_rating(std::ostream &out, const Rating &rating)
      {
        out << "    rating: projected pressure, mean and largest, "
            << significant_digits(1e-6 * rating.mean_pressure, 3) << " and "
            << significant_digits(1e-6 * rating.max_pressure, 3)
            << " MPa, speed " << significant_digits(rating.mean_speed, 3)
            << " and " << significant_digits(rating.max_speed, 3) << " m/s, pv "
            << significant_digits(1e-6 * rating.mean_pv, 3) << " and "
            << significant_digits(1e-6 * rating.max_pv, 3) << " MPa m/s"
            << std::endl;
      }



      // In a load case, which has a line of its own if it has a name.
      void
      print_load(std::ostream                    &out,
                 const std::string               &load_case,
                 const Multibody::JointDutyCycle &joint)
      {
        if (!load_case.empty())
          out << "    load case " << load_case << ":";
        out << " force in the cycle, largest " << std::setprecision(5)
            << joint.peak_force() << " N, mean " << joint.mean_force() << " N";
        if (joint.has_gap && joint.sliding_distance() > 0.)
          out << "; sliding " << joint.sliding_distance() * 1e3
              << " mm per cycle";
        out << std::endl;
      }



      // How long it lasted, and of which load cases.
      void
      print_duty(std::ostream         &out,
                 const CaseParameters &parameters,
                 const RunState       &state)
      {
        if (parameters.load_cases.front().name.empty() &&
            parameters.stop_at_time == 0.)
          return;
        constexpr double hour = 3600.;
        out << "  " << significant_digits(state.operating_time / hour, 5)
            << " h of operation";
        if (parameters.operating_share < 1.)
          out << " in "
              << significant_digits(state.operating_time / hour /
                                      parameters.operating_share,
                                    5)
              << " h";
        if (parameters.spectrum.has_blocks)
          out << ", "
              << significant_digits(state.cycles /
                                      parameters.spectrum.n_cycles(),
                                    5)
              << " blocks";
        for (std::size_t i = 0; i < state.duty_cycles.size(); ++i)
          if (const std::string &name = parameters.load_cases[i].name;
              !name.empty())
            out << (i == 0 ? ": " : ", ")
                << significant_digits(state.cycles_of_cases[i], 7)
                << " cycles of " << name;
        out << std::endl;
      }



      void
      print_joints(std::ostream               &out,
                   const CaseParameters       &parameters,
                   const RunResults           &results,
                   const std::vector<Warning> &warnings)
      {
        const auto &cycles = results.state.duty_cycles;
        for (std::size_t j = 0;
             !cycles.empty() && j < cycles.front().joints.size();
             ++j)
          {
            const Multibody::JointDutyCycle &joint = cycles.front().joints[j];
            const BushingResults *bushing = results.bushing(joint.name);
            out << "  " << joint.name << ":";
            if (cycles.size() > 1)
              out << std::endl;
            for (std::size_t i = 0; i < cycles.size(); ++i)
              {
                print_load(out,
                           parameters.load_cases[i].name,
                           cycles[i].joints[j]);
                if (bushing != nullptr)
                  print_rating(out,
                               rate(cycles[i].joints[j],
                                    cycles[i].period,
                                    parameters.bushings[bushing->number],
                                    parameters.joint(joint.name)));
              }
            if (bushing != nullptr)
              print_bushing(out,
                            parameters.bushings[bushing->number],
                            *bushing,
                            results.state,
                            results.state.dynamics.contact_losses[j]);
            if (joint.has_contact_law)
              print_contact_law(out, parameters.joint(joint.name));
            print_warnings(out, warnings, joint.name);
          }
      }



      // Those of the joint whose depth is known least, and of the volume.
      void
      print_errors(std::ostream &out, const RunResults &results)
      {
        const auto least_known =
          std::max_element(results.bushings.begin(),
                           results.bushings.end(),
                           [](const auto &a, const auto &b) {
                             return a.depth_relative_error() <
                                    b.depth_relative_error();
                           });
        const DutyErrors &motion = least_known->duty_errors;
        out << "  estimated error of the depth: " << std::setprecision(2)
            << 100. * results.depth_relative_error() << " % ("
            << least_known->name << ": wear steps "
            << 100. * least_known->step_error() << " %, mesh ";
        if (knows_mesh_error(*least_known, results.state))
          out << 100. * least_known->mesh_error << " %";
        else
          out << "unknown";
        out << ", samples " << 100. * motion.sampling << " %, motion "
            << 100. * (motion.inertia + motion.settling + motion.integration +
                       motion.creep)
            << " %); of the volume by the wear steps: "
            << 100. * results.volume_relative_error() << " %" << std::endl;
      }



      void
      print_motion_and_costs(std::ostream     &out,
                             const bool        is_dynamics_only,
                             const RunResults &results)
      {
        const RunCounts      &counts   = results.state.counts;
        const DynamicsTotals &dynamics = results.state.dynamics;
        if (counts.wear_steps > 0)
          print_errors(out, results);
        if (dynamics.all_settled && !dynamics.settling_message.empty())
          out << "  note: the dynamics " << dynamics.settling_message << "."
              << std::endl;
        if (!is_dynamics_only)
          out << "  " << counts.wear_steps << " wear steps, "
              << counts.dynamics_cycles << " cycles of dynamics, "
              << counts.contact_solves << " contact problems, "
              << counts.compliance_builds << " compliance builds" << std::endl;
        out << "  wall time " << std::setprecision(3) << results.wall_time
            << " s" << std::endl;
      }
    } // namespace



    void
    print_results(std::ostream         &out,
                  const CaseParameters &parameters,
                  const RunResults     &results)
    {
      const std::ios_base::fmtflags flags     = out.flags();
      const std::streamsize         precision = out.precision();

      const bool is_dynamics_only = parameters.cycles == 0;
      out << std::endl
          << (is_dynamics_only
                ? "Results of the dynamics"
                : "Results after " +
                    std::to_string(std::lround(results.state.cycles)) +
                    " cycles")
          << (results.message.empty()
                ? ""
                : " (" + name_of(results.status) + ": " + results.message + ")")
          << std::endl;
      const std::vector<Warning> warnings = find_warnings(parameters, results);
      if (is_dynamics_only)
        print_motions(out, parameters, results, warnings);
      else
        {
          print_duty(out, parameters, results.state);
          print_joints(out, parameters, results, warnings);
        }
      for (std::size_t i = 0; i < results.state.duty_cycles.size(); ++i)
        print_watched_paths(out,
                            parameters.load_cases[i],
                            results.state.duty_cycles[i]);
      print_warnings(out, warnings, "");
      print_motion_and_costs(out, is_dynamics_only, results);

      out.flags(flags);
      out.precision(precision);
    }
  } // namespace Coupling
} // namespace Tribody

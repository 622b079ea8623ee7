// SPDX-License-Identifier: LGPL-2.1-or-later

#include <nlohmann/json.hpp>

#include <tribody/base/units.h>
#include <tribody/base/version.h>
#include <tribody/base/whole_file.h>
#include <tribody/results/rating.h>
#include <tribody/results/summary_json.h>
#include <tribody/results/warnings.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // Keeps the order in which entries are added.
      using Json = nlohmann::ordered_json;

      Json
      surface_to_json(const SurfaceResults &surface)
      {
        Json json = {{"max_wear_depth_m", surface.max_wear_depth},
                     {"max_wear_angle_deg",
                      Units::degrees(surface.max_wear_angle)},
                     {"worn_volume_m3", surface.worn_volume},
                     {"worn_mass_kg", surface.worn_mass}};
        if (surface.archard_volume > 0.)
          {
            json["k_F_s_m3"] = surface.archard_volume;
            json["worn_volume_over_k_F_s"] =
              surface.worn_volume / surface.archard_volume;
          }
        return json;
      }



      Json
      bushing_to_json(const BushingResults    &results,
                      const BushingParameters &parameters,
                      const StepperState      &stepper)
      {
        Json json                          = surface_to_json(results.bushing);
        json["wear_rate_mesh_oscillation"] = results.mesh_oscillation;
        if (results.crescent)
          json["crescent_closed_form"] = {
            {"normal_force_N", results.crescent->normal_force},
            {"max_wear_depth_m", results.crescent->max_wear_depth},
            {"worn_volume_m3", results.crescent->worn_volume}};
        if (stepper.max_stable_step > 0. &&
            stepper.max_stable_step < std::numeric_limits<double>::max())
          json["max_stable_wear_step_cycles"] = stepper.max_stable_step;
        const Comparison &comparison = parameters.comparison;
        if (!comparison.source.empty())
          json["comparison"] = {{"source", comparison.source},
                                {"max_wear_depth_m", comparison.max_wear_depth},
                                {"worn_mass_kg", comparison.worn_mass}};
        return json;
      }



      Json
      pin_to_json(const std::optional<SurfaceResults> &pin)
      {
        if (!pin)
          return surface_to_json({});
        Json json = surface_to_json(*pin);
        json["volume_balance_relative_error"] =
          pin->volume_balance_relative_error;
        const auto relative = [](const double error, const double value) {
          return value > 0. ? error / value : 0.;
        };
        json["error_estimate"] = {
          {"max_wear_depth_relative",
           relative(pin->depth_error, pin->max_wear_depth)},
          {"worn_volume_relative",
           relative(pin->volume_error, pin->worn_volume)}};
        return json;
      }



      // Forces and motion of a joint that has a clearance.
      void
      add_clearance_to_json(Json                            &json,
                            const Multibody::JointDutyCycle &cycle,
                            const double                     clearance,
                            const unsigned int               contact_losses)
      {
        using Multibody::ContactState;
        json["mean_normal_force_N"]      = cycle.mean_normal_force();
        json["sliding_per_cycle_m"]      = cycle.sliding_distance();
        json["clearance_m"]              = clearance;
        json["contact_losses"]           = contact_losses;
        json["peak_force_since_start_N"] = cycle.peak_force_since_start;
        json["state_shares"]             = {
                      {"free", cycle.share_of(ContactState::free)},
                      {"impact", cycle.share_of(ContactState::impact)},
                      {"following", cycle.share_of(ContactState::following)}};
        json["contacts_in_cycle"] = {{"onsets", cycle.n_onsets},
                                     {"losses", cycle.n_losses},
                                     {"max_approach_speed_m_s",
                                      cycle.max_approach_speed()}};
      }



      // The parts of the estimated error of the depth, relative.
      Json
      depth_errors_to_json(const BushingResults &bushing)
      {
        return {{"wear_steps", bushing.step_error()},
                {"mesh", bushing.mesh_error},
                {"samples", bushing.duty_errors.sampling},
                {"inertia_of_following_pins", bushing.duty_errors.inertia},
                {"settling", bushing.duty_errors.settling},
                {"integration", bushing.duty_errors.integration},
                {"creep_of_friction", bushing.duty_errors.creep},
                {"sum", bushing.depth_relative_error()}};
      }



      Json
      contact_law_to_json(const Multibody::JointParameters &joint)
      {
        Json json = {{"name", name_of(joint.contact_force_law)}};
        if (const auto K = Multibody::find_hertz_stiffness(
              joint.contact_force_law.make(joint)))
          {
            json["K_N_m-1.5"] = *K;
            json["radii"]     = name_of(joint.radii_combination);
          }
        return json;
      }



      Json
      warnings_to_json(const CaseParameters &parameters,
                       const RunResults     &results)
      {
        Json json = Json::array();
        for (const Warning &warning : find_warnings(parameters, results))
          json.push_back({{"code", warning.code},
                          {"joint", warning.joint},
                          {"message", warning.message}});
        return json;
      }



      Json
      heat_to_json(const Warmth &warmth, const double max_temperature_so_far)
      {
        return {{"friction_power_W", warmth.power},
                {"shaft_power_W", warmth.shaft_power},
                {"ambient_temperature_K", warmth.ambient_temperature},
                {"contact_temperature_K", warmth.contact_temperature},
                {"max_temperature_K", warmth.max_temperature},
                {"max_temperature_so_far_K", max_temperature_so_far},
                {"mean_temperature_K", warmth.mean_temperature},
                {"closing_m", warmth.closing},
                {"out_of_round_m", warmth.out_of_round},
                {"residual_K", warmth.residual}};
      }



      Json
      rating_to_json(const Rating &rating)
      {
        return {{"mean_pressure_Pa", rating.mean_pressure},
                {"max_pressure_Pa", rating.max_pressure},
                {"mean_speed_m_s", rating.mean_speed},
                {"max_speed_m_s", rating.max_speed},
                {"mean_pv_Pa_m_s", rating.mean_pv},
                {"max_pv_Pa_m_s", rating.max_pv}};
      }



      // What a joint has come to by its wear.
      Json
      wear_to_json(const CaseParameters &parameters,
                   const RunResults     &results,
                   const BushingResults &bushing)
      {
        const RunState          &state = results.state;
        const BushingParameters &of_bushing =
          parameters.bushings[bushing.number];
        const CycleContact &contact = state.joints[bushing.number].contact;
        const Strains &strains = state.joints[bushing.number].totals.strains;

        Json json;
        json["bushing"] = bushing_to_json(bushing, of_bushing, state.stepper);
        json["pin"]     = pin_to_json(bushing.pin);
        json["pressure_model"]  = name_of(of_bushing.pressure_model);
        json["max_pressure_Pa"] = contact.max_pressure;
        json["contact_half_angle_deg"] =
          Units::degrees(contact.at_peak_force().half_angle);
        json["volume_balance_relative_error"] =
          bushing.bushing.volume_balance_relative_error;
        json["depth_error"] = depth_errors_to_json(bushing);
        json["validity"]    = {{"pressure_over_modulus", strains.pressure},
                               {"penetration_over_wall", strains.displacement},
                               {"message", describe(strains)}};
        if (const Warmth &warmth = state.joints[bushing.number].warmth;
            warmth.is_known())
          json["heat"] =
            heat_to_json(warmth,
                         state.joints[bushing.number].totals.max_temperature);
        return json;
      }



      // What a joint does in the duty cycle of a load case.
      void
      add_duty_to_json(Json                       &json,
                       const CaseParameters       &parameters,
                       const RunResults           &results,
                       const Multibody::DutyCycle &cycles,
                       const std::size_t           j)
      {
        const Multibody::JointDutyCycle &cycle   = cycles.joints[j];
        const BushingResults            *bushing = results.bushing(cycle.name);
        json["peak_force_N"]                     = cycle.peak_force();
        json["peak_force_phase_deg"] = cycles.phase[cycle.peak_sample()];
        json["mean_force_N"]         = cycle.mean_force();
        json["residual_ringing"]     = cycle.residual_ringing;
        if (cycles.is_quasi_static && cycle.has_gap)
          json["neglected_inertia"] = cycle.neglected_inertia;
        if (cycle.mean_peak_force > 0.)
          {
            json["mean_peak_force_N"]      = cycle.mean_peak_force;
            json["peak_force_deviation_N"] = cycle.peak_force_deviation;
            json["mean_force_deviation_N"] = cycle.mean_force_deviation;
          }
        if (!cycle.has_gap)
          return;
        const Multibody::JointParameters &joint = parameters.joint(cycle.name);
        add_clearance_to_json(json,
                              cycle,
                              bushing != nullptr ? bushing->clearance
                                                 : joint.clearance(),
                              results.state.dynamics.contact_losses[j]);
        if (const BushingParameters *rated = parameters.bushing(cycle.name))
          json["rating"] =
            rating_to_json(rate(cycle, cycles.period, *rated, joint));
        if (cycle.has_contact_law)
          json["contact_law"] = contact_law_to_json(joint);
        if (cycle.creep_distance > 0.)
          json["creep_per_cycle_m"] = cycle.creep_distance;
        if (cycles.energy.cycle.has_work && cycle.has_contact_law)
          {
            const Eigen::Index law  = cycles.contact_law_number(j);
            json["normal_loss_J"]   = cycles.energy.cycle.normal_loss[law];
            json["friction_loss_J"] = cycles.energy.cycle.friction_loss[law];
          }
      }



      // Wear, and, where there is one load case, what the joint does in it.
      Json
      joints_to_json(const CaseParameters &parameters,
                     const RunResults     &results)
      {
        Json        joints = Json::object();
        const auto &cycles = results.state.duty_cycles;
        for (std::size_t j = 0;
             !cycles.empty() && j < cycles.front().joints.size();
             ++j)
          {
            const std::string    &name    = cycles.front().joints[j].name;
            const BushingResults *bushing = results.bushing(name);
            Json                  json    = bushing != nullptr
                                              ? wear_to_json(parameters, results, *bushing)
                                              : Json::object();
            if (bushing != nullptr)
              json["sliding_distance_m"] =
                results.state.joints[bushing->number].totals.sliding_distance;
            if (cycles.size() == 1)
              add_duty_to_json(json, parameters, results, cycles.front(), j);
            joints[name] = json;
          }
        return joints;
      }



      Json
      watched_path_to_json(const Multibody::WatchedPath &path,
                           const Multibody::DutyCycle   &cycle)
      {
        return {{"largest_deviation_m", path.largest_deviation()},
                {"largest_deviation_phase_deg",
                 cycle.phase[path.largest_sample()]},
                {"rms_deviation_m", path.rms_deviation()}};
      }



      void
      add_watched_paths_to_json(Json &json, const Multibody::DutyCycle &cycle)
      {
        for (const Multibody::WatchedPath &path : cycle.watched_paths)
          json["watched_markers"][path.name] =
            watched_path_to_json(path, cycle);
      }



      // What the mesh does to the bushings, as far as it is known.
      Json
      mesh_errors_to_json(const RunResults &results)
      {
        Json json = Json::object();
        for (const BushingResults &bushing : results.bushings)
          if (bushing.number < results.state.mesh_errors.size())
            {
              const MeshError &error =
                results.state.mesh_errors[bushing.number];
              if (error.n_coarse_nodes > 0)
                json[bushing.name] = {
                  {"max_pressure_relative", error.max_pressure},
                  {"max_wear_depth_relative", error.wear_depth},
                  {"bore_nodes", error.n_nodes},
                  {"compared_with_bore_nodes", error.n_coarse_nodes},
                  {"depth_covers",
                   error.covers_whole_run ? "whole run" : "first cycle"}};
            }
        return json;
      }



      // Where the mesh is not followed for the whole run, its error is unknown.
      std::string
      covered_errors(const RunResults &results)
      {
        const auto &errors = results.state.mesh_errors;
        const bool  covers_mesh =
          !errors.empty() &&
          std::all_of(errors.begin(), errors.end(), [](const MeshError &error) {
            return error.covers_whole_run;
          });
        return std::string("wear steps, samples, motion") +
               (covers_mesh ? ", mesh" : "");
      }



      Json
      totals_to_json(const DynamicsTotals &totals)
      {
        return {{"constraint_drift_m", totals.constraint_drift},
                {"settled", totals.all_settled},
                {"message", totals.settling_message}};
      }



      // The last motion of a load case; of a run that has one, all of them.
      Json
      dynamics_to_json(const LoadCase             &load_case,
                       const Multibody::DutyCycle &cycle,
                       const DynamicsTotals       &totals)
      {
        const Multibody::SettlingReport      &settling   = cycle.settling;
        const Sundials::IntegratorStatistics &statistics = cycle.statistics;

        const char *motion = "dynamic";
        if (load_case.given_duty_cycle)
          motion = "given";
        else if (cycle.is_quasi_static)
          motion = "quasi-static";
        Json json = {{"joint_motion", motion}};
        json.update(totals_to_json(totals));
        json.update(
          Json{{"settling_relative_difference", settling.repeat_difference},
               {"settling_cycles", settling.n_cycles},
               {"averaged_cycles", settling.n_averaged_cycles},
               {"integration_steps", statistics.n_steps},
               {"integration_steps_in_cycle", cycle.n_steps_in_cycle},
               {"residual_evaluations", statistics.n_residuals},
               {"jacobian_evaluations", statistics.n_jacobians},
               {"restarts", statistics.n_restarts()}});
        if (std::isfinite(settling.distance))
          json["settling_distance"] = settling.distance;
        const Multibody::EnergyRecord &energy = cycle.energy.cycle;
        if (energy.has_work)
          {
            json["work_in_cycle_J"]               = energy.work();
            json["dissipated_in_cycle_J"]         = energy.dissipated();
            json["damper_loss_in_cycle_J"]        = energy.damper_loss;
            json["impact_loss_in_cycle_J"]        = energy.impact_loss;
            json["energy_balance_relative_error"] = cycle.energy.relative_error;
            json["energy_balance_relative_error_since_start"] =
              cycle.energy.relative_error_since_start;
          }
        return json;
      }



      // Time and load cases; a case without them has one without a name.
      void
      add_load_cases_to_json(Json                 &json,
                             const CaseParameters &parameters,
                             const RunResults     &results)
      {
        const RunState &state    = results.state;
        json["operating_time_s"] = state.operating_time;
        json["time_with_standstill_s"] =
          state.operating_time / parameters.operating_share;
        if (state.duty_cycles.size() == 1)
          add_watched_paths_to_json(json, state.duty_cycles.front());
        if (parameters.load_cases.size() < 2)
          return;
        if (parameters.spectrum.has_blocks)
          json["blocks"] = state.cycles / parameters.spectrum.n_cycles();
        for (std::size_t i = 0; i < state.duty_cycles.size(); ++i)
          {
            const Multibody::DutyCycle &cycle = state.duty_cycles[i];
            Json of_case = {{"cycles", state.cycles_of_cases[i]},
                            {"period_s", cycle.period},
                            {"joints", Json::object()},
                            {"dynamics",
                             dynamics_to_json(parameters.load_cases[i],
                                              cycle,
                                              {{},
                                               cycle.constraint_drift,
                                               cycle.settling.converged,
                                               cycle.settling.message,
                                               ""})}};
            for (std::size_t j = 0; j < cycle.joints.size(); ++j)
              {
                Json joint = Json::object();
                add_duty_to_json(joint, parameters, results, cycle, j);
                of_case["joints"][cycle.joints[j].name] = joint;
              }
            add_watched_paths_to_json(of_case, cycle);
            json["load_cases"][parameters.load_cases[i].name] = of_case;
          }
      }
    } // namespace



    void
    write_summary_json(const std::string    &file_name,
                       const CaseParameters &parameters,
                       const RunResults     &results)
    {
      const RunState &state = results.state;

      Json json = {{"program",
                    {{"name", "tribody"},
                     {"version", program_version()},
                     {"git", program_revision()},
                     {"libraries", library_versions()}}},
                   {"case", parameters.title},
                   {"status", name_of(results.status)},
                   {"message", results.message},
                   {"warnings", warnings_to_json(parameters, results)},
                   {"cycles", state.cycles},
                   {"wall_time_s", results.wall_time},
                   {"cpu_time_s", results.cpu_time},
                   {"peak_memory_bytes",
                    static_cast<unsigned long long>(results.peak_memory_bytes)},
                   {"counts",
                    {{"wear_steps", state.counts.wear_steps},
                     {"rate_evaluations", state.counts.rate_evaluations},
                     {"dynamics_cycles", state.counts.dynamics_cycles},
                     {"contact_solves", state.counts.contact_solves},
                     {"compliance_builds", state.counts.compliance_builds}}},
                   {"joints", joints_to_json(parameters, results)},
                   {"dynamics",
                    parameters.load_cases.size() > 1
                      ? totals_to_json(state.dynamics)
                      : dynamics_to_json(parameters.load_cases.front(),
                                         state.duty_cycles.empty()
                                           ? Multibody::DutyCycle()
                                           : state.duty_cycles.front(),
                                         state.dynamics)},
                   {"error_estimate",
                    {{"max_wear_depth_relative",
                      results.depth_relative_error()},
                     {"worn_volume_relative", results.volume_relative_error()},
                     {"covers", covered_errors(results)},
                     {"mesh", mesh_errors_to_json(results)}}}};
      if (state.counts.temperature_rounds > 0)
        json["counts"]["temperature_rounds"] = state.counts.temperature_rounds;
      add_load_cases_to_json(json, parameters, results);

      // Text from the parameter file may be in any encoding.
      const std::string text =
        json.dump(2, ' ', false, Json::error_handler_t::replace);
      write_whole_file(file_name,
                       [&text](std::ostream &file) { file << text << '\n'; });
    }
  } // namespace Coupling
} // namespace Tribody

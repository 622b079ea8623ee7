// SPDX-License-Identifier: LGPL-2.1-or-later

#include <nlohmann/json.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/base/units.h>
#include <tribody/base/version.h>
#include <tribody/results/summary.h>

#include <cmath>
#include <fstream>
#include <limits>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // Keeps the order in which entries are added.
      using Json = nlohmann::ordered_json;

      Json
      bushing_to_json(const BushingSummary &bushing)
      {
        Json json = {{"max_wear_depth_m", bushing.max_wear_depth},
                     {"max_wear_angle_deg",
                      Units::degrees(bushing.max_wear_angle)},
                     {"worn_volume_m3", bushing.worn_volume},
                     {"worn_mass_kg", bushing.worn_mass},
                     {"wear_rate_mesh_oscillation", bushing.mesh_oscillation}};
        if (bushing.crescent_max_wear_depth > 0.)
          json["crescent_closed_form"] = {
            {"normal_force_N", bushing.crescent_normal_force},
            {"max_wear_depth_m", bushing.crescent_max_wear_depth},
            {"worn_volume_m3", bushing.crescent_worn_volume}};
        if (bushing.max_stable_wear_step > 0. &&
            bushing.max_stable_wear_step < std::numeric_limits<double>::max())
          json["max_stable_wear_step_cycles"] = bushing.max_stable_wear_step;
        if (!bushing.comparison.source.empty())
          json["comparison"] = {{"source", bushing.comparison.source},
                                {"max_wear_depth_m",
                                 bushing.comparison.max_wear_depth},
                                {"worn_mass_kg", bushing.comparison.worn_mass}};
        return json;
      }



      Json
      pin_to_json(const PinSummary &pin)
      {
        Json json = {{"max_wear_depth_m", pin.max_wear_depth},
                     {"max_wear_angle_deg", Units::degrees(pin.max_wear_angle)},
                     {"worn_volume_m3", pin.worn_volume},
                     {"worn_mass_kg", pin.worn_mass}};
        if (pin.wears)
          {
            json["volume_balance_relative_error"] =
              pin.volume_balance_relative_error;
            json["error_estimate"] = {
              {"max_wear_depth_relative", pin.max_wear_depth_relative_error},
              {"worn_volume_relative", pin.worn_volume_relative_error}};
          }
        return json;
      }



      Json
      joint_to_json(const JointSummary &joint, const bool has_energy)
      {
        Json json = Json::object();
        if (joint.has_bushing)
          {
            json["bushing"]         = bushing_to_json(joint.bushing);
            json["pin"]             = pin_to_json(joint.pin);
            json["pressure_model"]  = joint.bushing.pressure_model;
            json["max_pressure_Pa"] = joint.bushing.max_pressure;
            json["contact_half_angle_deg"] =
              Units::degrees(joint.bushing.contact_half_angle);
            json["volume_balance_relative_error"] =
              joint.bushing.volume_balance_relative_error;
          }
        json["peak_force_N"]         = joint.peak_force;
        json["peak_force_phase_deg"] = joint.peak_phase;
        json["mean_force_N"]         = joint.mean_force;
        json["residual_ringing"]     = joint.residual_ringing;
        if (joint.mean_peak_force > 0.)
          {
            json["mean_peak_force_N"]      = joint.mean_peak_force;
            json["peak_force_deviation_N"] = joint.peak_force_deviation;
            json["mean_force_deviation_N"] = joint.mean_force_deviation;
          }
        if (joint.has_clearance)
          {
            json["mean_normal_force_N"]      = joint.mean_normal_force;
            json["sliding_per_cycle_m"]      = joint.sliding_per_cycle;
            json["clearance_m"]              = joint.clearance;
            json["contact_losses"]           = joint.contact_losses;
            json["peak_force_since_start_N"] = joint.peak_force_since_start;
            json["state_shares"]             = {{"free", joint.share_free},
                                                {"impact", joint.share_impact},
                                                {"following", joint.share_following}};
            json["contacts_in_cycle"]        = {{"onsets", joint.n_onsets},
                                                {"losses", joint.n_losses},
                                                {"max_approach_speed_m_s",
                                                 joint.max_approach_speed}};
            if (has_energy && joint.has_contact_law)
              {
                json["normal_loss_J"]   = joint.normal_loss;
                json["friction_loss_J"] = joint.friction_loss;
              }
          }
        return json;
      }



      // What the mesh does to the bushings, as far as it is known.
      Json
      mesh_errors_to_json(const std::vector<JointSummary> &joints)
      {
        Json json = Json::object();
        for (const JointSummary &joint : joints)
          {
            const MeshError &error = joint.bushing.mesh_error;
            if (error.n_coarse_nodes > 0)
              json[joint.name] = {
                {"max_pressure_relative", error.max_pressure},
                {"max_wear_depth_relative", error.wear_depth},
                {"bore_nodes", error.n_nodes},
                {"compared_with_bore_nodes", error.n_coarse_nodes},
                {"depth_covers",
                 error.covers_whole_run ? "whole run" : "first cycle"}};
          }
        return json;
      }



      Json
      dynamics_to_json(const RunSummary &summary)
      {
        const DynamicsSummary &dynamics = summary.dynamics;

        Json json = {{"constraint_drift_m", summary.constraint_drift},
                     {"settled", summary.all_settled},
                     {"message", summary.settling_message},
                     {"settling_relative_difference",
                      summary.settling_difference},
                     {"settling_cycles", dynamics.settling_cycles},
                     {"averaged_cycles", dynamics.averaged_cycles},
                     {"integration_steps", dynamics.n_steps},
                     {"integration_steps_in_cycle", dynamics.n_steps_in_cycle},
                     {"residual_evaluations", dynamics.n_residuals},
                     {"jacobian_evaluations", dynamics.n_jacobians},
                     {"restarts", dynamics.n_restarts}};
        if (dynamics.has_energy)
          {
            json["work_in_cycle_J"]        = dynamics.work;
            json["dissipated_in_cycle_J"]  = dynamics.dissipated;
            json["damper_loss_in_cycle_J"] = dynamics.damper_loss;
            json["impact_loss_in_cycle_J"] = dynamics.impact_loss;
            json["energy_balance_relative_error"] =
              dynamics.energy_balance_relative_error;
            json["energy_balance_relative_error_since_start"] =
              dynamics.energy_balance_relative_error_since_start;
          }
        return json;
      }
    } // namespace



    void
    write_summary_json(const std::string &file_name, const RunSummary &summary)
    {
      Json json = {
        {"program",
         {{"name", "tribody"},
          {"version", program_version()},
          {"git", program_revision()},
          {"libraries", library_versions()}}},
        {"case", summary.case_name},
        {"status", summary.status},
        {"message", summary.message},
        {"cycles", summary.cycles},
        {"wall_time_s", summary.wall_time},
        {"cpu_time_s", summary.cpu_time},
        {"peak_memory_bytes",
         static_cast<unsigned long long>(summary.peak_memory_bytes)},
        {"counts",
         {{"wear_steps", summary.wear_steps},
          {"rate_evaluations", summary.rate_evaluations},
          {"dynamics_cycles", summary.dynamics_cycles},
          {"contact_solves", summary.contact_solves},
          {"compliance_builds", summary.compliance_builds}}},
        {"joints", Json::object()},
        {"dynamics", dynamics_to_json(summary)},
        {"error_estimate",
         {{"max_wear_depth_relative", summary.max_wear_depth_relative_error},
          {"worn_volume_relative", summary.worn_volume_relative_error},
          {"covers", "wear steps"},
          {"mesh", mesh_errors_to_json(summary.joints)}}}};
      for (const JointSummary &joint : summary.joints)
        json["joints"][joint.name] =
          joint_to_json(joint, summary.dynamics.has_energy);

      // Text from the parameter file may be in any encoding.
      const std::string text =
        json.dump(2, ' ', false, Json::error_handler_t::replace);
      std::ofstream file(file_name);
      file << text << std::endl;
      AssertThrow(file, ExcRun("Cannot write '" + file_name + "'."));
    }
  } // namespace Coupling
} // namespace Tribody

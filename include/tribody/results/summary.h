// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_results_summary_h
#define tribody_results_summary_h

#include <tribody/bushing/bushing_parameters.h>
#include <tribody/stepping/mesh_error.h>

#include <string>
#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    /// What a run says of one bushing; SI units, angles in the bushing's frame.
    struct BushingSummary
    {
      double max_wear_depth = 0.;
      double max_wear_angle = 0.; ///< [rad]
      double worn_volume    = 0.;
      double worn_mass      = 0.;
      /// How the bushing gives way to the pin.
      std::string pressure_model;
      double      max_pressure                  = 0.;
      double      contact_half_angle            = 0.; ///< [rad]
      double      mesh_oscillation              = 0.; ///< of the wear rate [-]
      double      volume_balance_relative_error = 0.;
      /// The closed form, where it applies; else zero.
      double     crescent_normal_force   = 0.;
      double     crescent_max_wear_depth = 0.;
      double     crescent_worn_volume    = 0.;
      double     max_stable_wear_step    = 0.; ///< [cycles]
      MeshError  mesh_error;
      Comparison comparison;
    };

    /// What a run says of one pin; SI units, angles in the pin's frame.
    struct PinSummary
    {
      bool   wears                         = false;
      double max_wear_depth                = 0.;
      double max_wear_angle                = 0.; ///< [rad]
      double worn_volume                   = 0.;
      double worn_mass                     = 0.;
      double volume_balance_relative_error = 0.;
      /// Estimated relative errors left by the wear steps [-].
      double max_wear_depth_relative_error = 0.;
      double worn_volume_relative_error    = 0.;
    };

    /// What a run says of one joint; forces of the last duty cycle.
    struct JointSummary
    {
      std::string name;
      bool        has_clearance     = false;
      bool        has_contact_law   = false; ///< else the pin is rigid
      bool        has_bushing       = false;
      double      peak_force        = 0.;
      double      peak_phase        = 0.; ///< where that occurs [deg]
      double      mean_force        = 0.;
      double      mean_normal_force = 0.;
      /// If several cycles were averaged: mean of their peak forces, and the
      /// standard deviations from cycle to cycle [N].
      double       mean_peak_force      = 0.;
      double       peak_force_deviation = 0.;
      double       mean_force_deviation = 0.;
      double       sliding_per_cycle    = 0.;
      double       clearance            = 0.; ///< largest, worn [m]
      unsigned int contact_losses       = 0;  ///< in all recorded cycles
      /// Of the last recorded cycle, parts of its time: free flight, impacts,
      /// lasting contact.
      double share_free      = 0.;
      double share_impact    = 0.;
      double share_following = 1.;
      /// Contacts that began and ended in it, and the largest approach speed of
      /// those that began [m/s].
      unsigned int n_onsets           = 0;
      unsigned int n_losses           = 0;
      double       max_approach_speed = 0.;
      /// Largest force since the start of the motion [N].
      double peak_force_since_start = 0.;
      double residual_ringing       = 0.; ///< relative to the peak [-]
      /// Energy that the contact takes in a cycle [J], if known.
      double         normal_loss   = 0.;
      double         friction_loss = 0.;
      BushingSummary bushing;
      PinSummary     pin;
    };

    /// What a run says of its last cycle of dynamics as a whole.
    struct DynamicsSummary
    {
      /// Cycles until the motion repeated, the recorded one included.
      unsigned int settling_cycles = 0;
      /// Cycles that the results are over; more than one if it did not repeat.
      unsigned int averaged_cycles = 1;
      /// Integration: of the whole motion, and steps of the recorded cycle.
      unsigned long n_steps          = 0;
      unsigned long n_steps_in_cycle = 0;
      unsigned long n_residuals      = 0;
      unsigned long n_jacobians      = 0;
      unsigned long n_restarts       = 0;
      /// Whether the energies below are known.
      bool has_energy = false;
      /// Work of drivers and forces, and what was dissipated, in the recorded
      /// cycle [J].
      double work        = 0.;
      double dissipated  = 0.;
      double damper_loss = 0.;
      double impact_loss = 0.; ///< where velocities jump
      /// Smallest and largest at the samples of the recorded cycle [J].
      double min_kinetic_energy = 0.;
      double max_kinetic_energy = 0.;
      /// Largest error of the energy balance relative to its largest term [-]:
      /// in the recorded cycle and in the motion as a whole.
      double energy_balance_relative_error             = 0.;
      double energy_balance_relative_error_since_start = 0.;
    };

    /// summary.json.
    struct RunSummary
    {
      std::string case_name;
      /// completed, stopped or failed.
      std::string status = "failed";
      /// Why it did not complete; empty otherwise.
      std::string message;
      double      cycles = 0.;
      /// Whether there was no wear to be computed.
      bool   is_dynamics_only  = false;
      double wall_time         = 0.;
      double cpu_time          = 0.;
      double peak_memory_bytes = 0.;

      unsigned int wear_steps        = 0;
      unsigned int rate_evaluations  = 0;
      unsigned int dynamics_cycles   = 0;
      unsigned int contact_solves    = 0;
      unsigned int compliance_builds = 0;

      std::vector<JointSummary> joints;
      DynamicsSummary           dynamics;

      /// Estimated relative errors of maximum depth and worn volume left by the
      /// wear steps, of the bushing where they are largest [-].
      double max_wear_depth_relative_error = 0.;
      double worn_volume_relative_error    = 0.;
      /// Largest violation of the constraints [m].
      double constraint_drift = 0.;
      /// How well the last duty cycle repeats [-], and whether all settled.
      double settling_difference = 0.;
      bool   all_settled         = true;
      /// What the first one that did not has to say.
      std::string settling_message;
    };

    /// @throws ExcRun if the file cannot be written.
    void
    write_summary_json(const std::string &file_name, const RunSummary &summary);
  } // namespace Coupling
} // namespace Tribody

#endif

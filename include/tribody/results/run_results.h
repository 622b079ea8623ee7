// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_results_run_results_h
#define tribody_results_run_results_h

#include <tribody/base/choice.h>
#include <tribody/stepping/run_state.h>
#include <tribody/stepping/wear_process.h>

#include <optional>
#include <string>
#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    /// How one surface of a joint has worn; angles in its own frame.
    struct SurfaceResults
    {
      double max_wear_depth = 0.; ///< [m]
      double max_wear_angle = 0.; ///< of the deepest node [rad]
      double worn_volume    = 0.; ///< [m^3]
      double worn_mass      = 0.; ///< [kg]
      /// k F s, the wear coefficient times the integral of the normal force
      /// over the sliding distance [m^3]; 0: the coefficient varies.
      double archard_volume = 0.;
      /// Of the volume on the mesh against what the wear law has removed [-].
      double volume_balance_relative_error = 0.;
      /// Estimated error that the wear steps have left in the depth of the
      /// deepest node [m].
      double depth_error = 0.;
      /// The same in the volume [m^3].
      double volume_error = 0.;
    };

    /// Wear::Crescent for the joint, where it applies.
    struct CrescentResults
    {
      double normal_force;   ///< mean over the sliding distance [N]
      double max_wear_depth; ///< [m]
      double worn_volume;    ///< [m^3]
    };

    /// What a run says of a bushing and its pin beside JointState.
    struct BushingResults
    {
      /// Of the joint.
      std::string name;
      /// Its place in RunState::joints.
      std::size_t number;
      /// How its bore has worn.
      SurfaceResults                bushing;
      std::optional<SurfaceResults> pin; ///< if it wears
      /// Empty where it does not apply: if the pin wears, the coefficient
      /// varies, the force turns by more than 45 degrees from its mean
      /// direction, or wear is not deeper than the clearance.
      std::optional<CrescentResults> crescent;
      /// Largest, of the worn joint [m].
      double clearance;
      /// Amplitude of the mesh-size oscillation of the wear rate [-].
      double mesh_oscillation;
      /// Of the duty cycles, as means over the cycles.
      DutyErrors duty_errors;
      /// By the mesh, if it is known for the whole run.
      double mesh_error = 0.;

      /// The larger of the errors of depth by the wear steps, relative to the
      /// deepest of both surfaces [-]; zero without wear.
      double
      step_error() const;

      /// The sum of all errors of the depth that are estimated [-].
      double
      depth_relative_error() const;

      /// The sum of the errors of volume, relative to what both surfaces have
      /// lost [-]; zero without wear.
      double
      volume_relative_error() const;
    };

    /// How a run ended: after its last cycle, at a stop condition, or by an
    /// error.
    /// How far a run has come.
    enum class RunStatus
    {
      running,
      completed,
      stopped,
      failed
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<RunStatus>
    choice_names(const RunStatus)
    {
      return {{RunStatus::running, "running"},
              {RunStatus::completed, "completed"},
              {RunStatus::stopped, "stopped"},
              {RunStatus::failed, "failed"}};
    }

    /// What a run has come to. A plain value.
    struct RunResults
    {
      /// Until a run has ended well it counts as failed.
      RunStatus status = RunStatus::running;
      /// Why it did not complete; empty otherwise.
      std::string message;
      double      wall_time         = 0.; ///< [s]
      double      cpu_time          = 0.; ///< [s]
      double      peak_memory_bytes = 0.; ///< largest of this rank [bytes]

      /// Where it stands, or stood when it failed.
      RunState state;
      /// Of the bushings whose contacts are known.
      std::vector<BushingResults> bushings;

      /// The bushing of the joint @p name, or nullptr.
      const BushingResults *
      bushing(const std::string &name) const;

      /// The largest of all bushings [-].
      double
      depth_relative_error() const;

      /// The same for the volume.
      double
      volume_relative_error() const;
    };

    /**
     * Results that cannot be right are no results: depths and forces must be
     * numbers, what the surfaces lose what the wear law has removed, and
     * energies, where they are added up, in balance.
     * @throws ExcRun naming what is off, and by how much.
     */
    void
    check_results(const RunResults &results);

    /// The results of @p process as it stands. Status, message and costs are
    /// left to the caller.
    RunResults
    make_run_results(const WearProcess &process);
  } // namespace Coupling
} // namespace Tribody

#endif

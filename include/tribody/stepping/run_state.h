// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_stepping_run_state_h
#define tribody_stepping_run_state_h

#include <Eigen/Core>

#include <tribody/bushing/warm_bushing.h>
#include <tribody/bushing/wearing_bushing.h>
#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/stepping/mesh_error.h>
#include <tribody/stepping/premises.h>
#include <tribody/wear/implicit_extrapolation.h>

#include <array>
#include <string>
#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    /// What a run adds up for one surface of a joint.
    struct SurfaceTotals
    {
      /// Wear coefficient times the integral of pressure over area and
      /// distance [m^3]: what the wear law has removed.
      double removed_volume = 0.;
      /// Estimated error of the volume left by the steps [m^3].
      double volume_error = 0.;
    };

    /// Estimated errors that a duty cycle leaves in the wear, relative [-], or
    /// their integral over the cycles.
    struct DutyErrors
    {
      /// By its samples, JointDutyCycle::sampling_error, and by merging them.
      double sampling = 0.;
      /// By the inertia that pins which follow their bores leave out.
      double inertia = 0.;
      /// As the motion has not settled: its distance from one that repeats, or
      /// of the mean of force times sliding over the cycles that were averaged.
      double settling = 0.;
      /// Of the integrated motion.
      double integration = 0.;
      /// As friction laws creep where friction holds.
      double creep = 0.;

      /// The means over @p n_cycles if these are integrals.
      DutyErrors
      over(const double n_cycles) const
      {
        return {sampling / n_cycles,
                inertia / n_cycles,
                settling / n_cycles,
                integration / n_cycles,
                creep / n_cycles};
      }

      /// Add @p factor times @p other.
      void
      add(const double factor, const DutyErrors &other)
      {
        sampling += factor * other.sampling;
        inertia += factor * other.inertia;
        settling += factor * other.settling;
        integration += factor * other.integration;
        creep += factor * other.creep;
      }

      /// All together.
      double
      sum() const
      {
        return sampling + inertia + settling + integration + creep;
      }
    };

    /// Over which wear spreads to either side of the force in @p contact, for
    /// the choice of samples [rad]; the usual one before there is a contact.
    double
    reach_of(const CycleContact &contact);

    /// Those of @p joint in @p cycle, which wears over @p reach [rad] under @p
    /// loads.
    DutyErrors
    estimate_duty_errors(const Multibody::DutyCycle      &cycle,
                         const Multibody::JointDutyCycle &joint,
                         const Multibody::BearingLoads   &loads,
                         const double                     reach);

    /// What a run adds up for one bushing and its pin.
    struct JointTotals
    {
      /// In the order of WearingBushing::surfaces().
      std::array<SurfaceTotals, 2> surfaces;
      /// Distance that the pin has slid [m].
      double sliding_distance = 0.;
      /// Integral of the normal force over that distance, times the wear
      /// factors of the load cases [N m].
      double force_over_sliding = 0.;
      /// Estimated error of the depth left by the steps [m], per wearing node.
      Eigen::VectorXd depth_error;
      /// Errors of the duty cycles, each times the cycles it was worn under.
      DutyErrors duty_errors;
      /// The largest that have been seen.
      Strains strains;
      /// Likewise of the bore [K].
      double max_temperature = 0.;
    };

    /// All that a run has done to one joint that wears. Depths have one value
    /// per wearing node, those of the bore and then those of the pin [m].
    struct JointState
    {
      /// What wear has taken so far.
      Eigen::VectorXd depth;
      /// What its elastic compliance was computed for: it follows the depth
      /// with a lag.
      Eigen::VectorXd depth_at_compliance;
      /// What the motion of the mechanism was computed for, with a lag too.
      Eigen::VectorXd depth_at_dynamics;
      /// How warm it is; nothing unless somebody asks for it.
      Warmth warmth;
      /// Likewise when the motion was computed.
      Warmth warmth_at_dynamics;
      /// The loads of the duty cycle of each load case, those of several
      /// cycles merged.
      std::vector<Multibody::BearingLoads> loads_of_cases;
      /// What wears it: all of these, as far as they have a share.
      Multibody::BearingLoads loads;
      /// Contact and wear per cycle at the depth, under these loads.
      CycleContact contact;
      /// Sums over all cycles so far.
      JointTotals totals;
    };

    /// What one cycle takes away: from CycleContact.
    struct WearRates
    {
      /// Depth per cycle [m], one value per wearing node.
      Eigen::VectorXd wear_rate;
      /// Cross-section area per cycle [m^2], one value per wearing node.
      Eigen::VectorXd removed_area;
    };

    /// What the wear steps hand on to each other: nothing else of them lasts.
    /// A run uses the part of its extrapolation.
    struct StepperState
    {
      /// Implicit steps. The contacts of the last iteration, one per joint:
      /// those of a stage, which say best which nodes to begin with.
      std::vector<CycleContact> contacts;
      /// The rate dy/dN at the end of the last step, with what its end has
      /// changed [m^2 per cycle]; empty before the first.
      Eigen::VectorXd rate;
      /// Bound of the next step from what changes between steps [cycles]; 0:
      /// none.
      double max_step = 0.;
      /// What the step control and the predictor of the next step know.
      Wear::ExtrapolationMemory extrapolation;

      /// Explicit steps. The rates at the beginning of the last step, one per
      /// joint.
      std::vector<WearRates> rates_before;
      /// The rates that it took: these, or those of the first step for all.
      std::vector<WearRates> rates_taken;
      /// Cycles up to which a step is stable; 0: not known.
      double max_stable_step = 0.;
      /// RunCounts::compliance_builds that this bound belongs to; 0: none yet.
      unsigned int stable_step_builds = 0;
    };

    /// What a run counts.
    struct RunCounts
    {
      /// Wear steps taken, each over many cycles.
      unsigned int wear_steps = 0;
      /// How often the wear of a cycle was computed, see WearStep.
      unsigned int rate_evaluations = 0;
      /// Cycles of the mechanism whose motion was computed, settling included.
      unsigned int dynamics_cycles = 0;
      /// Contact problems: one per joint and sample in each rate evaluation.
      unsigned int contact_solves = 0;
      /// Rounds of motion, contact and temperature.
      unsigned int temperature_rounds = 0;
      /// How often an elastic compliance was computed, the first ones included.
      unsigned int compliance_builds = 0;
    };

    /// What is kept of all duty cycles so far.
    struct DynamicsTotals
    {
      /// Losses of contact, one per joint of the mechanism.
      std::vector<unsigned int> contact_losses;
      /// Largest violation of the constraints [m].
      double constraint_drift = 0.;
      /// Whether all had settled.
      bool all_settled = true;
      /// What the first one that did not go as wished has to say; else empty.
      std::string settling_message;
      /// Likewise the first one that did not settle.
      std::string unsettled_message;
    };

    /**
     * Where a run stands; with the parameters it is all that the rest follows
     * from. A plain value: a copy can be kept, and gone on with
     * (WearProcess::restore()). On several ranks each has its own share of the
     * samples of a contact; all else is the same.
     */
    struct RunState
    {
      /// How many cycles the joints have worn.
      double cycles = 0.;
      /// At which the motion was computed last.
      double cycles_at_dynamics = 0.;
      /// One per bushing.
      std::vector<JointState> joints;
      /// Motion and joint forces that wear goes on under, one per load case.
      std::vector<Multibody::DutyCycle> duty_cycles;
      /// The part of each load case in the cycles that follow; all: one [-].
      Eigen::VectorXd shares;
      /// How long the cycles have lasted [s].
      double operating_time = 0.;
      /// How many there were of each load case.
      Eigen::VectorXd cycles_of_cases;
      /// Sums over the duty cycles before it, and its own.
      DynamicsTotals dynamics;
      /// For the next wear step.
      StepperState stepper;
      /// Costs of the run.
      RunCounts counts;
      /// What the mesh does to the results, one per bushing; empty if nobody
      /// asked.
      std::vector<MeshError> mesh_errors;
      /// The wear on the next coarser meshes that goes along with this one,
      /// see CoarseRun; empty or one.
      std::vector<RunState> twin;
      /// The stop condition that has ended the run, for the user; or empty.
      std::string stopped_by;
      /// Whether the user knows that the explicit steps are too long.
      bool unstable_step_reported = false;
    };
  } // namespace Coupling
} // namespace Tribody

#endif

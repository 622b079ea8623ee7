// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_stepping_run_state_h
#define tribody_stepping_run_state_h

#include <tribody/bushing/wearing_bushing.h>
#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/stepping/mesh_error.h>

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

    /// What a run adds up for one bushing and its pin.
    struct BushingTotals
    {
      /// In the order of WearingBushing::surfaces().
      std::array<SurfaceTotals, 2> surfaces;
      /// Distance that the pin has slid [m].
      double sliding_distance = 0.;
      /// Integral of the normal force over that distance [N m].
      double force_over_sliding = 0.;
      /// Estimated error of the depth left by the steps [m], per wearing node.
      Eigen::VectorXd depth_error;
    };

    /// What a run counts.
    struct RunCounts
    {
      unsigned int wear_steps       = 0;
      unsigned int rate_evaluations = 0;
      unsigned int dynamics_cycles  = 0;
      unsigned int contact_solves   = 0;
    };

    /// Where a run stands; lists have one entry per bushing.
    struct RunState
    {
      double                     cycles = 0.;
      Multibody::DutyCycle       duty_cycle;
      std::vector<CycleContact>  contacts;
      std::vector<BushingTotals> totals;
      RunCounts                  counts;
      /// Over all duty cycles so far: losses of contact per joint, largest
      /// drift [m], and whether all had settled.
      std::vector<unsigned int> contact_losses;
      double                    constraint_drift = 0.;
      bool                      all_settled      = true;
      /// What the first duty cycle that did not go as wished has to say.
      std::string settling_message;
      /// What the meshes do to the results; empty if nobody asked.
      std::vector<MeshError> mesh_errors;
      /// Cycles up to which an explicit wear step is stable.
      double max_stable_step = 0.;
    };
  } // namespace Coupling
} // namespace Tribody

#endif

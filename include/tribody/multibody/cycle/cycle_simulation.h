// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_cycle_cycle_simulation_h
#define tribody_multibody_cycle_cycle_simulation_h

#include <tribody/multibody/motion/dynamics_parameters.h>
#include <tribody/multibody/motion/reference_scales.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/mechanism.h>
#include <tribody/surface/periodic_profile.h>

#include <map>
#include <string>

namespace Tribody
{
  namespace Multibody
  {
    class CycleRecorder;
    class EnergyAccount;
    class IntermittentMotion;
    struct DutyCycle;
    struct SettlingReport;
    struct StartingState;

    /**
     * Finds the settled motion of a mechanism and records one cycle of it:
     *
     * @code
     *   const Mechanism       mechanism(parameters);
     *   const CycleSimulation simulation(mechanism, DynamicsParameters());
     *   const DutyCycle cycle = simulation.run({{"crank_pin", worn_profile}});
     * @endcode
     *
     * Unless the parameters choose an analysis: without degrees of freedom it
     * solves the positions at each sample, and forces by inverse dynamics.
     * Otherwise it integrates, beginning at rest in its vibrations, until the
     * joint forces repeat from cycle to cycle.
     */
    class CycleSimulation
    {
    public:
      /**
       * Assembles the mechanism, once for all runs. Keeps a reference to
       * @p mechanism.
       * @throws ExcParameter for what cannot be assembled, redundant
       *   constraints, a missing driver, an analysis that does not fit the
       *   degrees of freedom, masses that are missing, or a crank that cannot
       *   make a full turn with ideal joints.
       */
      CycleSimulation(const Mechanism          &mechanism,
                      const DynamicsParameters &parameters);

      // The equations of the closed mechanism refer to a member.
      CycleSimulation(const CycleSimulation &) = delete;
      CycleSimulation &
      operator=(const CycleSimulation &) = delete;

      /// Worn surfaces of joints with a contact law, by name of the joint.
      using Clearances = std::map<std::string, JointClearance>;
      /// Elastic surfaces of joints, by name of the joint.
      using Supports = std::map<std::string, std::shared_ptr<const PinSupport>>;

      /**
       * A settled cycle with the given clearances, by name of the joint; those
       * not given are as manufactured. Whether it has really settled is in the
       * result.
       * @param supports of all joints under FiniteElementLaw.
       * @throws ExcRun if the integration fails.
       */
      DutyCycle
      run(const Clearances &clearances = {},
          const Supports   &supports   = {}) const;

      /// Of the joints as manufactured.
      std::vector<ReferenceScale>
      reference_scales(const Supports &supports = {}) const;

    private:
      std::vector<JointClearance>
      collect_clearances(const Clearances &by_name) const;

      EquationsOfMotion::Supports
      collect_supports(const Supports &by_name) const;

      void
      check_analysis() const;

      // Nothing but constraints is asked.
      bool
      is_kinematic() const;

      // Time of record k, from half an interval before the first sample on if
      // the cycle repeats; a motion with a beginning has no time before 0.
      double
      record_time(const unsigned int k) const;

      // Kinematics, with inverse dynamics unless it is_kinematic().
      DutyCycle
      run_kinematics(const EquationsOfMotion &equations) const;

      DutyCycle
      run_statics(const EquationsOfMotion &equations) const;

      DutyCycle
      run_dynamics(const EquationsOfMotion           &equations,
                   const std::vector<ReferenceScale> &scales) const;

      // Go through cycles, one or as many as recorder is made for; returns the
      // integration steps taken.
      unsigned long
      record_cycles(const double        begins,
                    const unsigned int  n_cycles,
                    IntermittentMotion &integrator,
                    CycleRecorder      &recorder) const;

      // Go through cycles until one repeats the one before; the last is left
      // in recorder.
      SettlingReport
      settle(IntermittentMotion &integrator,
             CycleRecorder      &recorder,
             unsigned long      &n_steps_in_cycle) const;

      // Record as many cycles as are to be averaged, from where settle() ended.
      DutyCycle
      record_average(const EquationsOfMotion &equations,
                     const EnergyAccount     *account,
                     const unsigned int       n_cycles_before,
                     IntermittentMotion      &integrator) const;

      // In static equilibrium, or in slow motion if asked for and possible,
      // else centred; the message of its report says why.
      StartingState
      compute_start(const EquationsOfMotion &equations) const;

      const Mechanism         &mechanism;
      const DynamicsParameters parameters;
      const Mechanism          closed_mechanism;
      const EquationsOfMotion  closed_equations;
      const double             period;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_cycle_cycle_simulation_h
#define tribody_multibody_cycle_cycle_simulation_h

#include <tribody/multibody/cycle/integration_accuracy.h>
#include <tribody/multibody/motion/dynamics_parameters.h>
#include <tribody/multibody/motion/reference_scales.h>
#include <tribody/multibody/play/marker_watch.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/mechanism.h>
#include <tribody/surface/periodic_profile.h>

#include <functional>
#include <map>
#include <string>

namespace Tribody
{
  namespace Multibody
  {
    struct Accelerations;
    struct MechanismState;
    struct DutyCycle;
    struct MotionEnd;
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
       *   degrees of freedom, masses that are missing, a driver that jumps, a
       *   crank that cannot make a full turn with ideal joints, or what
       *   MarkerWatch refuses.
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

      using Arcs = WearArcs;

      /**
       * A settled cycle with the given clearances, by name of the joint; those
       * not given are as manufactured. Whether it has really settled is in the
       * result.
       * @param supports of all joints under FiniteElementLaw.
       * @param arcs decide how many samples the sampling tolerance asks for.
       * @param before another cycle of this mechanism, in bores that have worn
       *   since: an integrated motion goes on where that ended. The null
       *   pointer: it starts.
       * @throws ExcRun if the integration fails.
       */
      DutyCycle
      run(const Clearances &clearances = {},
          const Supports   &supports   = {},
          const Arcs       &arcs       = {},
          const DutyCycle  *before     = nullptr) const;

      /// Make sure that a motion which the drivers prescribe repeats with the
      /// cycle, as wear takes for granted. @throws ExcParameter.
      void
      check_repetition() const;

      /// Of one cycle [s].
      double
      duration() const
      {
        return period;
      }

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

      // That what they prescribe has a velocity, at least.
      void
      check_drivers() const;

      // What run() does but for the premises.
      DutyCycle
      find_cycle(const Clearances &clearances,
                 const Supports   &supports,
                 const Arcs       &arcs,
                 const DutyCycle  *before) const;

      // Nothing but constraints is asked.
      bool
      is_kinematic() const;

      // Time of record k for n samples, from half an interval before the first
      // sample on if the cycle repeats; a motion with a beginning has no time
      // before 0.
      double
      record_time(const unsigned int k, const unsigned int n) const;

      // With as many samples as the sampling tolerance asks for.
      DutyCycle
      refine_samples(
        const Arcs                                         &arcs,
        const std::function<DutyCycle(const unsigned int)> &run_with) const;

      bool
      needs_more_samples(const DutyCycle   &cycle,
                         const Arcs        &arcs,
                         const unsigned int n) const;

      // Kinematics, with inverse dynamics unless it is_kinematic().
      DutyCycle
      run_kinematics(const EquationsOfMotion &equations,
                     const unsigned int       n) const;

      // With ideal joints in static equilibrium and the pins placed under
      // their reactions; q where there is none.
      Eigen::VectorXd
      guess_rest(const EquationsOfMotion &equations,
                 const double             t,
                 const Eigen::VectorXd   &q) const;

      // Static equilibrium near state.q. Sets state.q and, where pins can
      // follow, their contacts.
      Accelerations
      balance(const EquationsOfMotion   &equations,
              MechanismState            &state,
              std::vector<JointContact> &contacts) const;

      DutyCycle
      run_statics(const EquationsOfMotion &equations,
                  const unsigned int       n) const;

      // Whether there are pins, and drivers and joints allow them to follow
      // their bores.
      bool
      can_follow() const;

      // Whether they are to do so, too.
      bool
      may_follow() const;

      // With pins that follow their bores. Throws ExcRun where they do not, or
      // where that neglects more than this share of the wear of a joint.
      DutyCycle
      run_following(const EquationsOfMotion &equations,
                    const unsigned int       n,
                    const double             largest_wear) const;

      // Quasi-static if asked for and possible, or dynamic; quasi-static with
      // what it neglects if it cannot be integrated.
      DutyCycle
      run_joints_with_gaps(const EquationsOfMotion           &equations,
                           const std::vector<ReferenceScale> &scales,
                           const Arcs                        &arcs,
                           const DutyCycle                   *before) const;

      DutyCycle
      run_dynamics(const EquationsOfMotion           &equations,
                   const std::vector<ReferenceScale> &scales,
                   const Arcs                        &arcs,
                   const DutyCycle                   *before,
                   const unsigned int                 maximum_steps) const;

      // From begin on, with accuracy and samples as needed. It is expected to
      // repeat, or not.
      DutyCycle
      integrate(const EquationsOfMotion           &equations,
                const std::vector<ReferenceScale> &scales,
                const Arcs                        &arcs,
                const DynamicsParameters          &as_needed,
                const MechanismState              &begin,
                const bool                         repeats) const;

      // In the bores as they are now; anew where that fails.
      StartingState
      continue_from(const EquationsOfMotion &equations,
                    const MotionEnd         &end) const;

      // In static equilibrium, or in slow motion if asked for and possible,
      // else centred; the message of its report says why.
      StartingState
      compute_start(const EquationsOfMotion &equations) const;

      const Mechanism         &mechanism;
      const DynamicsParameters parameters;
      const Mechanism          closed_mechanism;
      const EquationsOfMotion  closed_equations;
      const MarkerWatch        marker_watch;
      const double             period;
      // What to say of the mechanism and its start with every cycle.
      std::string premises;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

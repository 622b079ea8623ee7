// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_stepping_wear_process_h
#define tribody_stepping_wear_process_h

#include <tribody/stepping/cycle_jump.h>
#include <tribody/stepping/run_state.h>
#include <tribody/stepping/stop_conditions.h>
#include <tribody/stepping/wear_parameters.h>

#include <deque>
#include <functional>
#include <memory>
#include <string>

namespace Tribody
{
  namespace Coupling
  {
    /**
     * The wear of all bushings of a run, or of their twins on coarser meshes,
     * under duty cycles that are given: contact, wear per cycle, a step over
     * many cycles, worn geometry. One round is
     *
     *     process.take_step(end);
     *     process.renew_duty_cycles(...);     where the motion has changed
     *     process.complete_step(kept_since);
     *
     * after renew_duty_cycles() and solve_contacts() for the first cycle. Where
     * it stands is state(); everything else is constant, or follows from the
     * depths in there.
     */
    class WearProcess
    {
    public:
      /// @param bushings unworn.
      /// @param wear_factors of the load cases [-].
      /// @param ambient_temperatures in the load cases [K].
      WearProcess(const WearParameters        &parameters,
                  std::deque<WearingBushing> &&bushings,
                  const std::vector<double>   &wear_factors         = {1.},
                  const std::vector<double>   &ambient_temperatures = {293.15});

      WearProcess(const WearProcess &) = delete;
      WearProcess &
      operator=(const WearProcess &) = delete;

      /// Where it stands. The reference is to a member, which each operation
      /// changes.
      const RunState &
      state() const
      {
        return run_state;
      }

      /// The joints that wear, in the shape of the state.
      const std::deque<WearingBushing> &
      bushings() const
      {
        return joint_bushings;
      }

      /// Go on from @p state, which another process of the same parameters has
      /// come to, or this one before.
      /// Not between take_step() and complete_step(); all ranks together.
      /// @throws ExcRun if it does not fit these bushings, or its geometry
      ///   cannot be meshed.
      void
      restore(const RunState &state);

      /// The premises of one load case, before wear goes on under it.
      /// @throws ExcRun if a pin is not in its bore, or strains are too large.
      void
      check_duty_cycle(const Multibody::DutyCycle &cycle) const;

      /// Wear under @p cycles from now on, one per load case, of which each
      /// has its part of @p shares [-]. If the shares have changed, the next
      /// step begins as if it were the first one.
      void
      renew_duty_cycles(const std::vector<Multibody::DutyCycle> &cycles,
                        const Eigen::VectorXd                   &shares);

      /// The same with one load case.
      void
      renew_duty_cycle(const Multibody::DutyCycle &cycle)
      {
        renew_duty_cycles({cycle}, Eigen::VectorXd::Ones(1));
      }

      /// The wear factors of the load cases [-].
      const std::vector<double> &
      wear_factors() const
      {
        return factors;
      }

      /// The ambient temperatures of the load cases [K].
      const std::vector<double> &
      ambient_temperatures() const
      {
        return ambient;
      }

      /// Leave out the samples of several load cases that the wear does not
      /// need, now that the arcs of contact are known; contacts must be solved
      /// anew. One load case keeps its samples.
      void
      thin_out_loads();

      /// Whether a profile, worn and warm, has changed by more than 'Dynamics
      /// update' of the clearance since the duty cycle was renewed, or friction
      /// by as much of itself.
      bool
      duty_cycle_is_outdated() const;

      /// Whether friction heats a joint.
      bool
      gets_warm() const;

      /**
       * Find the temperatures that belong to contacts and duty cycles and
       * these to them, by fixed point iteration, see correct(). Nothing
       * happens if no joint gets warm.
       * @param renew_motion called where a duty cycle is outdated.
       * @throws ExcRun if a joint has no clearance left, or they come to no
       *   end.
       */
      void
      settle_warmth(const std::function<void()> &renew_motion);

      /// Contact and wear per cycle in every bushing.
      /// @throws ExcRun if a contact problem is not solved.
      void
      solve_contacts();

      /// One step of the wear over many cycles, at most to @p end [cycles].
      /// RunState::stopped_by says whether a stop condition was reached.
      /// @throws ExcRun if the worn geometry cannot be meshed; the state is
      /// then
      ///   that before the step.
      void
      take_step(const double end);

      /// Contacts at the end of the step, and what it has left of error.
      /// @param kept_since when the duty cycle was renewed that the step was
      ///   taken under; the begin of the step if it still holds [cycles].
      void
      complete_step(const double kept_since);

      /// For the run, see RunState.
      void
      set_mesh_errors(const std::vector<MeshError> &errors)
      {
        run_state.mesh_errors = errors;
      }

      /// For the run, see RunState.
      void
      set_twin(const std::vector<RunState> &twin)
      {
        run_state.twin = twin;
      }

      /// For the run, see RunState: it has ended at a limit that only the
      /// motion knows.
      void
      set_stopped_by(const std::string &limit)
      {
        run_state.stopped_by = limit;
      }

      /// For the run, see RunState: the user has been told, once.
      void
      set_unstable_step_reported()
      {
        run_state.unstable_step_reported = true;
      }

    private:
      // A step at most to end whose geometry can be meshed: shorter steps are
      // tried where it cannot.
      WearStep
      advance(double end);

      void
      count_rate_evaluations(const unsigned int n);

      // The loads of a load case that the wear of the joint needs.
      Multibody::BearingLoads
      make_loads(const Multibody::DutyCycle &cycle, const std::size_t j) const;

      // Of settle_warmth().
      struct WarmthRound
      {
        // Whether no joint was off by more than its tolerance.
        bool have_settled = true;
        // Why a joint has not become as warm as it should; or empty.
        std::string obstacle;
      };

      // Joints whose temperature is off get another one.
      WarmthRound
      update_warmth(std::vector<WarmthIteration> &iterations);

      // Be as warm, or on the way there as far as the premises allow; returns
      // which did not.
      std::string
      become_warm(const std::size_t j,
                  Warmth            warmth,
                  WarmthIteration  &iteration);

      // Of friction in the joint, mean over the time of all load cases: its
      // work in the motion [W].
      double
      frictional_power(const std::size_t j) const;

      void
      add_to_dynamics_totals(const Multibody::DutyCycle &cycle,
                             const bool                  was_quasi_static);

      // The step has taken so many cycles.
      void
      add_to_joint_totals(const WearStep &step, const std::size_t j);

      double                     dynamics_update;
      std::deque<WearingBushing> joint_bushings;
      StopConditions             stop_conditions;
      std::unique_ptr<CycleJump> jump;
      std::vector<double>        factors;
      std::vector<double>        ambient;
      RunState                   run_state;
    };
  } // namespace Coupling
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_cycle_integrated_cycle_h
#define tribody_multibody_cycle_integrated_cycle_h

#include <tribody/multibody/cycle/cycle_recorder.h>
#include <tribody/multibody/motion/dynamics_parameters.h>
#include <tribody/multibody/motion/energy_account.h>
#include <tribody/multibody/motion/intermittent_motion.h>

#include <functional>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * Integrates a motion, cycle after cycle, until it repeats, and records the
     * last cycle; if it does not repeat, several cycles after that. One object
     * is one motion.
     */
    class IntegratedCycle
    {
    public:
      /// Keeps references to @p equations and @p parameters.
      /// @param period of a cycle [s].
      /// @param begin fulfils the constraints, at time 0 or where a motion that
      ///   goes on has ended.
      IntegratedCycle(const EquationsOfMotion  &equations,
                      const DynamicsParameters &parameters,
                      const MotionTolerances   &tolerances,
                      const double              period,
                      const MechanismState     &begin);

      // Integrator and recorder refer to members.
      IntegratedCycle(const IntegratedCycle &) = delete;
      IntegratedCycle &
      operator=(const IntegratedCycle &) = delete;

      /// Whether a cycle with so many samples needs twice as many.
      using NeedsMoreSamples =
        std::function<bool(const DutyCycle &, const unsigned int)>;

      /// @param repeats whether it may be expected to: else one cycle is all
      ///   that it gets to settle.
      /// @throws ExcRun if the integration fails.
      DutyCycle
      run(const NeedsMoreSamples &needs_more_samples, const bool repeats);

    private:
      // Go through n_cycles cycles of n samples; the records go into recorder,
      // after those of so many cycles before. Returns the integration steps
      // taken.
      unsigned long
      record_cycles(const unsigned int n_cycles,
                    const unsigned int n,
                    CycleRecorder     &recorder,
                    const unsigned int n_recorded = 0);

      // Go through cycles until one repeats the one before.
      void
      settle(const unsigned int max_cycles);

      // What settle() ended with, or with as many samples more as are needed.
      DutyCycle
      settled_cycle(const NeedsMoreSamples &needs_more_samples);

      // As many cycles as their scatter needs, from where settle() ended, with
      // as many samples as are needed.
      DutyCycle
      average_cycle(const NeedsMoreSamples &needs_more_samples);

      // With so many, from where the motion is.
      DutyCycle
      average_cycle(const unsigned int n_samples);

      const EnergyAccount *
      kept_account() const;

      const EquationsOfMotion  &equations;
      const DynamicsParameters &parameters;
      const double              period;
      const double              begin_time;
      // Cycles before this motion began.
      const double       origin;
      IntermittentMotion integrator;
      EnergyAccount      account;
      CycleRecorder      recorder;
      SettlingReport     settling;
      unsigned long      n_steps_in_cycle = 0;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

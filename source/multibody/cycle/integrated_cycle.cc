// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/multibody/assembly/assembly_checks.h>
#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/multibody/cycle/integrated_cycle.h>
#include <tribody/multibody/cycle/settling_monitor.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/mechanism.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    IntegratedCycle::IntegratedCycle(const EquationsOfMotion  &equations,
                                     const DynamicsParameters &parameters,
                                     const MotionTolerances   &tolerances,
                                     const double              period,
                                     const MechanismState     &begin)
      : equations(equations)
      , parameters(parameters)
      , period(period)
      , begin_time(begin.time)
      // A motion that goes on begins half an interval before a cycle does.
      , origin(std::ceil(begin.time / period - 1e-9))
      , integrator(equations, tolerances)
      , account(equations)
      , recorder(equations, parameters.samples_per_cycle, period)
    {
      integrator.start(begin);
      if (kept_account() != nullptr)
        integrator.set_energy_account(&account);
      recorder.set_energy_account(kept_account());
    }



    const EnergyAccount *
    IntegratedCycle::kept_account() const
    {
      return parameters.energy_balance == EnergyBalance::always ? &account
                                                                : nullptr;
    }



    DutyCycle
    IntegratedCycle::run(const NeedsMoreSamples &needs_more_samples,
                         const bool              repeats)
    {
      DutyCycle cycle;
      try
        {
          settle(repeats ? parameters.maximum_settling_cycles : 0);
          cycle = settling.converged || parameters.averaged_cycles == 1
                    ? settled_cycle(needs_more_samples)
                    : average_cycle(needs_more_samples);
        }
      catch (const ExcRun &error)
        {
          const MechanismState &last = integrator.state();
          const std::string     reason =
            explain_end_of_motion(equations,
                                  last.time,
                                  last.time +
                                    period / parameters.samples_per_cycle,
                                  last.q);
          throw ExcRun(message_of(error) +
                       (reason.empty() ? "" : " Note that" + reason + "."));
        }
      cycle.settling         = settling;
      cycle.n_steps_in_cycle = n_steps_in_cycle;
      cycle.constraint_drift = integrator.constraint_drift();
      cycle.statistics       = integrator.statistics();
      cycle.end              = make_motion_end(equations, integrator.state());
      const Mechanism &mechanism = equations.mechanism();
      for (unsigned int j = 0; j < cycle.joints.size(); ++j)
        cycle.joints[j].peak_force_since_start =
          mechanism.joints()[j].has_contact_law()
            ? integrator.peak_forces()[mechanism.joints()[j].index]
            : cycle.joints[j].peak_force();
      return cycle;
    }



    unsigned long
    IntegratedCycle::record_cycles(const unsigned int n_cycles,
                                   const unsigned int n,
                                   CycleRecorder     &recorder,
                                   const unsigned int n_recorded)
    {
      const unsigned long n_steps   = integrator.statistics().n_steps;
      const unsigned long n_allowed = static_cast<unsigned long>(n_cycles) *
                                      parameters.maximum_steps_per_cycle;
      unsigned long      n_taken      = 0;
      const unsigned int first_record = 2 * n * n_recorded;
      for (unsigned int k = 0; k <= 2 * n * n_cycles; ++k)
        {
          const double t =
            (origin + settling.n_cycles) * period + (k - 1.) * period / (2 * n);
          // The first cycle lacks what was before the beginning.
          const MechanismState &state =
            integrator.advance_to(std::max(begin_time, t), n_allowed, n_taken);
          recorder.record(first_record + k,
                          state,
                          integrator.present_equations());
          n_taken = integrator.statistics().n_steps - n_steps;
        }
      settling.n_cycles += n_cycles;
      return n_taken;
    }



    void
    IntegratedCycle::settle(const unsigned int max_cycles)
    {
      // Part of the tolerance at which it does not matter any more whether the
      // changes decay.
      constexpr double no_change = 1e-3;
      SettlingMonitor  monitor;
      while (true)
        {
          n_steps_in_cycle =
            record_cycles(1, parameters.samples_per_cycle, recorder);
          if (parameters.maximum_settling_cycles == 0)
            {
              settling.converged = true;
              return;
            }
          if (max_cycles == 0)
            return;
          monitor.add(recorder.repeating_quantities());
          if (settling.n_cycles == 1)
            continue;
          settling.repeat_difference = monitor.difference();
          settling.distance          = monitor.distance();
          settling.decay             = monitor.decay();
          settling.converged =
            settling.distance < parameters.settling_tolerance ||
            settling.repeat_difference <
              no_change * parameters.settling_tolerance;
          if (settling.converged || settling.n_cycles > max_cycles)
            return;
        }
    }



    DutyCycle
    IntegratedCycle::settled_cycle(const NeedsMoreSamples &needs_more_samples)
    {
      DutyCycle cycle =
        recorder.make_duty_cycle(integrator.events(), begin_time);
      unsigned int n = parameters.samples_per_cycle;
      while (settling.converged && settling.n_cycles > 1 &&
             needs_more_samples(cycle, n))
        {
          n *= 2;
          CycleRecorder finer(equations, n, period);
          finer.set_energy_account(kept_account());
          n_steps_in_cycle = record_cycles(1, n, finer);
          cycle = finer.make_duty_cycle(integrator.events(), begin_time);
        }
      return cycle;
    }



    DutyCycle
    IntegratedCycle::average_cycle(const NeedsMoreSamples &needs_more_samples)
    {
      unsigned int n     = parameters.samples_per_cycle;
      DutyCycle    cycle = average_cycle(n);
      while (needs_more_samples(cycle, n))
        cycle = average_cycle(n *= 2);
      return cycle;
    }



    DutyCycle
    IntegratedCycle::average_cycle(const unsigned int n_samples)
    {
      constexpr unsigned int min_cycles = 5;
      const unsigned int     most       = parameters.averaged_cycles;
      CycleRecorder          all(equations, most * n_samples, most * period);
      all.set_energy_account(kept_account());
      unsigned int  n       = 0;
      unsigned long n_steps = 0;
      while (n < most && (n < min_cycles || all.scatter_of_wear(n, n_samples) >
                                              parameters.settling_tolerance))
        n_steps += record_cycles(1, n_samples, all, n++);
      all.keep(n * n_samples, n * period);
      DutyCycle cycle = all.make_duty_cycle(integrator.events(), begin_time);
      cycle.average_over(n);
      n_steps_in_cycle           = n_steps / n;
      settling.n_averaged_cycles = n;
      return cycle;
    }
  } // namespace Multibody
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_motion_motion_integrator_h
#define tribody_multibody_motion_motion_integrator_h

#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/mechanism_state.h>
#include <tribody/sundials/ida_integrator.h>

#include <memory>
#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    /// Errors of one step that are tolerated, per coordinate.
    struct MotionTolerances
    {
      /// Of q [m, rad].
      Eigen::VectorXd positions;
      /// Of v [m/s, rad/s].
      Eigen::VectorXd velocities;
      /// Of the states of friction laws [m].
      Eigen::VectorXd friction_states = Eigen::VectorXd();
      /// Highest order of BDF, 1 to 5.
      unsigned int maximum_order = 5;
      /// Longest step [s]; 0: no limit.
      double maximum_step = 0.;
      /// First step after a start or an impact [s]; 0: estimated.
      double initial_step = 0.;
    };

    class EnergyAccount;
    struct ImpactJoint;

    /// A contact began or ended.
    struct ContactEvent
    {
      /// Time [s].
      double time;
      /// Index into Mechanism::clearance_joints(); its impact_joints() are
      /// counted on from there.
      unsigned int joint;
      /// Whether it began, else it ended.
      bool is_onset;
      /// Penetration rate at that time [m/s].
      double penetration_rate;
      /// Of a loss: largest total force in the contact that ends [N].
      double peak_force;
      /// Normal impulse [N s] of an impact between rigid surfaces, whose onset
      /// and end are at one time.
      double impulse = 0.;
    };

    /**
     * Integrates the motion of a mechanism in the stabilised index-2 form of
     * @cite gear1985,
     * @f[ \dot q = v + \Phi_q^T\mu, \quad M\dot v = Q - \Phi_q^T\lambda,
     *     \quad 0 = \Phi, \quad 0 = \Phi_q v + \Phi_t, @f]
     * by IDA with the exact Jacobian. It stops where a contact begins, takes
     * the approach speed there and restarts; the ends of contacts are noted.
     * States of friction laws are integrated along, @f$\dot z =
     * \dot z(q,v,z)@f$; mechanisms without them have no such equations.
     *
     * Where a pin with impacts reaches the bore, or the force of one that
     * follows it falls to zero, the integration stops: see IntermittentMotion.
     */
    class MotionIntegrator
    {
    public:
      /// Keeps a reference to @p equations.
      MotionIntegrator(const EquationsOfMotion &equations,
                       const MotionTolerances  &tolerances);

      ~MotionIntegrator();

      /// Start from a state that fulfils the constraints. Contacts that exist
      /// begin with the floor of the approach speed, and with the steady state
      /// of friction if the state does not have one.
      void
      start(const MechanismState &state);

      /// Go on from a state in which contacts and what has been recorded so
      /// far remain. A positive @p initial_step [s] is that of the first step.
      void
      resume(const MechanismState &state, const double initial_step);
      /// Book the motion from now on to @p account, which must stay alive; to
      /// none if it is the null pointer.
      void
      set_energy_account(EnergyAccount *account);

      /// The same without opening it anew: to be followed by resume().
      void
      continue_energy_account(EnergyAccount *account)
      {
        energy_account = account;
      }

      /**
       * Go on to time @p t [s], at least as late as before.
       * @param maximum_steps in this cycle, of which @p n_steps_before have
       *   been taken before. @throws ExcRun beyond.
       * @return the state at @p t, or where it stopped: see has_stopped().
       */
      const MechanismState &
      advance_to(const double        t,
                 const unsigned long maximum_steps,
                 const unsigned long n_steps_before = 0);

      /// Whether the last advance_to() had to stop before its time.
      bool
      has_stopped() const
      {
        return stop_is_pending && current.time == ida->time();
      }

      /// Where advance_to() arrived last.
      const MechanismState &
      state() const
      {
        return current;
      }

      /// Joints at which it stopped: indices into Mechanism::impact_joints().
      const std::vector<unsigned int> &
      stops() const
      {
        return the_stops;
      }

      /// Contacts that began or ended since start().
      const std::vector<ContactEvent> &
      events() const
      {
        return the_events;
      }

      /// Largest total force of each clearance joint [N] at any internal step
      /// since start().
      const std::vector<double> &
      peak_forces() const
      {
        return the_peak_forces;
      }

      /// Largest entry of Phi at any internal step since start() [m, rad].
      double
      constraint_drift() const
      {
        return the_drift;
      }

      /// Costs so far, summed over restarts.
      Sundials::IntegratorStatistics
      statistics() const;

    private:
      Sundials::ImplicitSystem
      make_system();

      Sundials::IdaSettings
      make_settings(const MotionTolerances &tolerances) const;

      void
      assemble_residual(const Sundials::ImplicitSystem::ConstVector &y,
                        const Sundials::ImplicitSystem::ConstVector &y_t,
                        const double                                 t,
                        Sundials::ImplicitSystem::Vector            &residual);

      void
      assemble_jacobian(const Sundials::ImplicitSystem::ConstVector &y,
                        const double                                 t,
                        const double                                 c,
                        MatrixEntries                               &entries);

      // Penetrations of contacts and flying pins, forces of following ones;
      // then, as many again, rates of the penetration of flying pins.
      void
      evaluate_roots(const double                                 t,
                     const Sundials::ImplicitSystem::ConstVector &y,
                     double                                      *values);

      // Start IDA at `current`, with accelerations from the exact equations.
      void
      restart(const double initial_step = 0.);

      // Take over what IDA has reached where it stopped. Contacts that begin
      // there get their approach speed and fresh friction.
      void
      take_stop();

      // For messages: which joint is pressed most, and how deep.
      std::string
      describe_deepest_contact() const;

      // What the unknowns of IDA say.
      MechanismState
      state_of(const double                             t,
               const Eigen::Ref<const Eigen::VectorXd> &y) const;

      // Whether a flying pin has left its bore with y and still moves away.
      bool
      goes_outside(const ImpactJoint &joint, const Eigen::VectorXd &y) const;

      // After a step: note drift and events; make a contact onset pending.
      void
      record_step(const std::vector<int> &roots);

      // Book the motion up to time t, which lies within the last step.
      void
      book_energy(const double t);

      // The state at time t within the last step.
      MechanismState
      state_at(const double t);

      const EquationsOfMotion &equations;
      const unsigned int       n;
      const unsigned int       m;
      const unsigned int       n_states;

      std::unique_ptr<Sundials::IdaIntegrator> ida;
      MechanismState                           current;
      bool                                     restart_is_pending = false;
      EnergyAccount                           *energy_account     = nullptr;

      std::vector<unsigned int> the_stops;
      bool                      stop_is_pending = false;
      std::vector<ContactEvent> the_events;
      std::vector<double>       the_peak_forces;
      // Of the present or last contact of each joint.
      std::vector<double> contact_peak_forces;
      double              the_drift = 0.;

      // Work space.
      Eigen::VectorXd phi;
      Eigen::VectorXd forces;
      Eigen::VectorXd interpolated;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

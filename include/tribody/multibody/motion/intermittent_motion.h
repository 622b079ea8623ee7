// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_motion_intermittent_motion_h
#define tribody_multibody_motion_intermittent_motion_h

#include <tribody/multibody/motion/motion_integrator.h>
#include <tribody/multibody/system/mechanism.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * The motion of a mechanism whose joints may have impacts. In between it
     * is that of MotionIntegrator, with a mechanism for each combination of
     * flying and following pins, made when it is first needed. Without such
     * joints there is one, and nothing to do.
     *
     * A pin that reaches the bore with the approach speed @f$\dot\delta^-@f$
     * gets the normal and tangential impulses @f$P_n, P_t@f$ of momentum
     * balance, all constraints holding,
     * @f[ M\,\Delta v + \Phi_q^T\Lambda = -N^T P_n - T^T P_t, \qquad
     *     \Phi_q\,\Delta v = 0, @f]
     * where @f$ \dot\delta = N v @f$ and the sliding speed is @f$ T v @f$:
     * @f$ \dot\delta^+ = -e_r\dot\delta^- @f$ (Newton's restitution), and the
     * surfaces stick if @f$ |P_t| \le \mu P_n @f$ is enough for that, else
     * @f$ P_t = \mu P_n @f$ against the sliding.
     *
     * Of pins that hit at the same time each has the restitution of its own
     * speed before; one that the impulses of others lift off has none.
     * Pins that begin to approach the bore by that hit next, until none does.
     *
     * An approach slower than the capture speed has no restitution; the pin
     * then follows the bore, if it presses, until the force that keeps it there
     * falls to zero.
     */
    class IntermittentMotion
    {
    public:
      /// Keeps a reference to @p equations.
      IntermittentMotion(const EquationsOfMotion &equations,
                         const MotionTolerances  &tolerances);

      /// As MotionIntegrator::start(). Pins that touch the bore without moving
      /// away from it, and press, follow it, whatever @p state says of that.
      void
      start(const MechanismState &state);

      /// As MotionIntegrator::set_energy_account(). What impacts take is
      /// booked.
      void
      set_energy_account(EnergyAccount *account);

      /// Where advance_to() arrived last.
      const MechanismState &
      state() const
      {
        return present->integrator->state();
      }

      /// As MotionIntegrator::advance_to().
      const MechanismState &
      advance_to(const double        t,
                 const unsigned long maximum_steps,
                 const unsigned long n_steps_before = 0);

      /// Equations of the present combination. The mechanism has the same
      /// joints and the same coordinates.
      const EquationsOfMotion &
      present_equations() const
      {
        return *present->equations;
      }

      /// As those of MotionIntegrator, over all combinations.
      const std::vector<ContactEvent> &
      events() const
      {
        return the_events;
      }

      /// Largest total force of each joint [N] at any internal step since
      /// start(): clearance joints, then those with impacts, as in events().
      std::vector<double>
      peak_forces() const;

      /// Largest entry of Phi at any internal step since start() [m, rad].
      double
      constraint_drift() const;

      /// Costs so far, the sum over all combinations.
      Sundials::IntegratorStatistics
      statistics() const;

    private:
      // One combination of flying and following pins, as
      // MechanismState::is_following.
      using Combination = std::vector<bool>;

      struct Mode
      {
        std::unique_ptr<const Mechanism>         own_mechanism;
        std::unique_ptr<const EquationsOfMotion> own_equations;
        const EquationsOfMotion                 *equations = nullptr;
        std::unique_ptr<MotionIntegrator>        integrator;
        // Of its events, how many are in the_events.
        std::size_t n_events_taken = 0;
      };

      // A pin that hits, and e_r.
      struct Impact
      {
        unsigned int joint;
        double       restitution;
      };

      // Of pins that hit at the same time.
      struct Impulses
      {
        // One per pin.
        std::vector<double> normal          = {};
        Eigen::VectorXd     velocity_change = Eigen::VectorXd();
        // A follower that would have to be pulled; -1: none.
        int pulled = -1;
      };

      Mode &
      mode(const Combination &combination);

      // Whether the pin is at its bore.
      bool
      touches(const unsigned int joint, const MechanismState &state) const;

      // Rate of its penetration, and the derivative of that.
      double
      approach_speed(const unsigned int    joint,
                     const MechanismState &state) const;

      double
      approach_acceleration(const unsigned int     joint,
                            const MechanismState  &state,
                            const Eigen::VectorXd &a) const;

      // Add the pins that touch their bores and do not move away from them.
      void
      add_resting(const MechanismState &state, Combination &combination) const;

      // Let fly those pins of combination that would have to be pulled.
      Combination
      without_tension(Combination combination, const MechanismState &state);

      // Normal and tangential, of a pin that meets an inverse mass, for a
      // change of its normal and sliding speed; the latter as far as friction
      // can.
      Eigen::Vector2d
      compute_impulse(const unsigned int     joint,
                      const Eigen::Matrix2d &inverse_mass,
                      const Eigen::Vector2d &change,
                      const double           time) const;

      Impulses
      compute_impulses(const std::vector<Impact> &impacts,
                       const EquationsOfMotion   &in_mode,
                       const MechanismState      &state) const;

      // What happens at a stop, and on from there.
      void
      resolve_stops();

      // Impacts of pins at their bores until none moves outwards any more;
      // which of them have hit.
      std::vector<bool>
      collide_all(Combination &combination, MechanismState &state);

      // The velocities after impacts of these joints at the same time, and
      // their normal impulses; pins that are captured follow.
      std::vector<double>
      collide(const std::vector<unsigned int> &joints,
              Combination                     &combination,
              MechanismState                  &state);

      // Throw, naming the joint, unless its impacts at this time end.
      void
      check_endless(const bool         ends,
                    const double       time,
                    const unsigned int joint) const;

      // Put the pins that follow onto their bores, should they not be there.
      void
      close_gaps(MechanismState &state);

      // A first step that is short beside the flights that begin.
      double
      initial_step(const EquationsOfMotion &in_mode,
                   const MechanismState    &state) const;

      // Bring in new events of the present mode.
      void
      collect_events();

      unsigned int
      n_contacts() const;

      std::string
      joint_name(const unsigned int impact_joint) const;

      const EquationsOfMotion    &equations;
      const MotionTolerances      tolerances;
      std::map<Combination, Mode> modes;
      Mode                       *present = nullptr;

      EnergyAccount            *energy_account = nullptr;
      std::vector<ContactEvent> the_events;
      double                    stop_time    = 0.;
      unsigned int              n_stops_here = 0;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_following_following_pins_h
#define tribody_multibody_following_following_pins_h

#include <Eigen/Core>

#include <tribody/multibody/joints/clearance_joint.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism_state.h>

#include <string>
#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    class EquationsOfMotion;
    struct RestingPin;

    /// How pins move in their bores: a column per joint with a gap, global
    /// axes.
    struct PinRates
    {
      /// de/dt [m/s].
      Eigen::Matrix2Xd velocities;
      /// d2e/dt2 [m/s^2].
      Eigen::Matrix2Xd accelerations;
    };

    /// One instant of a mechanism whose pins follow their bores.
    struct FollowingInstant
    {
      /// Of the mechanism with clearance.
      MechanismState state;
      /// Accelerations and multipliers of that mechanism.
      Accelerations accelerations;
      /// One per clearance joint.
      std::vector<JointContact> contacts;
      /// A column per joint with a gap: pin centre minus bushing centre [m],
      /// global axes.
      Eigen::Matrix2Xd eccentricities;
      /// Likewise the force of the pin on the bushing [N], global axes.
      Eigen::Matrix2Xd reactions;
    };

    /**
     * A mechanism whose pins do not leave their bores and do not vibrate in
     * them. Each pin rests where its reaction presses it, RestingPin; its place
     * moves the markers of the joint against each other, and the mechanism with
     * joints so displaced has no degree of freedom: its reactions follow from
     * inverse dynamics. Both are repeated until nothing changes, for each
     * instant on its own. The offsets are a small part of the links, so that
     * this takes a few rounds, however stiff the contact is.
     *
     * How the pins move in their bores is an argument: follow_cycle() finds it.
     * With degrees of freedom bodies have the velocities nearest to their
     * initial ones, which holds at the beginning only.
     *
     * The end of a massless link, or a pin that has impacts, rests in the
     * direction of the reaction at the distance of the clearance.
     */
    class FollowingPins
    {
    public:
      /// Whether it can be done at all: no degree of freedom with ideal joints,
      /// and no joints with impacts. If not, why.
      static std::string
      explain_unsuitable(const Mechanism &mechanism, const Mechanism &closed);

      /// @param equations with clearance joints; @param closed with ideal ones.
      /// Keeps references to both.
      FollowingPins(const EquationsOfMotion &equations,
                    const EquationsOfMotion &closed);

      /// Pins that do not move.
      PinRates
      no_rates() const;

      /// At time @p t [s], near the configuration @p q_guess, with the given
      /// motion of the pins in their bores.
      /// @throws ExcRun without a position or without an end of the rounds.
      FollowingInstant
      find(const double           t,
           const Eigen::VectorXd &q_guess,
           const PinRates        &rates) const;

      /// The same with everything at rest where the drivers are at time @p t:
      /// static equilibrium.
      FollowingInstant
      find_at_rest(const double t, const Eigen::VectorXd &q_guess) const;

      /// The configuration near @p q at time @p t [s] with the pins where the
      /// reactions among @p multipliers of the closed mechanism press them, at
      /// rest. @throws ExcRun if there is none.
      Eigen::VectorXd
      place(const double           t,
            const Eigen::VectorXd &q,
            const Eigen::VectorXd &multipliers) const;

      /// The configuration near @p q at time @p t [s] with pins at the given
      /// @p eccentricities in global axes [m], a column per joint with a gap.
      /// @throws ExcRun if there is none.
      Eigen::VectorXd
      place_at(const double            t,
               const Eigen::VectorXd  &q,
               const Eigen::Matrix2Xd &eccentricities) const;

      /// Of the closed mechanism's @p multipliers the forces of pins on
      /// bushings [N], a column per joint with a gap.
      Eigen::Matrix2Xd
      reactions(const Eigen::VectorXd &multipliers) const;

      /// By how much the reactions at @p instant change [N], a column per joint
      /// with a gap, if the pins have the further accelerations @p e_tt
      /// [m/s^2].
      Eigen::Matrix2Xd
      inertia_forces(const FollowingInstant &instant,
                     const Eigen::Matrix2Xd &e_tt) const;

      /// The numbers in Mechanism::joints() of the joints with a gap.
      const std::vector<unsigned int> &
      joints() const
      {
        return joint_numbers;
      }

      /// With clearance joints.
      const EquationsOfMotion &
      equations_of_motion() const
      {
        return equations;
      }

    private:
      FollowingInstant
      find_with(const double           t,
                const Eigen::VectorXd &q_guess,
                ConstraintOffsets      offsets) const;

      // The pins under the reactions of motion.
      std::vector<RestingPin>
      rest_pins(const Motion &motion) const;

      // The moments of their contacts on the bodies.
      Eigen::VectorXd
      moments_of(const std::vector<RestingPin> &pins) const;

      Eigen::Vector2d
      reaction(const std::size_t pin, const Eigen::VectorXd &multipliers) const
      {
        return multipliers.segment<2>(rows[pin]);
      }

      FollowingInstant
      make_instant(const double                   t,
                   const Motion                  &motion,
                   const std::vector<RestingPin> &pins) const;

      // Of the constraints that the mechanism shares with the closed one, and
      // of massless links.
      Eigen::VectorXd
      multipliers_with_gaps(const Motion &motion) const;

      const EquationsOfMotion &equations;
      const EquationsOfMotion &closed;

      // One entry per joint with a gap: its number, and the first row of its
      // constraint in the closed mechanism.
      std::vector<unsigned int> joint_numbers;
      std::vector<unsigned int> rows;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/base/significant_digits.h>
#include <tribody/base/solver_report.h>
#include <tribody/multibody/following/following_pins.h>
#include <tribody/multibody/following/resting_pin.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/mechanism.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // The offsets that hold the mechanism still where its drivers are.
      void
      stop_drivers(const EquationsOfMotion &closed,
                   const double             t,
                   ConstraintOffsets       &offsets)
      {
        closed.assemble_time_derivatives(t,
                                         offsets.first_derivative,
                                         offsets.second_derivative);
      }



      double
      cross(const Eigen::Vector2d &a, const Eigen::Vector2d &b)
      {
        return a.x() * b.y() - a.y() * b.x();
      }



      double
      minimum_approach_speed(const Mechanism  &mechanism,
                             const JointEntry &joint)
      {
        return mechanism.clearance_joints()[joint.index].minimum_approach_speed;
      }
    } // namespace



    std::string
    FollowingPins::explain_unsuitable(const Mechanism &mechanism,
                                      const Mechanism &closed)
    {
      if (closed.n_redundant() > mechanism.n_redundant())
        return "with ideal joints the mechanism is overconstrained, and the "
               "forces of its pins do not follow from their balance";
      if (closed.n_degrees_of_freedom() != 0)
        return "with ideal joints the mechanism has " +
               std::to_string(closed.n_degrees_of_freedom()) +
               " degrees of freedom left, which drivers must prescribe";
      for (const JointEntry &joint : mechanism.joints())
        if (joint.model == JointModel::impact)
          return "joint '" + joint.name + "' has the model 'impact'";
      return "";
    }



    FollowingPins::FollowingPins(const EquationsOfMotion &equations,
                                 const EquationsOfMotion &closed)
      : equations(equations)
      , closed(closed)
    {
      const Mechanism &ideal = closed.mechanism();
      for (unsigned int j = 0; j < ideal.joints().size(); ++j)
        if (equations.mechanism().joints()[j].has_gap())
          {
            joint_numbers.push_back(j);
            rows.push_back(
              ideal.constraints()[ideal.joints()[j].index].first_row);
          }
    }



    PinRates
    FollowingPins::no_rates() const
    {
      return {Eigen::Matrix2Xd::Zero(2, rows.size()),
              Eigen::Matrix2Xd::Zero(2, rows.size())};
    }



    FollowingInstant
    FollowingPins::find(const double           t,
                        const Eigen::VectorXd &q_guess,
                        const PinRates        &rates) const
    {
      ConstraintOffsets offsets(closed.mechanism().n_constraints());
      for (std::size_t p = 0; p < rows.size(); ++p)
        {
          offsets.first_derivative.segment<2>(rows[p]) =
            rates.velocities.col(p);
          offsets.second_derivative.segment<2>(rows[p]) =
            rates.accelerations.col(p);
        }
      return find_with(t, q_guess, offsets);
    }



    FollowingInstant
    FollowingPins::find_at_rest(const double           t,
                                const Eigen::VectorXd &q_guess) const
    {
      ConstraintOffsets offsets(closed.mechanism().n_constraints());
      stop_drivers(closed, t, offsets);
      return find_with(t, q_guess, offsets);
    }



    FollowingInstant
    FollowingPins::find_with(const double           t,
                             const Eigen::VectorXd &q_guess,
                             ConstraintOffsets      offsets) const
    {
      // Three or four rounds are usual. Later ones take half the way, which
      // helps where the reactions turn with the places of the pins.
      constexpr unsigned int many_rounds = 20, max_rounds = 100;
      // Of the eccentricities: the reactions are exact to a part of this as
      // small as the clearance is against the links.
      constexpr double tolerance = 1e-8;
      // Of the reactions: where a pin can rest in two places, either will do if
      // the reactions do not ask which.
      constexpr double indifference = 1e-3;

      Motion          motion = {q_guess, {}, {}, {}};
      Eigen::VectorXd moments =
        Eigen::VectorXd::Zero(closed.mechanism().n_coordinates());
      Eigen::VectorXd multipliers;
      for (unsigned int round = 0; round < max_rounds; ++round)
        {
          motion = solve_motion(closed, t, offsets, moments, motion.q);
          // Their squares too: lengths of vectors are taken below.
          AssertThrow(motion.q.allFinite() &&
                        std::isfinite(motion.v.squaredNorm()) &&
                        std::isfinite(motion.multipliers.squaredNorm()),
                      ExcRun("at time " + significant_digits(t, 6) +
                             " s the reactions of the joints, or speeds, are "
                             "not finite numbers"));
          const std::vector<RestingPin> pins   = rest_pins(motion);
          const double                  factor = round < many_rounds ? 1. : 0.5;
          double change = 0., force = 0., force_change = 0.;
          for (std::size_t p = 0; p < pins.size(); ++p)
            {
              const Eigen::Vector2d now  = reaction(p, motion.multipliers);
              auto                  e    = offsets.value.segment<2>(rows[p]);
              const Eigen::Vector2d step = pins[p].eccentricity - e;
              change =
                std::max(change, step.norm() / pins[p].eccentricity.norm());
              force = std::max(force, now.norm());
              if (round > 0)
                force_change =
                  std::max(force_change,
                           (now - reaction(p, multipliers)).norm());
              e += factor * step;
            }
          if (change < tolerance ||
              (round >= many_rounds && force_change < indifference * force))
            return make_instant(t, motion, pins);
          moments     = (1. - factor) * moments + factor * moments_of(pins);
          multipliers = motion.multipliers;
        }
      throw ExcRun("at time " + significant_digits(t, 6) +
                   " s no place was found where the pins rest in their "
                   "bushings, as their reactions turn with it");
    }



    Eigen::VectorXd
    FollowingPins::place(const double           t,
                         const Eigen::VectorXd &q,
                         const Eigen::VectorXd &multipliers) const
    {
      const Eigen::VectorXd         zero = Eigen::VectorXd::Zero(q.size());
      const std::vector<RestingPin> pins =
        rest_pins({q, zero, zero, multipliers});
      Eigen::Matrix2Xd eccentricities(2, pins.size());
      for (std::size_t p = 0; p < pins.size(); ++p)
        eccentricities.col(p) = pins[p].eccentricity;
      return place_at(t, q, eccentricities);
    }



    Eigen::VectorXd
    FollowingPins::place_at(const double            t,
                            const Eigen::VectorXd  &q,
                            const Eigen::Matrix2Xd &eccentricities) const
    {
      ConstraintOffsets offsets(closed.mechanism().n_constraints());
      for (std::size_t p = 0; p < rows.size(); ++p)
        offsets.value.segment<2>(rows[p]) = eccentricities.col(p);
      Eigen::VectorXd    result = q;
      const SolverReport report = solve_positions(closed, t, offsets, result);
      AssertThrow(report.converged,
                  ExcRun("The mechanism has no position with its pins at "
                         "their bores: " +
                         report.message));
      return result;
    }



    std::vector<RestingPin>
    FollowingPins::rest_pins(const Motion &motion) const
    {
      const Mechanism        &mechanism = equations.mechanism();
      std::vector<RestingPin> pins;
      for (std::size_t p = 0; p < rows.size(); ++p)
        {
          const JointEntry     &joint = mechanism.joints()[joint_numbers[p]];
          const Eigen::Vector2d force = reaction(p, motion.multipliers);
          if (joint.link != nullptr)
            {
              RestingPin end;
              end.eccentricity =
                joint.link->length * (force.norm() > 0
                                        ? Eigen::Vector2d(force.normalized())
                                        : Eigen::Vector2d::UnitX());
              end.normal_force = force.norm();
              pins.push_back(end);
              continue;
            }
          const JointContact contact =
            equations.compute_contact(joint.index,
                                      motion.q,
                                      motion.v,
                                      minimum_approach_speed(mechanism, joint));
          pins.push_back(find_resting_pin(
            equations, joint.index, motion, contact, force, 0.));
        }
      return pins;
    }



    Eigen::VectorXd
    FollowingPins::moments_of(const std::vector<RestingPin> &pins) const
    {
      const Mechanism &mechanism = equations.mechanism();
      Eigen::VectorXd forces = Eigen::VectorXd::Zero(mechanism.n_coordinates());
      for (std::size_t p = 0; p < pins.size(); ++p)
        {
          PairVector of_joint = PairVector::Zero();
          of_joint(2)         = pins[p].moments(0);
          of_joint(5)         = pins[p].moments(1);
          mechanism.joints()[joint_numbers[p]].bodies.add_to(of_joint, forces);
        }
      return forces;
    }



    FollowingInstant
    FollowingPins::make_instant(const double                   t,
                                const Motion                  &motion,
                                const std::vector<RestingPin> &pins) const
    {
      const Mechanism &mechanism = equations.mechanism();
      FollowingInstant instant;
      instant.state.time = t;
      instant.state.q    = motion.q;
      instant.state.v    = motion.v;
      instant.state.friction_states =
        Eigen::VectorXd::Zero(mechanism.n_friction_states());
      instant.accelerations = {motion.a, multipliers_with_gaps(motion)};
      instant.eccentricities.resize(2, pins.size());
      instant.reactions.resize(2, pins.size());
      for (std::size_t p = 0; p < pins.size(); ++p)
        {
          instant.eccentricities.col(p) = pins[p].eccentricity;
          instant.reactions.col(p)      = reaction(p, motion.multipliers);
          const JointEntry &joint       = mechanism.joints()[joint_numbers[p]];
          if (joint.link != nullptr)
            continue;
          const double speed = minimum_approach_speed(mechanism, joint);
          JointContact contact =
            equations.compute_contact(joint.index, motion.q, motion.v, speed);
          // Of the resting pin: the penetration is too small a part of the
          // coordinates to be told from them.
          const double turned_by =
            std::atan2(cross(contact.direction, pins[p].direction),
                       contact.direction.dot(pins[p].direction));
          contact.direction = pins[p].direction;
          contact.angle_in_bushing += turned_by;
          contact.angle_in_pin += turned_by;
          contact.sliding_speed    = pins[p].sliding_speed;
          contact.swing_speed      = pins[p].swing_speed;
          contact.penetration      = pins[p].penetration;
          contact.penetration_rate = 0.;
          contact.normal_force     = pins[p].normal_force;
          contact.tangential_force = pins[p].ratio * pins[p].normal_force;
          contact.pin_moment       = pins[p].moments(0);
          contact.bushing_moment   = pins[p].moments(1);
          instant.contacts.push_back(contact);
          instant.state.approach_speeds.push_back(speed);
          const ClearanceJoint &element =
            mechanism.clearance_joints()[joint.index];
          if (element.friction_state_index >= 0)
            instant.state.friction_states(element.friction_state_index) =
              compute_steady_friction_state(element.friction_law,
                                            contact.sliding_speed);
        }
      return instant;
    }



    Eigen::VectorXd
    FollowingPins::multipliers_with_gaps(const Motion &motion) const
    {
      const Mechanism &mechanism = equations.mechanism();
      const Mechanism &ideal     = closed.mechanism();
      Eigen::VectorXd  result(mechanism.n_constraints());
      const auto take = [&](const unsigned int to, const unsigned int from) {
        const NumberedConstraint &ours = mechanism.constraints()[to];
        const unsigned int        n    = ours.constraint->n_equations;
        result.segment(ours.first_row, n) =
          motion.multipliers.segment(ideal.constraints()[from].first_row, n);
      };
      for (unsigned int d = 0; d < mechanism.drivers().size(); ++d)
        take(mechanism.drivers()[d].constraint, ideal.drivers()[d].constraint);
      std::size_t p = 0;
      for (unsigned int j = 0; j < mechanism.joints().size(); ++j)
        {
          const JointEntry &joint = mechanism.joints()[j];
          if (!joint.has_gap())
            take(joint.index, ideal.joints()[j].index);
          else if (joint.link != nullptr)
            {
              // Its only multiplier is the force along the link.
              if (!joint.is_flying)
                result(mechanism.constraints()[joint.index].first_row) =
                  reaction(p, motion.multipliers).norm();
              ++p;
            }
          else
            ++p;
        }
      return result;
    }



    Eigen::Matrix2Xd
    FollowingPins::inertia_forces(const FollowingInstant &instant,
                                  const Eigen::Matrix2Xd &e_tt) const
    {
      // At rest and without forces, but for these accelerations.
      ConstraintOffsets offsets(closed.mechanism().n_constraints());
      stop_drivers(closed, instant.state.time, offsets);
      for (std::size_t p = 0; p < rows.size(); ++p)
        offsets.second_derivative.segment<2>(rows[p]) = e_tt.col(p);
      const Eigen::VectorXd zero =
        Eigen::VectorXd::Zero(instant.state.q.size());
      const Eigen::VectorXd multipliers =
        compute_accelerations(
          closed, instant.state.time, offsets, instant.state.q, zero, zero)
          .multipliers;
      return reactions(multipliers);
    }



    Eigen::Matrix2Xd
    FollowingPins::reactions(const Eigen::VectorXd &multipliers) const
    {
      Eigen::Matrix2Xd forces(2, rows.size());
      for (std::size_t p = 0; p < rows.size(); ++p)
        forces.col(p) = reaction(p, multipliers);
      return forces;
    }
  } // namespace Multibody
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/joints/clearance_joint.h>

#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // Derivatives with respect to (q_1, q_2, v_1, v_2).
      using Row   = Eigen::Matrix<double, 1, 12>;
      using Rows  = Eigen::Matrix<double, 2, 12>;
      using Rows3 = Eigen::Matrix<double, 3, 12>;

      constexpr int phi_1 = 2, phi_2 = 5, omega_1 = 8, omega_2 = 11;

      Row
      unit(const int k)
      {
        Row result = Row::Zero();
        result(k)  = 1.;
        return result;
      }



      double
      cross(const Eigen::Vector2d &a, const Eigen::Vector2d &b)
      {
        return a.x() * b.y() - a.y() * b.x();
      }



      Row
      D_cross(const Eigen::Vector2d &a,
              const Rows            &D_a,
              const Eigen::Vector2d &b,
              const Rows            &D_b)
      {
        return perpendicular(a).transpose() * D_b -
               perpendicular(b).transpose() * D_a;
      }



      // The pin as seen from the bushing: w = (e, alpha) in the bushing's frame
      // and its rate.
      struct RelativeMotion
      {
        RelativeMotion(const ClearanceJoint &joint,
                       const PairVector     &q,
                       const PairVector     &v)
          : a1(turned(joint.s_1, q(2)))
          , a2(turned(joint.s_2, q(5)))
          , e_global(q.head<2>() + a1 - q.segment<2>(3) - a2)
          , e_t_global(v.head<2>() + v(2) * perpendicular(a1) -
                       v.segment<2>(3) - v(5) * perpendicular(a2))
        {
          w << turned(e_global, -q(5)), q(2) - q(5);
          w_t << turned(e_t_global - v(5) * perpendicular(e_global), -q(5)),
            v(2) - v(5);
        }

        Eigen::Vector2d a1, a2, e_global, e_t_global;
        Eigen::Vector3d w, w_t;
      };



      // Everything about a contact that is needed for its derivatives too.
      struct Evaluation
      {
        RelativeMotion   motion;
        SupportedContact at;
        NormalForce      normal_law;
        FrictionRatio    friction;
        JointContact     contact;
      };



      // Sets forces and moments.
      void
      add_forces(const ClearanceJoint &joint,
                 const double          approach_speed,
                 const double          friction_state,
                 Evaluation           &e)
      {
        const SupportedContact &at      = e.at;
        JointContact           &contact = e.contact;
        ContactKinematics       kinematics{contact.penetration,
                                     contact.penetration_rate,
                                     approach_speed,
                                     at.elastic_force};
        e.normal_law = compute_normal_force(joint.contact_law, kinematics);
        e.friction   = compute_friction_ratio(joint.friction_law,
                                            contact.sliding_speed,
                                            friction_state);
        contact.normal_force  = at.force_ratio * e.normal_law.value;
        const double friction = e.friction.value * contact.normal_force;
        const double damping  = joint.tangential_damping * contact.swing_speed;
        contact.tangential_force = friction + damping;
        const Eigen::Vector2d moments =
          joint.compute_moments(at, contact.normal_force, friction, damping);
        contact.pin_moment     = moments(0);
        contact.bushing_moment = moments(1);
      }



      // Sets what the energy account asks for.
      void
      add_powers(const ClearanceJoint &joint,
                 const PairVector     &v,
                 const double          approach_speed,
                 Evaluation           &e)
      {
        const SupportedContact &at      = e.at;
        JointContact           &contact = e.contact;
        const Eigen::Vector2d   e_t     = e.motion.w_t.head<2>();
        // Of the points of contact against each other, along n.
        const double normal_speed =
          at.direction.dot(e_t) + v(2) * cross(at.pin_point, at.direction) -
          v(5) * cross(at.bushing_point - e.motion.w.head<2>(), at.direction);
        contact.normal_power = contact.normal_force * normal_speed;
        if (needs_support(joint.contact_law))
          {
            contact.elastic_power  = at.elastic_force * normal_speed;
            contact.elastic_energy = at.energy;
            return;
          }
        contact.elastic_power =
          compute_normal_force(joint.contact_law,
                               {contact.penetration, 0., approach_speed})
            .value *
          contact.penetration_rate;
      }



      Evaluation
      evaluate(const ClearanceJoint &joint,
               const PairVector     &q,
               const PairVector     &v,
               const JointCondition &condition,
               const double          approach_speed,
               const double          friction_state)
      {
        const RelativeMotion    motion(joint, q, v);
        const Eigen::Vector2d   e   = motion.w.head<2>();
        const Eigen::Vector2d   e_t = motion.w_t.head<2>();
        Evaluation              result{motion,
                          find_supported_contact(condition, e, motion.w(2)),
                          {},
                          {},
                          {}};
        const SupportedContact &at      = result.at;
        JointContact           &contact = result.contact;
        const Eigen::Vector2d   n = at.direction, t = perpendicular(n);
        const double            angle = std::atan2(n.y(), n.x());
        contact.eccentricity          = motion.e_global;
        contact.eccentricity_rate     = turned(e_t, q(5));
        contact.direction             = turned(n, q(5));
        contact.angle_in_bushing      = angle;
        contact.angle_in_pin          = angle - motion.w(2);
        contact.penetration           = at.penetration;
        contact.penetration_rate      = at.d_penetration * motion.w_t;
        contact.swing_speed           = t.dot(e_t);
        contact.sliding_speed         = contact.swing_speed / at.wrapping +
                                v(2) * n.dot(at.pin_point) -
                                v(5) * n.dot(at.bushing_point - e);
        // A spring-damper presses from the first touch on, at zero penetration.
        if (contact.penetration >= 0. && !at.d_penetration.isZero(0.))
          {
            add_forces(joint, approach_speed, friction_state, result);
            add_powers(joint, v, approach_speed, result);
          }
        return result;
      }



      // Derivatives of RelativeMotion. Here and below, D_x is that of x.
      struct MotionDerivatives
      {
        // Turns from the bushing's frame into global axes.
        Eigen::Matrix2d A;
        Rows3           D_w, D_w_t;
      };

      // k x a = quarter_turn() a.
      Eigen::Matrix2d
      quarter_turn()
      {
        Eigen::Matrix2d K;
        K << 0., -1., 1., 0.;
        return K;
      }



      MotionDerivatives
      differentiate_motion(const RelativeMotion &motion,
                           const PairVector     &q,
                           const PairVector     &v)
      {
        const Eigen::Vector2d a1 = motion.a1, a2 = motion.a2;
        Rows                  D_e = Rows::Zero();
        D_e.leftCols<2>().setIdentity();
        D_e.col(phi_1)       = perpendicular(a1);
        D_e.middleCols<2>(3) = -Eigen::Matrix2d::Identity();
        D_e.col(phi_2)       = -perpendicular(a2);
        Rows D_e_t           = Rows::Zero();
        D_e_t.rightCols<6>() = D_e.leftCols<6>();
        D_e_t.col(phi_1)     = -v(2) * a1;
        D_e_t.col(phi_2)     = v(5) * a2;

        // Relative to the bushing's turning, then in its frame.
        MotionDerivatives result;
        result.A << turned(Eigen::Vector2d::UnitX(), q(5)),
          turned(Eigen::Vector2d::UnitY(), q(5));
        const Eigen::Vector2d u =
          motion.e_t_global - v(5) * perpendicular(motion.e_global);
        const Rows D_u = D_e_t - v(5) * quarter_turn() * D_e -
                         perpendicular(motion.e_global) * unit(omega_2);
        result.D_w << result.A.transpose() *
                        (D_e - perpendicular(motion.e_global) * unit(phi_2)),
          unit(phi_1) - unit(phi_2);
        result.D_w_t << result.A.transpose() *
                          (D_u - perpendicular(u) * unit(phi_2)),
          unit(omega_1) - unit(omega_2);
        return result;
      }



      // Derivatives of where and how pin and bushing touch: n, t = k x n, the
      // points of contact x and y as in ClearanceJoint, and speeds.
      struct ContactDerivatives
      {
        Rows D_n, D_t, D_x, D_y;
        Row  D_delta, D_delta_t, D_swing, D_sliding, D_wrapping;
      };

      ContactDerivatives
      differentiate_contact(const Evaluation        &evaluation,
                            const MotionDerivatives &derivatives,
                            const PairVector        &v)
      {
        const RelativeMotion   &motion  = evaluation.motion;
        const SupportedContact &at      = evaluation.at;
        const JointContact     &contact = evaluation.contact;
        const Rows3            &D_w     = derivatives.D_w;
        const Rows3            &D_w_t   = derivatives.D_w_t;
        const Eigen::Vector2d   n = at.direction, t = perpendicular(n);
        const Eigen::Vector2d   e_t = motion.w_t.head<2>();

        ContactDerivatives result;
        result.D_n       = at.d_direction * D_w;
        result.D_t       = quarter_turn() * result.D_n;
        result.D_delta   = at.d_penetration * D_w;
        result.D_delta_t = at.d_penetration * D_w_t +
                           motion.w_t.transpose() * at.d2_penetration * D_w;
        result.D_swing =
          t.transpose() * D_w_t.topRows<2>() + e_t.transpose() * result.D_t;
        result.D_y                  = at.d_pin_point * D_w;
        result.D_x                  = at.d_bushing_point * D_w;
        const Eigen::Vector2d x_e   = at.bushing_point - motion.w.head<2>();
        const Rows            D_x_e = result.D_x - D_w.topRows<2>();
        result.D_wrapping           = at.d_wrapping * D_w;
        result.D_sliding =
          (result.D_swing -
           contact.swing_speed / at.wrapping * result.D_wrapping) /
            at.wrapping +
          n.dot(at.pin_point) * unit(omega_1) - n.dot(x_e) * unit(omega_2) +
          v(2) * (n.transpose() * result.D_y +
                  at.pin_point.transpose() * result.D_n) -
          v(5) * (n.transpose() * D_x_e + x_e.transpose() * result.D_n);
        return result;
      }



      // Derivatives of the generalised forces.
      Eigen::Matrix<double, 6, 12>
      differentiate_force(const ClearanceJoint     &joint,
                          const Evaluation         &evaluation,
                          const MotionDerivatives  &motion,
                          const ContactDerivatives &D)
      {
        const JointContact     &contact = evaluation.contact;
        const SupportedContact &at      = evaluation.at;
        const NormalForce      &law     = evaluation.normal_law;
        const FrictionRatio    &ratio   = evaluation.friction;
        const Eigen::Vector2d   n = at.direction, t = perpendicular(n);
        const Row               D_normal =
          at.force_ratio *
            (law.d_penetration * D.D_delta +
             law.d_penetration_rate * D.D_delta_t +
             law.d_elastic_force * (at.d_elastic_force * motion.D_w)) +
          law.value * (at.d_force_ratio * motion.D_w);
        const double normal = contact.normal_force;
        const Row    D_friction =
          ratio.value * D_normal + normal * ratio.d_sliding_speed * D.D_sliding;
        const Row D_tangential =
          D_friction + joint.tangential_damping * D.D_swing;
        const Row D_wrapped =
          joint.pin_radius * ((at.wrapping - 1.) * D_friction +
                              ratio.value * normal * D.D_wrapping);

        const double          tangential = contact.tangential_force;
        const Eigen::Vector2d b          = normal * n + tangential * t;
        const Rows            D_b =
          n * D_normal + normal * D.D_n + t * D_tangential + tangential * D.D_t;
        const Row D_pin_moment =
          -D_cross(at.pin_point, D.D_y, b, D_b) - D_wrapped;
        const Row D_bushing_moment =
          D_cross(at.bushing_point, D.D_x, b, D_b) + D_wrapped;

        const Eigen::Vector2d a1       = evaluation.motion.a1,
                              a2       = evaluation.motion.a2;
        const Eigen::Vector2d b_global = contact.force();
        const Rows            D_global =
          motion.A * D_b + perpendicular(b_global) * unit(phi_2);
        Eigen::Matrix<double, 6, 12> D_force;
        D_force.topRows<2>() = -D_global;
        D_force.row(2)       = -perpendicular(a1).transpose() * D_global +
                         a1.dot(b_global) * unit(phi_1) + D_pin_moment;
        D_force.middleRows<2>(3) = D_global;
        D_force.row(5)           = perpendicular(a2).transpose() * D_global -
                         a2.dot(b_global) * unit(phi_2) + D_bushing_moment;
        return D_force;
      }



      // What depends on the state of the friction law, and its rate.
      void
      add_state_derivatives(const ClearanceJoint &joint,
                            const PairVector     &q,
                            const Evaluation     &evaluation,
                            const Row            &D_sliding,
                            const double          friction_state,
                            ClearanceForce       &result)
      {
        const JointContact &contact = evaluation.contact;
        // The state acts on friction alone.
        JointContact per_state;
        per_state.direction = contact.direction;
        per_state.tangential_force =
          contact.normal_force * evaluation.friction.d_state;
        const Eigen::Vector2d moments = joint.compute_moments(
          evaluation.at, 0., per_state.tangential_force, 0.);
        per_state.pin_moment     = moments(0);
        per_state.bushing_moment = moments(1);
        result.d_state           = joint.compute_force(q, per_state);

        const FrictionStateRate rate =
          compute_friction_state_rate(joint.friction_law,
                                      contact.sliding_speed,
                                      friction_state);
        result.rate_d_position = rate.d_sliding_speed * D_sliding.leftCols<6>();
        result.rate_d_velocity =
          rate.d_sliding_speed * D_sliding.rightCols<6>();
        result.rate_d_state = rate.d_state;
      }
    } // namespace



    JointCondition
    ClearanceJoint::make_condition(
      const JointClearance                    &clearance,
      const std::shared_ptr<const PinSupport> &support) const
    {
      return {PinInBore(clearance, pin_radius, penetration_measure),
              needs_support(contact_law) ? support : nullptr};
    }



    JointContact
    ClearanceJoint::compute_contact(const PairVector     &q,
                                    const PairVector     &v,
                                    const JointCondition &condition,
                                    const double          approach_speed,
                                    const double          friction_state) const
    {
      return evaluate(*this, q, v, condition, approach_speed, friction_state)
        .contact;
    }



    double
    ClearanceJoint::compute_friction_state_rate(
      const JointContact &contact,
      const double        friction_state) const
    {
      return contact.penetration > 0
               ? Multibody::compute_friction_state_rate(friction_law,
                                                        contact.sliding_speed,
                                                        friction_state)
                   .value
               : 0.;
    }



    double
    ClearanceJoint::compute_penetration(const PairVector     &q,
                                        const JointCondition &condition) const
    {
      const RelativeMotion motion(*this, q, PairVector::Zero());
      return condition.surfaces.compute_penetration(motion.w.head<2>(),
                                                    motion.w(2));
    }



    Eigen::Vector2d
    ClearanceJoint::compute_moments(const SupportedContact &at,
                                    const double            normal_force,
                                    const double            friction_force,
                                    const double            damping_force) const
    {
      const Eigen::Vector2d b =
        normal_force * at.direction +
        (friction_force + damping_force) * perpendicular(at.direction);
      // Friction of opposite points of the contact has a moment but no force.
      const double wrapped = pin_radius * friction_force * (at.wrapping - 1.);
      return {-cross(at.pin_point, b) - wrapped,
              cross(at.bushing_point, b) + wrapped};
    }



    PairVector
    ClearanceJoint::compute_force(const PairVector   &q,
                                  const JointContact &contact) const
    {
      const Eigen::Vector2d a1 = turned(s_1, q(2)), a2 = turned(s_2, q(5));
      const Eigen::Vector2d b = contact.force();
      PairVector            result;
      result << -b, -cross(a1, b) + contact.pin_moment, b,
        cross(a2, b) + contact.bushing_moment;
      return result;
    }



    ClearanceForce
    ClearanceJoint::compute_force_with_derivatives(
      const PairVector     &q,
      const PairVector     &v,
      const JointCondition &condition,
      const double          approach_speed,
      const double          friction_state) const
    {
      const Evaluation evaluation =
        evaluate(*this, q, v, condition, approach_speed, friction_state);
      ClearanceForce result;
      result.force.setZero();
      result.d_position.setZero();
      result.d_velocity.setZero();
      if (evaluation.contact.penetration < 0 ||
          evaluation.at.d_penetration.isZero(0.))
        return result;

      // The chain rule, quantity by quantity as in evaluate().
      const MotionDerivatives motion =
        differentiate_motion(evaluation.motion, q, v);
      const ContactDerivatives contact =
        differentiate_contact(evaluation, motion, v);
      const Eigen::Matrix<double, 6, 12> D_force =
        differentiate_force(*this, evaluation, motion, contact);
      result.force      = compute_force(q, evaluation.contact);
      result.d_position = D_force.leftCols<6>();
      result.d_velocity = D_force.rightCols<6>();
      if (friction_state_index >= 0)
        add_state_derivatives(
          *this, q, evaluation, contact.D_sliding, friction_state, result);
      return result;
    }
  } // namespace Multibody
} // namespace Tribody

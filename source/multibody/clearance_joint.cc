#include <tribody/multibody/clearance_joint.h>
#include <tribody/surface/clearance_profile.h>

#include <limits>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // Derivatives with respect to (q_1, q_2, v_1, v_2).
      using Row  = Eigen::Matrix<double, 1, 12>;
      using Rows = Eigen::Matrix<double, 2, 12>;

      constexpr int phi_1 = 2, phi_2 = 5, omega_1 = 8, omega_2 = 11;

      // Below this eccentricity the direction of e has no meaning.
      constexpr double smallest_eccentricity =
        std::numeric_limits<double>::min();

      Row
      unit(const int k)
      {
        Row result = Row::Zero();
        result(k)  = 1.;
        return result;
      }
    } // namespace



    JointContact
    ClearanceJoint::compute_contact(const PairVector       &q,
                                    const PairVector       &v,
                                    const ClearanceProfile &clearance,
                                    const double            approach_speed,
                                    const double friction_state) const
    {
      const Eigen::Vector2d a1 = turned(s_1, q(2)), a2 = turned(s_2, q(5));
      JointContact          contact;
      contact.eccentricity = q.head<2>() + a1 - q.segment<2>(3) - a2;
      const double r       = contact.eccentricity.norm();
      if (r > smallest_eccentricity)
        contact.direction = contact.eccentricity / r;
      const Eigen::Vector2d n = contact.direction, t = perpendicular(n);
      const double          angle = std::atan2(n.y(), n.x());
      contact.angle_in_pin        = angle - q(2);
      contact.angle_in_bushing    = angle - q(5);

      const Eigen::Vector2d e_t = v.head<2>() + v(2) * perpendicular(a1) -
                                  v.segment<2>(3) - v(5) * perpendicular(a2);
      const ClearanceProfile::Values c =
        clearance.evaluate(contact.angle_in_bushing);
      contact.bushing_arm = pin_radius + c.clearance;
      contact.swing_speed = t.dot(e_t) - v(5) * r;
      contact.sliding_speed =
        t.dot(e_t) + pin_radius * v(2) - contact.bushing_arm * v(5);

      contact.penetration      = r - c.clearance;
      contact.penetration_rate = n.dot(e_t);
      if (r > smallest_eccentricity)
        contact.penetration_rate -=
          c.first_derivative * contact.swing_speed / r;

      // A spring-damper presses from the first touch on, at zero penetration.
      if (contact.penetration >= 0 && r > smallest_eccentricity)
        {
          contact.normal_force = compute_normal_force(contact_law,
                                                      {contact.penetration,
                                                       contact.penetration_rate,
                                                       approach_speed})
                                   .value;
          contact.tangential_force =
            compute_friction_ratio(friction_law,
                                   contact.sliding_speed,
                                   friction_state)
                .value *
              contact.normal_force +
            tangential_damping * contact.swing_speed;
        }
      return contact;
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
    ClearanceJoint::compute_penetration(const PairVector       &q,
                                        const ClearanceProfile &clearance) const
    {
      const Eigen::Vector2d e =
        marker_position(q.head<3>(), s_1) - marker_position(q.tail<3>(), s_2);
      return e.norm() - clearance.clearance(std::atan2(e.y(), e.x()) - q(5));
    }



    PairVector
    ClearanceJoint::compute_force(const PairVector   &q,
                                  const JointContact &contact) const
    {
      const Eigen::Vector2d a1 = turned(s_1, q(2)), a2 = turned(s_2, q(5));
      const Eigen::Vector2d b = contact.force();
      PairVector            result;
      // Of the moment of b at the contact point p + R n, the part of R n is R
      // times the tangential force; on a worn bore R + c takes R_j's place.
      result << -b,
        -perpendicular(a1).dot(b) - pin_radius * contact.tangential_force, b,
        perpendicular(a2).dot(b) +
          contact.bushing_arm * contact.tangential_force;
      return result;
    }



    ClearanceForce
    ClearanceJoint::compute_force_with_derivatives(
      const PairVector       &q,
      const PairVector       &v,
      const ClearanceProfile &clearance,
      const double            approach_speed,
      const double            friction_state) const
    {
      const JointContact contact =
        compute_contact(q, v, clearance, approach_speed, friction_state);
      ClearanceForce result;
      if (contact.penetration < 0 ||
          contact.eccentricity.norm() <= smallest_eccentricity)
        {
          result.force.setZero();
          result.d_position.setZero();
          result.d_velocity.setZero();
          return result;
        }

      // The chain rule, quantity by quantity as in compute_contact(); D_x is
      // the derivative of x, psi the angle of n.
      const Eigen::Vector2d a1 = turned(s_1, q(2)), a2 = turned(s_2, q(5));
      const Eigen::Vector2d n = contact.direction, t = perpendicular(n);
      const double          r = contact.eccentricity.norm();

      Rows D_e = Rows::Zero();
      D_e.leftCols<2>().setIdentity();
      D_e.col(phi_1)       = perpendicular(a1);
      D_e.middleCols<2>(3) = -Eigen::Matrix2d::Identity();
      D_e.col(phi_2)       = -perpendicular(a2);
      Rows D_e_t           = Rows::Zero();
      D_e_t.rightCols<6>() = D_e.leftCols<6>();
      D_e_t.col(phi_1)     = -v(2) * a1;
      D_e_t.col(phi_2)     = v(5) * a2;

      const Row D_r     = n.transpose() * D_e;
      const Row D_psi   = t.transpose() * D_e / r;
      const Row D_theta = D_psi - unit(phi_2);

      const double v_2            = v(5);
      const double e_t_tangential = contact.swing_speed + v_2 * r;
      const ClearanceProfile::Values c =
        clearance.evaluate(contact.angle_in_bushing);
      const double theta_t = contact.swing_speed / r;
      const double e_t_normal =
        contact.penetration_rate + c.first_derivative * theta_t;
      const Row D_e_t_normal = n.transpose() * D_e_t + e_t_tangential * D_psi;
      const Row D_e_t_tangential = t.transpose() * D_e_t - e_t_normal * D_psi;
      const Row D_swing   = D_e_t_tangential - v_2 * D_r - r * unit(omega_2);
      const Row D_arm     = c.first_derivative * D_theta;
      const Row D_sliding = D_e_t_tangential + pin_radius * unit(omega_1) -
                            contact.bushing_arm * unit(omega_2) - v_2 * D_arm;
      const Row D_theta_t = (D_swing - theta_t * D_r) / r;

      const Row D_delta   = D_r - D_arm;
      const Row D_delta_t = D_e_t_normal -
                            c.second_derivative * theta_t * D_theta -
                            c.first_derivative * D_theta_t;

      const NormalForce   f = compute_normal_force(contact_law,
                                                 {contact.penetration,
                                                    contact.penetration_rate,
                                                    approach_speed});
      const FrictionRatio m = compute_friction_ratio(friction_law,
                                                     contact.sliding_speed,
                                                     friction_state);
      const Row           D_normal =
        f.d_penetration * D_delta + f.d_penetration_rate * D_delta_t;
      const Row D_tangential = m.value * D_normal +
                               f.value * m.d_sliding_speed * D_sliding +
                               tangential_damping * D_swing;

      const Eigen::Vector2d b = contact.force();
      const Rows            D_b =
        n * D_normal + t * D_tangential + perpendicular(b) * D_psi;

      Eigen::Matrix<double, 6, 12> D_force;
      D_force.topRows<2>() = -D_b;
      D_force.row(2)       = -perpendicular(a1).transpose() * D_b +
                       a1.dot(b) * unit(phi_1) - pin_radius * D_tangential;
      D_force.middleRows<2>(3) = D_b;
      D_force.row(5) =
        perpendicular(a2).transpose() * D_b - a2.dot(b) * unit(phi_2) +
        contact.bushing_arm * D_tangential + contact.tangential_force * D_arm;

      result.force      = compute_force(q, contact);
      result.d_position = D_force.leftCols<6>();
      result.d_velocity = D_force.rightCols<6>();
      if (friction_state_index >= 0)
        {
          // The state acts on the tangential force alone.
          JointContact per_state;
          per_state.direction        = n;
          per_state.bushing_arm      = contact.bushing_arm;
          per_state.tangential_force = f.value * m.d_state;
          result.d_state             = compute_force(q, per_state);

          const FrictionStateRate rate =
            Multibody::compute_friction_state_rate(friction_law,
                                                   contact.sliding_speed,
                                                   friction_state);
          result.rate_d_position =
            rate.d_sliding_speed * D_sliding.leftCols<6>();
          result.rate_d_velocity =
            rate.d_sliding_speed * D_sliding.rightCols<6>();
          result.rate_d_state = rate.d_state;
        }
      return result;
    }
  } // namespace Multibody
} // namespace Tribody

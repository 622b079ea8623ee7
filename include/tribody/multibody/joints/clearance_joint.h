// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_joints_clearance_joint_h
#define tribody_multibody_joints_clearance_joint_h

#include <tribody/multibody/elements/pair_force.h>
#include <tribody/multibody/joints/contact_force_law.h>
#include <tribody/multibody/joints/friction_law.h>
#include <tribody/multibody/joints/joint_condition.h>

#include <string>

namespace Tribody
{
  namespace Multibody
  {
    /// What happens in a joint with clearance at one instant.
    struct JointContact
    {
      /// Pin centre minus bushing centre, e [m], global axes.
      Eigen::Vector2d eccentricity = Eigen::Vector2d::Zero();
      /// Its rate as seen from the bushing [m/s], global axes.
      Eigen::Vector2d eccentricity_rate = Eigen::Vector2d::Zero();
      /// n, the normal of the contact, into the bushing, global axes; for a
      /// round bore e/|e|.
      Eigen::Vector2d direction = Eigen::Vector2d::UnitX();
      /// Angle of n in the frame of the bushing's body [rad].
      double angle_in_bushing = 0.;
      /// Angle of n in the frame of the pin's body [rad].
      double angle_in_pin = 0.;
      /// delta [m], positive in contact.
      double penetration = 0.;
      /// Rate of delta [m/s], positive while the pin moves in.
      double penetration_rate = 0.;
      /// Velocity of the pin's surface relative to the bushing's along k x n
      /// [m/s].
      double sliding_speed = 0.;
      /// Swing of the pin's centre along k x n in the bushing's frame [m/s].
      double swing_speed = 0.;
      /// F_N [N], on the bushing along n.
      double normal_force = 0.;
      /// Friction and tangential damping [N], on the bushing along k x n.
      double tangential_force = 0.;
      /// Moment on the pin about its centre [N m].
      double pin_moment = 0.;
      /// Moment on the bushing about its centre [N m].
      double bushing_moment = 0.;
      /// Power of the normal force, taken from the bodies [W].
      double normal_power = 0.;
      /// What of it the surfaces store, to give it back [W].
      double elastic_power = 0.;
      /// Energy stored, for laws that know it; the others say zero [J].
      double elastic_energy = 0.;

      /// swing_speed and sliding_speed if the contact were where its normal is
      /// @p n, global axes: a pin in a worn bore may touch it in two places.
      double
      swing_speed_at(const Eigen::Vector2d &n) const
      {
        return perpendicular(n).dot(eccentricity_rate);
      }

      /// @copydoc swing_speed_at()
      double
      sliding_speed_at(const Eigen::Vector2d &n) const
      {
        return sliding_speed - swing_speed + swing_speed_at(n);
      }

      /// Force of the pin on the bushing [N], global axes.
      Eigen::Vector2d
      force() const
      {
        return normal_force * direction +
               tangential_force * perpendicular(direction);
      }
    };

    /// Forces of a joint with clearance with their derivatives, those with
    /// respect to the state z of its friction law included, and those of z'.
    struct ClearanceForce : PairForce
    {
      /// dQ/dz.
      PairVector d_state = PairVector::Zero();

      /// dz'/dq.
      Eigen::Matrix<double, 1, 6> rate_d_position =
        Eigen::Matrix<double, 1, 6>::Zero();
      /// dz'/dv.
      Eigen::Matrix<double, 1, 6> rate_d_velocity =
        Eigen::Matrix<double, 1, 6>::Zero();
      /// dz'/dz [1/s].
      double rate_d_state = 0.;
    };

    /**
     * A revolute joint with clearance: no constraint, but a force while the pin
     * (radius R_i, body 1) touches the bushing (body 2). With @f$ e = p_1 - p_2
     * @f$ in the bushing's frame and @f$\alpha = \varphi_1 - \varphi_2@f$,
     * PinInBore gives the penetration @f$\delta(e, \alpha)@f$, the normal n
     * and the points of contact: y on the pin, seen from its centre, and x on
     * the bushing, seen from its own. There is contact for @f$\delta>0@f$. The
     * forces act at these points, eqs. (12)-(20) of @cite mukras2010; friction
     * acts against the relative velocity of the *material* points there,
     * @f$ v_t = \dot e \cdot (k\times n) + \omega_1\, y \cdot n - \omega_2
     * (x - e) \cdot n @f$ with @f$\dot e@f$ in the bushing's frame.
     *
     * Under FiniteElementLaw the normal force is that of the PinSupport, and
     * friction acts at each point of the contact: as t = k x n there, its sum
     * is the ratio of the friction law times k x F, and its moment about the
     * pin's centre that ratio times R_i times the sum of magnitudes of the
     * normal forces. The ratio is that of the mean sliding speed, weighted with
     * the normal forces, so that friction takes energy whatever the contact.
     *
     * The damping coefficient @f$d_t@f$ acts on the swing of the pin's centre,
     * @f$ \dot e \cdot (k\times n) @f$, while there is contact:
     * no term of eq. (9) does, and friction that never reverses does not
     * either.
     *
     * A friction law with a state keeps it while there is no contact; a new
     * contact begins with zero.
     */
    struct ClearanceJoint
    {
      /// As in the parameters.
      std::string name;
      /// The first carries the pin, the second the bushing.
      BodyPair bodies;
      /// Centre of the pin in the frame of its body [m].
      Eigen::Vector2d s_1;
      /// Centre of the bushing in the frame of its body [m].
      Eigen::Vector2d s_2;
      /// R_i [m].
      double pin_radius;
      /// R_j [m].
      double bushing_radius;

      /// Gives F_N while there is contact.
      ContactForceLaw contact_law;
      /// Gives friction from F_N and the sliding speed.
      FrictionLaw friction_law;
      /// d_t [N s/m].
      double tangential_damping;
      /// Floor of the approach speed [m/s]: also its value for a motion that
      /// starts in contact, where none was seen.
      double minimum_approach_speed;
      /// Place of the friction law's state among those of the mechanism; -1 if
      /// it has none.
      int friction_state_index = -1;
      /// What penetration and direction are in a worn joint.
      PenetrationMeasure penetration_measure = PenetrationMeasure::deepest;

      /// As manufactured, R_j - R_i [m].
      double
      nominal_clearance() const
      {
        return bushing_radius - pin_radius;
      }

      /// The joint with the surfaces @p clearance. @p support: of its elastic
      /// surfaces; only used by FiniteElementLaw, which needs it.
      JointCondition
      make_condition(
        const JointClearance                    &clearance,
        const std::shared_ptr<const PinSupport> &support = nullptr) const;

      /// Everything about the contact but its derivatives.
      JointContact
      compute_contact(const PairVector     &q,
                      const PairVector     &v,
                      const JointCondition &condition,
                      const double          approach_speed,
                      const double          friction_state = 0.) const;

      /// Rate of the friction law's state that belongs to @p contact.
      double
      compute_friction_state_rate(const JointContact &contact,
                                  const double        friction_state) const;

      /// delta [m] alone, for root functions.
      double
      compute_penetration(const PairVector     &q,
                          const JointCondition &condition) const;

      /// Moments on the pin about its centre and on the bushing about its
      /// centre [N m], of forces on the bushing at the contact @p at: along n,
      /// and of friction and tangential damping along k x n.
      Eigen::Vector2d
      compute_moments(const SupportedContact &at,
                      const double            normal_force,
                      const double            friction_force,
                      const double            damping_force) const;

      /// Generalised forces that belong to @p contact.
      PairVector
      compute_force(const PairVector &q, const JointContact &contact) const;

      /// Forces with their exact derivatives.
      ClearanceForce
      compute_force_with_derivatives(const PairVector     &q,
                                     const PairVector     &v,
                                     const JointCondition &condition,
                                     const double          approach_speed,
                                     const double friction_state = 0.) const;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

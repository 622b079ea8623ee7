// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_motion_reference_scales_h
#define tribody_multibody_motion_reference_scales_h

#include <tribody/multibody/elements/body_pair.h>

#include <memory>
#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    class EquationsOfMotion;
    class Mechanism;
    class PinSupport;
    struct DynamicsParameters;
    struct MotionTolerances;

    /// What to expect in a joint with clearance; error weights are made of it.
    struct ReferenceScale
    {
      /// The bodies that the joint connects.
      BodyPair bodies;
      /// Mean joint force over a cycle with ideal joints [N].
      double force;
      /// Penetration under that force [m]; the clearance between rigid
      /// surfaces.
      double penetration;
      /// Angular frequency of the contact's vibration about it [rad/s];
      /// between rigid surfaces that of the pin's swing, a pendulum as long as
      /// the clearance under that force.
      double frequency;
      /// Smallest of three speeds [m/s] at which the joint force changes by
      /// its own size: penetration times frequency; the penetration rate that
      /// doubles the force by hysteresis; and where the sliding reverses, 3
      /// times the speed at which friction changes its sign.
      double speed;
      /// Largest lasting state of friction [m]; zero for laws without one.
      double friction_state;
      /// Whether the clearance is so large, more than 10 penetrations, that the
      /// pin flies and strikes.
      bool is_loose;
    };

    /**
     * The scales of all joints of @p mechanism that are not ideal. @p closed
     * are the equations of the same mechanism with ideal joints at those
     * places.
     *
     * The force is the mean of the ideal joint's reaction over a cycle; if that
     * is zero or not defined (degrees of freedom), the weight of the mechanism
     * under 1 m/s^2. The frequency is that of the contact stiffness
     * @f$ dF_N/d\delta @f$ and the mass that a force at the joint finds there
     * in the lightest direction.
     *
     * @param period of a cycle [s]; 0: one turn of the first driver.
     * @param supports of the joints with clearance, in their order, for those
     *   whose law needs one; such a joint is looked at in the direction of its
     *   mean force.
     */
    std::vector<ReferenceScale>
    compute_reference_scales(
      const Mechanism                                      &mechanism,
      const EquationsOfMotion                              &closed,
      const double                                          period   = 0.,
      const std::vector<std::shared_ptr<const PinSupport>> &supports = {});

    /**
     * Error weights: @f$ \varepsilon\,\delta @f$ for positions and
     * @f$\varepsilon@f$ times the speed scale for velocities of each body, from
     * the clearance joints that it belongs to, or the most sensitive one if
     * none. Relative tolerances would be useless: forces depend on penetrations
     * of micrometres in coordinates of metres. Without clearance joints, 1e-4
     * of the mechanism's size takes the place of the penetration, and its speed
     * is that length over the time of a cycle divided by 2 pi (one second if
     * there is no cycle).
     *
     * Joints in which the pin strikes need a tenth of these errors, because
     * every impact multiplies them. In return BDF may be of fifth order if
     * there are only such joints: the vibration of a tight one, which friction
     * and hysteresis hardly damp, it would excite.
     */
    MotionTolerances
    make_tolerances(const Mechanism                   &mechanism,
                    const std::vector<ReferenceScale> &scales,
                    const DynamicsParameters          &parameters);
  } // namespace Multibody
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_joints_pin_support_h
#define tribody_multibody_joints_pin_support_h

#include <Eigen/Core>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * What elastic surfaces do to a pin at a given place, with derivatives by
     * (e_x, e_y, alpha). All vectors are in the bushing's frame.
     */
    struct SupportForce
    {
      /// Normal forces of the pin on the bushing, added up [N].
      Eigen::Vector2d force = Eigen::Vector2d::Zero();
      /// Derivatives of the force [N/m, N/m, N].
      Eigen::Matrix<double, 2, 3> d_force = Eigen::Matrix<double, 2, 3>::Zero();
      /// Sum of their magnitudes [N]: larger than that of their sum if the
      /// contact wraps around the pin. Times mu R_i, the moment of friction.
      double magnitudes = 0.;
      /// Derivatives of that sum [N/m, N/m, N].
      Eigen::RowVector3d d_magnitudes = Eigen::RowVector3d::Zero();
      /// Of the normal forces on the pin about its centre [N m]: a round pin
      /// has none, a worn one is turned away from where it is high.
      double moment = 0.;
      /// Derivatives of the moment [N, N, N m].
      Eigen::RowVector3d d_moment = Eigen::RowVector3d::Zero();
      /// Energy stored in the surfaces [J].
      double energy = 0.;
    };

    /**
     * The elastic surfaces of a joint as the dynamics sees them: a contact
     * problem that somebody else solves. The force is the gradient of the
     * energy by e, the moment minus its derivative by alpha. Answers may depend
     * on the questions before by no more than their accuracy.
     */
    class PinSupport
    {
    public:
      virtual ~PinSupport() = default;

      /// Forces with the pin's centre at @p e [m], turned by @p alpha [rad].
      /// Zero where nothing touches. @throws ExcRun without a solution.
      virtual SupportForce
      compute_force(const Eigen::Vector2d &e, const double alpha) const = 0;

      /// Where the centre of a pin that is turned by @p alpha rests under @p
      /// force [N], not zero: the inverse of compute_force().
      virtual Eigen::Vector2d
      find_position(const Eigen::Vector2d &force, const double alpha) const = 0;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

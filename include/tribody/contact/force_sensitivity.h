// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_contact_force_sensitivity_h
#define tribody_contact_force_sensitivity_h

#include <Eigen/Core>

#include <tribody/contact/active_compliance.h>
#include <tribody/contact/contact_solution.h>
#include <tribody/contact/housing.h>

namespace Tribody
{
  namespace Contact
  {
    /**
     * The derivative of the nodal forces with respect to the gaps
     * @f$g^0@f$ of the undeformed bore, under a constant force on the pin. On
     * the nodes in contact it is @f$ -S @f$,
     * @f[ S = C_A^{-1} - y\,(m_A^T y + H)^{-1} y^T, \qquad
     *     y = C_A^{-1} m_A, \qquad
     *     H = -\sum_i \lambda_i \frac{I - m_i m_i^T}{|x_i - e|}, @f]
     * and zero elsewhere: the active set does not change under a small change
     * of the gaps. S is symmetric and, with the pin held by the force alone,
     * positive semi-definite.
     *
     * The object keeps C_A of the last active set: solutions with similar ones
     * should follow each other. The errors of ActiveCompliance matter to the
     * convergence of Newton's method only.
     */
    class ForceSensitivity
    {
    public:
      /**
       * @param positions of the undeformed bore nodes [m]; must outlive this
       *   object, and so must @p housing.
       * @param compliance C [m per N/m].
       * @param housing of a free ring, or nullptr. The nodes of the rim that
       *   touch it are then eliminated with the ring's place: S is the block of
       *   the bore.
       */
      ForceSensitivity(const Eigen::Matrix2Xd &positions,
                       const Compliance       &compliance,
                       const double            pin_radius,
                       const Housing          *housing = nullptr);

      /// S on the nodes of the bore in contact of @p solution [N/m per m].
      Eigen::MatrixXd
      compute(const ContactSolution &solution);

    private:
      template <int n_free>
      Eigen::MatrixXd
      compute(const ContactSolution &solution, const PinGap &gap);

      const Eigen::Matrix2Xd &positions;
      double                  pin_radius;
      const Housing          *housing;
      ActiveCompliance        active_compliance;
    };
  } // namespace Contact
} // namespace Tribody

#endif

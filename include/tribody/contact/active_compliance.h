#ifndef tribody_contact_active_compliance_h
#define tribody_contact_active_compliance_h

#include <Eigen/Cholesky>

#include <tribody/contact/contact_solution.h>

namespace Tribody
{
  namespace Contact
  {
    /**
     * The compliance restricted to the nodes in contact, factorised. The
     * factor is kept as long as the same nodes are asked for, from one
     * iteration to the next and from one sample to the next.
     */
    class ActiveCompliance
    {
    public:
      /// Restrict @p compliance to @p nodes.
      void
      update(const Eigen::MatrixXd &compliance, const ActiveSet &nodes);

      /// @f$ C_A^{-1} @f$ times @p right_hand_sides.
      Eigen::MatrixXd
      solve(const Eigen::Ref<const Eigen::MatrixXd> &right_hand_sides) const
      {
        return factor.solve(right_hand_sides);
      }

    private:
      ActiveSet                   active_set;
      Eigen::LLT<Eigen::MatrixXd> factor;
    };

    /**
     * The inverse of the stiffness @f$ m^T C_A^{-1} m @f$ [N/m^2] that the
     * nodes in contact hold the pin with. One node alone does not hold it
     * sideways; the pseudo-inverse then leaves it there.
     */
    Eigen::Matrix2d
    invert_pin_stiffness(const Eigen::Matrix2d &stiffness,
                         const Eigen::Index     n_active);
  } // namespace Contact
} // namespace Tribody

#endif

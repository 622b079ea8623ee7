#ifndef tribody_contact_active_compliance_h
#define tribody_contact_active_compliance_h

#include <Eigen/Cholesky>

#include <tribody/contact/contact_solution.h>

namespace Tribody
{
  namespace Contact
  {
    /**
     * The compliance restricted to the nodes in contact, @f$C_A@f$, ready to
     * solve with. It is kept as long as the same nodes are asked for, from one
     * iteration to the next and from one sample to the next.
     *
     * If asked to expect small changes, it keeps the inverse
     * @f$X = C_A^{-1}@f$ and follows the set of nodes: when the nodes K leave
     * and R remain, @f$ X \to X_{RR} - X_{RK} X_{KK}^{-1} X_{KR} @f$; when the
     * nodes N enter, with @f$ Y = X C_{AN} @f$ and
     * @f$ S = C_{NN} - C_{NA} Y @f$,
     * @f[ X \to \begin{pmatrix} X + Y S^{-1} Y^T & -Y S^{-1} \\
     *                           -S^{-1} Y^T & S^{-1} \end{pmatrix}, @f]
     * both in one sweep over X. That costs some @f$4 m^2@f$ operations per node
     * instead of the
     * @f$m^3/3@f$ of a new factor. The rounding errors of many changes add up;
     * iterations that correct what is left do not mind, and refresh() removes
     * them.
     */
    class ActiveCompliance
    {
    public:
      /**
       * Restrict @p compliance, of which always the same must be given, to
       * @p nodes.
       * @param expect_small_changes whether following the nodes will pay.
       */
      void
      update(const Eigen::MatrixXd &compliance,
             const ActiveSet       &nodes,
             const bool             expect_small_changes = false);

      /// @f$ C_A^{-1} @f$ times @p right_hand_sides.
      Eigen::MatrixXd
      solve(const Eigen::Ref<const Eigen::MatrixXd> &right_hand_sides) const;

      /// @f$ C_A^{-1} @f$, rows and columns in the order of the nodes.
      Eigen::MatrixXd
      compute_inverse();

      /// Factorise anew if changes were followed since that was last done.
      /// Returns whether there were any.
      bool
      refresh(const Eigen::MatrixXd &compliance);

    private:
      void
      factorise(const Eigen::MatrixXd &compliance);

      void
      invert();

      /// Let nodes leave the inverse and others enter it.
      void
      exchange(const Eigen::MatrixXd &compliance,
               const ActiveSet       &leaving,
               const ActiveSet       &entering);

      /// Give @p nodes the last places in the inverse. The places that they had
      /// are taken by those that were last.
      void
      move_to_end(const ActiveSet &nodes);

      ActiveSet active_set;

      /// Without the inverse.
      Eigen::LLT<Eigen::MatrixXd> factor;

      /// The inverse is the upper left corner of @p inverse, its rows in the
      /// order of @p order; @p place says where a node is in it, -1: nowhere.
      bool                      has_inverse = false;
      Eigen::MatrixXd           inverse;
      std::vector<Eigen::Index> order;
      std::vector<Eigen::Index> place;
      bool                      was_changed = false;
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

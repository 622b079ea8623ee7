// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_contact_active_compliance_h
#define tribody_contact_active_compliance_h

#include <Eigen/Cholesky>

#include <tribody/algebra/hierarchical_compliance.h>
#include <tribody/contact/compliance.h>
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
     * instead of the @f$m^3/3@f$ of a new factor. The rounding errors of many
     * changes add up; iterations that correct what is left do not mind, and
     * refresh() removes them.
     *
     * From 400 nodes on a HierarchicalCompliance is restricted to them instead,
     * which is exact to 1e-12 times the condition of @f$C_A@f$, some 1e3:
     * unless all of the inverse is wanted, which then takes longer than
     * following it.
     */
    class ActiveCompliance
    {
    public:
      /// What is wanted of it.
      enum class Use
      {
        /// solve().
        solving,
        /// solve() and compute_inverse().
        inverse
      };

      /// Of no nodes yet.
      explicit ActiveCompliance(const Compliance &compliance,
                                const Use         use = Use::solving)
        : compliance(compliance)
        , use(use)
      {}

      /**
       * Restrict the compliance to @p nodes.
       * @param expect_small_changes whether following the nodes will pay, as
       *   long as they are not many.
       */
      void
      update(const ActiveSet &nodes, const bool expect_small_changes = false);

      /// @f$ C_A^{-1} @f$ times @p right_hand_sides.
      Eigen::MatrixXd
      solve(const Eigen::Ref<const Eigen::MatrixXd> &right_hand_sides) const;

      /// @f$ C_A^{-1} @f$, rows and columns in the order of the nodes.
      /// @pre Use::inverse.
      Eigen::MatrixXd
      compute_inverse();

      /// Factorise anew if this would remove errors. Returns whether it would.
      bool
      refresh();

    private:
      void
      factorise();

      void
      invert();

      /// Let nodes leave the inverse and others enter it.
      void
      exchange(const ActiveSet &leaving, const ActiveSet &entering);

      /// Give @p nodes the last places in the inverse. The places that they had
      /// are taken by those that were last.
      void
      move_to_end(const ActiveSet &nodes);

      /// What there is of the nodes asked for.
      enum class Form
      {
        factor,
        inverse,
        hierarchy
      };

      Compliance compliance;
      Use        use;
      ActiveSet  active_set;
      Form       form = Form::factor;

      Eigen::LLT<Eigen::MatrixXd> factor;

      HierarchicalCompliance::Restriction restriction;

      /// The inverse is the upper left corner of @p inverse, its rows in the
      /// order of @p order; @p place says where a node is in it, -1: nowhere.
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

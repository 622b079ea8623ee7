// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_contact_contact_programme_h
#define tribody_contact_contact_programme_h

#include <tribody/contact/contact_solution.h>

namespace Tribody
{
  namespace Contact
  {
    /**
     * The contact problem with the gap linearised about a pin centre, a convex
     * quadratic programme,
     * @f[ \min_{\lambda \ge 0} \tfrac12 \lambda^T C \lambda + g^T \lambda
     *     \quad\text{subject to}\quad \sum_i \lambda_i m_i = f, @f]
     * whose multiplier is the step d of the pin. Without a free pin the
     * constraint and d are missing. With a free ring in a Housing its rim's
     * nodes come last, with a second constraint of the same f, whose multiplier
     * is the step of the ring.
     */
    struct ContactProgramme
    {
      /// C [m per N/m].
      const Eigen::MatrixXd &compliance;
      /// g, the gaps without forces at the place of linearisation [m].
      const Eigen::VectorXd &gap;
      /// m_i, one column per node.
      const Eigen::Matrix2Xd &directions;
      /// Whether the force on the pin is given; else its place is.
      bool pin_is_free;
      /// f [N/m]; not read unless the pin is free.
      Eigen::Vector2d force;
      /// A gap is open if it is larger than minus this [m].
      double gap_tolerance;
      /// The same as a fraction of the largest elastic displacement [-].
      double relative_tolerance;
      /// How many of the nodes belong to the rim of a free ring.
      Eigen::Index n_rim = 0;
    };

    /// What solves a ContactProgramme.
    struct ContactProgrammeSolution
    {
      /// lambda [N/m].
      Eigen::VectorXd nodal_force;
      /// d, from the place of linearisation [m].
      Eigen::Vector2d pin_step = Eigen::Vector2d::Zero();
      /// The same of a free ring in its housing [m].
      Eigen::Vector2d ring_step = Eigen::Vector2d::Zero();
      /// Nodes with a force, those of the rim included.
      ActiveSet active_set;
      /// How the active-set method ended.
      SolverReport report;
    };

    /**
     * Solve by a primal active-set method that changes one node at a time: the
     * objective never rises, and when a step is blocked at once the node with
     * the smallest index goes first (Bland's rule), so no active set can come
     * twice. See @cite nocedal2006, algorithm 16.3.
     *
     * Slow (one factorisation per node that enters or leaves) but certain: for
     * when the Newton iteration cycles.
     */
    ContactProgrammeSolution
    solve_contact_programme(const ContactProgramme &programme);
  } // namespace Contact
} // namespace Tribody

#endif

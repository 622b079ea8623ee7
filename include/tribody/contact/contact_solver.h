// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_contact_contact_solver_h
#define tribody_contact_contact_solver_h

#include <Eigen/Core>

#include <tribody/contact/active_compliance.h>
#include <tribody/contact/contact_solution.h>
#include <tribody/contact/contact_solver_parameters.h>
#include <tribody/contact/housing.h>
#include <tribody/contact/pin_gap.h>
#include <tribody/contact/rigid_places.h>
#include <tribody/surface/bore_surface.h>

#include <optional>
#include <string>

namespace Tribody
{
  namespace Contact
  {
    /// How the forces of a contact change with the pin's centre e and the angle
    /// alpha by which it is turned: derivatives by (e_x, e_y, alpha).
    struct PinStiffness
    {
      /// Of ContactSolution::force [N/m^2, N/m].
      Eigen::Matrix<double, 2, 3> force = Eigen::Matrix<double, 2, 3>::Zero();
      /// Of the sum of nodal forces [N/m^2, N/m].
      Eigen::RowVector3d nodal_force_sum = Eigen::RowVector3d::Zero();
      /// Of their work per angle, for a fixed slope of the recess [N/m, N].
      Eigen::RowVector3d moment = Eigen::RowVector3d::Zero();
    };

    /**
     * Frictionless contact of a rigid round pin with an elastic bore, reduced
     * to the bore's nodes. With nodal forces @f$\lambda_i@f$, the bore's normal
     * compliance C and the exact gap of PinGap at the pin centre e:
     * @f[ g_i = |x_i - e| - R + (C\lambda)_i \ge 0, \quad \lambda_i \ge 0,
     *     \quad \lambda_i g_i = 0, \quad \sum_i \lambda_i m_i(e) = F/L. @f]
     * C belongs to the fixed normals of the undeformed surface, m_i is the
     * gradient of the gap, so that the problem has a potential. In conforming
     * contact both agree to the elastic slope.
     *
     * Method: primal-dual active set, which is Newton's method for the
     * conditions above (@cite hintermueller2002), with the second derivative
     * of the gap in its matrix: the contact force as a function of e is
     * differentiated exactly. Each iteration needs C of the nodes in
     * contact, inverted: see ActiveCompliance. As long as nodes enter and
     * leave, the gaps of those in contact are what a step leaves of them by its
     * own equations; the true ones decide about the end. If an active set comes
     * back, or after max_iterations, a ContactProgramme is solved instead, once
     * if the pin is fixed, else repeatedly, linearised about its last result.
     *
     * With a free ring in a Housing, the nodes of its rim are further ones, and
     * the ring's place is found with that of the pin, under a given force only.
     * The pin's centre is then that relative to the ring's place.
     *
     * The object keeps what it solved with last: use one per thread. Results
     * depend on what was solved before by less than the tolerance.
     */
    class ContactSolver
    {
    public:
      /**
       * @param surface of the undeformed, worn bore.
       * @param compliance C [m per N/m] for the normals of @p surface.
       *   With a @p housing, of bore and rim, see Housing.
       * @param pin_radius R [m].
       */
      ContactSolver(const BoreSurface             &surface,
                    const Compliance              &compliance,
                    const double                   pin_radius,
                    const ContactSolverParameters &parameters = {},
                    const std::optional<Housing>  &housing    = {});

      /// Let the worn pin lie inside its circle by @p recess [m] where it faces
      /// the bore's nodes, see PinGap; empty: a round pin. For all that is
      /// solved from now on.
      void
      set_pin_recess(const Eigen::VectorXd &recess)
      {
        pin_recess = recess;
      }

      /**
       * The contact under a given force [N/m] of the pin on the bushing. Under
       * zero force the pin is centred and touches nothing.
       *
       * @param warm_start a solution for a similar force, or nullptr.
       * @return also without convergence, which its report tells.
       */
      ContactSolution
      solve_force_controlled(const Eigen::Vector2d &force_per_length,
                             const ContactSolution *warm_start = nullptr);

      /// The contact with the pin's centre at @p pin_centre [m]; the force is
      /// a result. @pre There is no housing.
      ContactSolution
      solve_position_controlled(const Eigen::Vector2d &pin_centre,
                                const ContactSolution *warm_start = nullptr);

      /**
       * How the forces of @p solution, which came from this solver, change with
       * the pin's centre as long as the same nodes are in contact,
       * @f[ \frac{d\lambda_A}{de} = C_A^{-1} m_A^T, \qquad
       *     \frac{dF}{de} = m_A C_A^{-1} m_A^T - \sum_i \lambda_i
       *     \frac{I - m_i m_i^T}{|x_i - e|}. @f]
       * Turning a worn pin changes its recess r:
       * @f$ d\lambda_A/d\alpha = -C_A^{-1}\,r'_A @f$, and the moment is
       * @f$ \sum_i \lambda_i r'_i @f$.
       * @param recess_slope r' at the bore's nodes [m/rad]; empty: none.
       * @pre There is no housing.
       */
      PinStiffness
      compute_pin_stiffness(const ContactSolution &solution,
                            const Eigen::VectorXd &recess_slope = {});

      /// @f$ \tfrac12 \lambda^T C \lambda @f$ of @p solution [J/m].
      /// @pre There is no housing.
      double
      stored_energy(const ContactSolution &solution) const;

      /**
       * One iteration of the active sets, for callers who iterate on more than
       * this contact: exactly the nodes of @p start.active_set are held on the
       * pin (and those of the rim in the housing), even if that takes tension,
       * and the force is balanced.
       *
       * @return what follows; it solves the contact problem if its
       *   next_active_set is its active_set. If @p start holds nothing, or what
       *   it holds cannot carry the force, solve_force_controlled().
       */
      ContactSolution
      solve_held(const Eigen::Vector2d &force_per_length,
                 const ContactSolution &start);

    private:
      /// What the iterations change, and what follows from it. With a housing
      /// the nodes of the rim follow those of the bore.
      struct Iterate
      {
        Eigen::Vector2d pin_centre = Eigen::Vector2d::Zero();
        Eigen::Vector2d ring_place = Eigen::Vector2d::Zero();
        Eigen::VectorXd nodal_force;
        ActiveSet       active_set;
        /// Rigid gap at these places.
        PinGap pin;
        /// How far the surfaces yield, @f$ C \lambda @f$, where evaluate_gap()
        /// was asked for it.
        Eigen::VectorXd yielding;
        /// Rigid gap and yielding.
        Eigen::VectorXd gap;
        /// Gaps above minus this count as not negative [m].
        double gap_tolerance;
        /// Begun from a similar solution, so that the nodes change little.
        bool is_warm = false;
      };

      /// Of bore and rim.
      Eigen::Index
      n_nodes() const
      {
        return surface.n_nodes() + (housing ? housing->rim.n_nodes() : 0);
      }

      PinGap
      rigid_gap(const Iterate &iterate) const;

      Iterate
      first_iterate(const Eigen::Vector2d &force,
                    const ContactSolution *warm_start) const;

      /// Whose yielding to compute from the forces.
      enum class Rows
      {
        /// Of nodes near the contact, but not in contact. That of those in
        /// contact is kept by the step that changed the forces.
        beside_contact,
        /// Of nodes in contact and near it.
        near_contact,
        all
      };

      /// Far rows get the rigid gap, which is open there.
      void
      evaluate_gap(Iterate &iterate, const Rows rows) const;

      SolverReport
      iterate_pin_and_forces(const Eigen::Vector2d &force, Iterate &iterate);

      /// What lets the iteration give up, or nothing.
      std::string
      what_is_lost(const Eigen::Vector2d &force, const Iterate &iterate) const;

      /// Whether a body is touched by one node alone.
      bool
      has_single_node(const Iterate &iterate) const;

      bool
      is_in_place(const Iterate &iterate) const;

      /// Of the @p force to what the nodes carry, relative to their forces.
      double
      imbalance(const Eigen::Vector2d &force, const Iterate &iterate) const;

      void
      newton_step(const Eigen::Vector2d &force, Iterate &iterate);

      /// @tparam n_free see RigidPlaces.
      template <int n_free>
      typename RigidPlaces<n_free>::Vector
      newton_step(const Eigen::Vector2d &force, Iterate &iterate);

      SolverReport
      iterate_forces(Iterate &iterate);

      bool
      solve_programme(const Eigen::Vector2d *force, Iterate &iterate) const;

      /// Take the nodes in contact, and the forces from those released.
      void
      change_active_set(ActiveSet next, Iterate &iterate) const;

      /**
       * Nodes in contact stay as long as they are pressed, others enter when
       * the pin would penetrate them. A node is released because its force
       * has turned to tension, not because its gap has opened: as long as it
       * is held, its gap is zero by construction.
       */
      static ActiveSet
      next_active_set(const Iterate &iterate);

      /// Largest gap left in contact in units of what the tolerance refers to.
      double
      relative_gap(const Iterate &iterate) const;

      ContactSolution
      make_solution(const Iterate &iterate, const SolverReport &report) const;

      BoreSurface             surface;
      std::optional<Housing>  housing;
      Compliance              compliance;
      double                  pin_radius;
      Eigen::VectorXd         pin_recess;
      ContactSolverParameters parameters;
      ActiveCompliance        active_compliance;
    };
  } // namespace Contact
} // namespace Tribody

#endif

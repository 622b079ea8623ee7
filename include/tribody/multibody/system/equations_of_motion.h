// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_system_equations_of_motion_h
#define tribody_multibody_system_equations_of_motion_h

#include <Eigen/Core>

#include <tribody/multibody/joints/clearance_joint.h>
#include <tribody/surface/joint_clearance.h>

#include <memory>
#include <vector>

namespace Tribody
{
  class MatrixEntries;

  namespace Multibody
  {
    class Mechanism;
    struct MechanismState;

    /// Kinetic and potential energy [J]. Contacts and applied forces are not
    /// included.
    struct Energy
    {
      /// v^T M v / 2.
      double kinetic;
      /// Of gravity, zero with all centres of mass at the origin, and of
      /// springs.
      double potential;

      /// Kinetic plus potential energy [J].
      double
      total() const
      {
        return kinetic + potential;
      }
    };

    /// Where the unknowns begin among all, and so the equations for q', M v',
    /// Phi and its rate.
    struct FirstIndices
    {
      /// First of the coordinates, and of the equations for q'.
      Eigen::Index q;
      /// First of the velocities, and of the equations for M v'.
      Eigen::Index v;
      /// First of the multipliers of Phi = 0, and of these equations.
      Eigen::Index lambda;
      /// First of the multipliers of the rate of Phi, and of these equations.
      Eigen::Index mu;
    };

    /**
     * The terms of the equations of motion of a mechanism whose joints have
     * given clearances,
     * @f[ M \dot v = Q(t, q, v) - \Phi_q^T \lambda, \qquad \Phi(q, t) = 0, @f]
     * assembled over its elements. Nothing is allocated here: results are
     * written to what the caller provides.
     */
    class EquationsOfMotion
    {
    public:
      /// A result, written in place: a vector or a segment of one.
      using Vector = Eigen::Ref<Eigen::VectorXd>;
      /// The same for a matrix or a block of one.
      using Matrix = Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
      /// An argument: a vector or a segment of one, not copied.
      using ConstVector = const Eigen::Ref<const Eigen::VectorXd> &;

      /// Elastic surfaces, one entry per clearance joint; null if its law needs
      /// none.
      using Supports = std::vector<std::shared_ptr<const PinSupport>>;

      /// @p clearances in the order of mechanism.clearance_joints(), and so @p
      /// supports, of those joints whose law needs one; empty if none does.
      /// Keeps a reference to @p mechanism.
      EquationsOfMotion(const Mechanism                   &mechanism,
                        const std::vector<JointClearance> &clearances,
                        const Supports                    &supports = {});

      /// Of which these are the equations.
      const Mechanism &
      mechanism() const
      {
        return system;
      }

      /// Of clearance joint @p joint.
      const JointCondition &
      condition(const unsigned int joint) const
      {
        return conditions[joint];
      }

      /// Phi(q, t).
      void
      assemble_constraints(const double t, ConstVector q, Vector phi) const;

      /// Phi_q.
      void
      assemble_constraint_jacobian(ConstVector q, Matrix phi_q) const;

      /// Add Phi_q to the rows of @p entries from @p first on, and its
      /// transpose to the columns.
      void
      add_constraint_jacobian(ConstVector        q,
                              const Eigen::Index first,
                              MatrixEntries     &entries) const;

      /// Phi_t, and d(Phi_t)/dt = Phi_tt.
      void
      assemble_time_derivatives(const double t,
                                Vector       phi_t,
                                Vector       phi_tt) const;

      /// The vector (Phi_q v)_q v: accelerations that the constraints ask for
      /// at constant velocities.
      void
      assemble_quadratic_terms(ConstVector q,
                               ConstVector v,
                               Vector      quadratic) const;

      /**
       * All that the equations of motion in the form of MotionIntegrator
       * contain of the constraints, in one pass: set @p phi to Phi and
       * @p phi_rate to Phi_q v + Phi_t, add Phi_q^T lambda to @p forces and
       * subtract Phi_q^T mu from @p rates. Where constraints are redundant, all
       * give way a little, so that their multipliers are unique.
       */
      void
      assemble_constraint_terms(const double t,
                                ConstVector  q,
                                ConstVector  v,
                                ConstVector  lambda,
                                ConstVector  mu,
                                Vector       phi,
                                Vector       phi_rate,
                                Vector       forces,
                                Vector       rates) const;

      /// The derivatives of these terms, added to @p entries: rows of the
      /// equations for q', M v', Phi and its rate, columns of q, v, lambda, mu.
      void
      add_constraint_derivatives(ConstVector         q,
                                 ConstVector         v,
                                 ConstVector         lambda,
                                 ConstVector         mu,
                                 const FirstIndices &first,
                                 MatrixEntries      &entries) const;

      /// Q(t, q, v). @p approach_speeds: one per clearance joint [m/s].
      void
      assemble_forces(const double               t,
                      ConstVector                q,
                      ConstVector                v,
                      const std::vector<double> &approach_speeds,
                      Vector                     forces) const;

      /// The same for a mechanism whose friction laws have the states @p z.
      void
      assemble_forces(const double               t,
                      ConstVector                q,
                      ConstVector                v,
                      const std::vector<double> &approach_speeds,
                      ConstVector                z,
                      Vector                     forces) const;

      /// z', the rates of the states of the friction laws.
      void
      assemble_friction_state_rates(ConstVector                q,
                                    ConstVector                v,
                                    const std::vector<double> &approach_speeds,
                                    ConstVector                z,
                                    Vector                     rates) const;

      /// Subtract the derivatives of Q with respect to z, and those of z', from
      /// @p entries. Rows and columns: of Q and q as below; states are counted
      /// from @p state on in both.
      void
      subtract_friction_state_derivatives(
        ConstVector                q,
        ConstVector                v,
        const std::vector<double> &approach_speeds,
        ConstVector                z,
        const Eigen::Index         row,
        const Eigen::Index         q_column,
        const Eigen::Index         v_column,
        const Eigen::Index         state,
        MatrixEntries             &entries) const;

      /// Subtract dQ/dq from @p entries, beginning at (@p row, @p q_column),
      /// and dQ/dv, beginning at (@p row, @p v_column). States of friction that
      /// are not given are zero.
      void
      subtract_force_derivatives(const double               t,
                                 ConstVector                q,
                                 ConstVector                v,
                                 const std::vector<double> &approach_speeds,
                                 ConstVector                z,
                                 const Eigen::Index         row,
                                 const Eigen::Index         q_column,
                                 const Eigen::Index         v_column,
                                 MatrixEntries             &entries) const;

      /// Penetration [m] in clearance joint @p joint.
      double
      compute_penetration(const unsigned int joint, ConstVector q) const;

      /// Contact in clearance joint @p joint.
      JointContact
      compute_contact(const unsigned int joint,
                      ConstVector        q,
                      ConstVector        v,
                      const double       approach_speed,
                      const double       friction_state = 0.) const;

      /// The same in a state of the mechanism.
      JointContact
      compute_contact(const unsigned int    joint,
                      const MechanismState &state) const;

      /// At coordinates @p q and velocities @p v.
      Energy
      compute_energy(ConstVector q, ConstVector v) const;

    private:
      void
      set_compliances();

      const Mechanism            &system;
      std::vector<JointCondition> conditions;
      // Gaps per lambda and rates of gaps per mu that make the multipliers of
      // redundant constraints unique; empty without.
      Eigen::VectorXd compliances;
      Eigen::VectorXd rate_compliances;
    };

    /// The clearances of all clearance joints as manufactured.
    std::vector<JointClearance>
    nominal_clearances(const Mechanism &mechanism);
  } // namespace Multibody
} // namespace Tribody

#endif

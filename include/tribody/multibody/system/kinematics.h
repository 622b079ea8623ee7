// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_system_kinematics_h
#define tribody_multibody_system_kinematics_h

#include <Eigen/Core>

namespace Tribody
{
  struct SolverReport;

  namespace Multibody
  {
    class EquationsOfMotion;
    class Mechanism;
    struct MechanismState;

    /**
     * A motion added to the constraints: Phi(q, t) = value. Used to place the
     * pin of a joint at a known eccentricity. One entry per constraint.
     */
    struct ConstraintOffsets
    {
      /// All zero: the constraints as they are.
      explicit ConstraintOffsets(const unsigned int n_constraints);

      /// Offsets o [m, rad].
      Eigen::VectorXd value;
      /// do/dt [m/s, rad/s].
      Eigen::VectorXd first_derivative;
      /// d2o/dt2 [m/s^2, rad/s^2].
      Eigen::VectorXd second_derivative;
    };

    /// Accelerations [m/s^2, rad/s^2] and Lagrange multipliers [N, N m].
    struct Accelerations
    {
      /// Second derivatives of the coordinates [m/s^2, rad/s^2].
      Eigen::VectorXd a;
      /// lambda of the equations of motion, one per constraint [N, N m].
      Eigen::VectorXd multipliers;
    };

    /**
     * Solve Phi(q, t) = offsets for the configuration nearest to @p q by
     * Newton's method, with steps of least length (angles times the size of
     * the mechanism) while the mechanism has degrees of freedom.
     * @param mobility one per coordinate, or none: by how much less than others
     *   a coordinate is moved where there is a choice.
     * @return how it ended; q is improved in place. The residual is in units
     *   of the mechanism's size.
     */
    SolverReport
    solve_positions(const EquationsOfMotion &equations,
                    const double             t,
                    const ConstraintOffsets &offsets,
                    Eigen::VectorXd         &q,
                    const Eigen::VectorXd   &mobility = {});

    /// The smallest velocities (in the same sense) with
    /// Phi_q v + Phi_t = d(offsets)/dt.
    Eigen::VectorXd
    compute_velocities(const EquationsOfMotion &equations,
                       const double             t,
                       const ConstraintOffsets &offsets,
                       const Eigen::VectorXd   &q);

    /// The velocities nearest to @p v (in the same sense) with
    /// Phi_q v + Phi_t = 0.
    Eigen::VectorXd
    compute_nearest_velocities(const EquationsOfMotion &equations,
                               const double             t,
                               const Eigen::VectorXd   &q,
                               const Eigen::VectorXd   &v);

    /// Those nearest to the initial ones of the parameters.
    Eigen::VectorXd
    compute_initial_velocities(const EquationsOfMotion &equations,
                               const double             t,
                               const Eigen::VectorXd   &q);

    /// The smallest accelerations that Phi_q a + (Phi_q v)_q v + Phi_tt = 0
    /// allows: eq. (5) of @cite mukras2010. Without degrees of freedom they are
    /// the accelerations, whatever the masses are.
    Eigen::VectorXd
    compute_kinematic_accelerations(const EquationsOfMotion &equations,
                                    const double             t,
                                    const Eigen::VectorXd   &q,
                                    const Eigen::VectorXd   &v);

    /**
     * Accelerations and multipliers from
     * @f[ \begin{pmatrix} M & \Phi_q^T \\ \Phi_q & 0 \end{pmatrix}
     *     \begin{pmatrix} a \\ \lambda \end{pmatrix} =
     *     \begin{pmatrix} Q \\ \ddot{o} - (\Phi_q v)_q v - \Phi_{tt}
     *     \end{pmatrix}, @f]
     * with o the offsets and Q the applied @p forces: inverse dynamics if the
     * mechanism has no degree of freedom, the exact reactions otherwise.
     */
    Accelerations
    compute_accelerations(const EquationsOfMotion &equations,
                          const double             t,
                          const ConstraintOffsets &offsets,
                          const Eigen::VectorXd   &q,
                          const Eigen::VectorXd   &v,
                          const Eigen::VectorXd   &forces);

    /// The same in the @p state under all its forces, without offsets: the
    /// exact reactions for its positions and velocities.
    Accelerations
    compute_accelerations(const EquationsOfMotion &equations,
                          const MechanismState    &state);

    /// Positions, velocities, accelerations and multipliers at one instant.
    struct Motion
    {
      /// Coordinates [m, rad].
      Eigen::VectorXd q;
      /// Velocities [m/s, rad/s].
      Eigen::VectorXd v;
      /// Accelerations [m/s^2, rad/s^2].
      Eigen::VectorXd a;
      /// Lagrange multipliers, one per constraint [N, N m].
      Eigen::VectorXd multipliers;
    };

    /**
     * Kinematics and inverse dynamics of a mechanism without degrees of freedom
     * and without clearance joints at time @p t: positions near @p q_guess,
     * then everything else in turn. @p extra_forces are added to gravity and
     * springs. With degrees of freedom: at the beginning of the motion,
     * positions nearest to the guess and velocities to the initial ones.
     * @throws ExcRun if there is no such position, naming the joint
     *   that cannot be closed.
     */
    Motion
    solve_motion(const EquationsOfMotion &equations,
                 const double             t,
                 const ConstraintOffsets &offsets,
                 const Eigen::VectorXd   &extra_forces,
                 const Eigen::VectorXd   &q_guess);

    /**
     * The configuration at time @p t near the guess in the parameters.
     * @throws ExcParameter naming the joint that cannot be closed and the gap
     *   that remains.
     */
    Eigen::VectorXd
    assemble_configuration(const EquationsOfMotion &equations, const double t);
  } // namespace Multibody
} // namespace Tribody

#endif

#ifndef tribody_multibody_kinematics_h
#define tribody_multibody_kinematics_h

#include <Eigen/Core>

namespace Tribody
{
  struct SolverReport;

  namespace Multibody
  {
    class EquationsOfMotion;
    class Mechanism;

    /**
     * A motion added to the constraints: Phi(q, t) = value. Used to place the
     * pin of a joint at a known eccentricity. One entry per constraint.
     */
    struct ConstraintOffsets
    {
      explicit ConstraintOffsets(const unsigned int n_constraints);

      Eigen::VectorXd value;
      Eigen::VectorXd first_derivative;
      Eigen::VectorXd second_derivative;
    };

    /// Accelerations [m/s^2, rad/s^2] and Lagrange multipliers [N, N m].
    struct Accelerations
    {
      Eigen::VectorXd a;
      Eigen::VectorXd multipliers;
    };

    /**
     * Solve Phi(q, t) = offsets for the configuration nearest to @p q by
     * Newton's method, with steps of least length (angles times the size of
     * the mechanism) while the mechanism has degrees of freedom.
     * @return how it ended; q is improved in place. The residual is in units
     *   of the mechanism's size.
     */
    SolverReport
    solve_positions(const EquationsOfMotion &equations,
                    const double             t,
                    const ConstraintOffsets &offsets,
                    Eigen::VectorXd         &q);

    /// The smallest velocities (in the same sense) with
    /// Phi_q v + Phi_t = d(offsets)/dt.
    Eigen::VectorXd
    compute_velocities(const EquationsOfMotion &equations,
                       const double             t,
                       const ConstraintOffsets &offsets,
                       const Eigen::VectorXd   &q);

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

    /// Positions, velocities, accelerations and multipliers at one instant.
    struct Motion
    {
      Eigen::VectorXd q;
      Eigen::VectorXd v;
      Eigen::VectorXd a;
      Eigen::VectorXd multipliers;
    };

    /**
     * Kinematics and inverse dynamics of a mechanism without degrees of freedom
     * and without clearance joints at time @p t: positions near @p q_guess,
     * then everything else in turn. @p extra_forces are added to gravity and
     * springs. @throws ExcRun if there is no such position.
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

    /**
     * Make sure that a mechanism without degrees of freedom has a position at
     * each of @p n_steps equal steps through one cycle from time 0 on. @throws
     * ExcParameter with the angle of the first driver at which it locks.
     */
    void
    check_full_cycle(const EquationsOfMotion &equations,
                     const unsigned int       n_steps);

    /**
     * Make sure that no constraint follows from the others at @p q (rank of
     * Phi_q). @throws ExcParameter naming the joints and drivers involved.
     */
    void
    check_redundancy(const EquationsOfMotion &equations,
                     const Eigen::VectorXd   &q);
  } // namespace Multibody
} // namespace Tribody

#endif

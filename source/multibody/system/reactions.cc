// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>
#include <tribody/multibody/system/mechanism_state.h>
#include <tribody/multibody/system/reactions.h>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // Force and moment of a constraint on its two bodies, the moments about
      // their centres of mass: -Phi_q^T lambda.
      PairVector
      constraint_forces(const NumberedConstraint &numbered,
                        const Eigen::VectorXd    &q,
                        const Eigen::VectorXd    &multipliers)
      {
        const Constraint &c = *numbered.constraint;
        return -c.jacobian(c.bodies.gather(q))
                  .topRows(c.n_equations)
                  .transpose() *
               multipliers.segment(numbered.first_row, c.n_equations);
      }



      // The moment about @p point instead of the origin of the body's frame.
      Eigen::Vector3d
      shifted(const Eigen::Vector3d &force, const Eigen::Vector2d &arm)
      {
        return {force(0),
                force(1),
                force(2) - arm.x() * force(1) + arm.y() * force(0)};
      }

    } // namespace



    Reactions
    compute_reactions(const EquationsOfMotion         &equations,
                      const MechanismState            &state,
                      const Accelerations             &accelerations,
                      const std::vector<JointContact> &contacts)
    {
      const Mechanism &mechanism = equations.mechanism();
      Eigen::VectorXd  phi_t(mechanism.n_constraints()), phi_tt(phi_t);
      equations.assemble_time_derivatives(state.time, phi_t, phi_tt);

      Reactions result;
      result.joints.resize(3, mechanism.joints().size());
      result.joint_points.resize(2, mechanism.joints().size());
      for (unsigned int j = 0; j < mechanism.joints().size(); ++j)
        {
          const JointEntry     &joint = mechanism.joints()[j];
          const PairVector      q     = joint.bodies.gather(state.q);
          const Eigen::Vector2d arm   = turned(joint.second_position, q(5));
          PairVector            force;
          if (joint.has_contact_law())
            force = mechanism.clearance_joints()[joint.index].compute_force(
              q, contacts[joint.index]);
          else if (joint.is_flying)
            force.setZero();
          else
            force = constraint_forces(mechanism.constraints()[joint.index],
                                      state.q,
                                      accelerations.multipliers);
          result.joints.col(j)       = shifted(force.tail<3>(), arm);
          result.joint_points.col(j) = q.segment<2>(3) + arm;
        }

      const unsigned int n_drivers = mechanism.drivers().size();
      result.drivers.resize(3, n_drivers);
      result.driver_powers.resize(n_drivers);
      for (unsigned int d = 0; d < n_drivers; ++d)
        {
          const NumberedConstraint &driver =
            mechanism.constraints()[mechanism.drivers()[d].constraint];
          const unsigned int n = driver.constraint->n_equations;
          result.drivers.col(d) =
            constraint_forces(driver, state.q, accelerations.multipliers)
              .head<3>();
          result.driver_powers(d) =
            accelerations.multipliers.segment(driver.first_row, n)
              .dot(phi_t.segment(driver.first_row, n));
        }
      return result;
    }
  } // namespace Multibody
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <Eigen/QR>

#include <tribody/multibody/cycle/creep.h>
#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/multibody/joints/friction_law.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/mechanism.h>

#include <algorithm>
#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // Whether joints and drivers leave it open how the bodies turn against
      // each other: the difference of their angles is no combination of the
      // rows of Phi_q.
      bool
      turns_freely(const BodyPair          &bodies,
                   const EquationsOfMotion &closed,
                   const Eigen::VectorXd   &q)
      {
        const Mechanism &mechanism = closed.mechanism();
        if (mechanism.n_degrees_of_freedom() == 0)
          return false;
        if (mechanism.n_constraints() == 0)
          return true;
        Eigen::MatrixXd rows(mechanism.n_constraints(),
                             mechanism.n_coordinates());
        closed.assemble_constraint_jacobian(q, rows);
        PairVector turn   = PairVector::Zero();
        turn(2)           = 1.;
        turn(5)           = -1.;
        Eigen::VectorXd e = Eigen::VectorXd::Zero(mechanism.n_coordinates());
        bodies.add_to(turn, e);
        // Lengths in units of the mechanism's size, so that all are angles.
        for (Eigen::Index i = 0; i < e.size(); ++i)
          if (i % 3 != 2)
            rows.col(i) *= mechanism.size();
        const Eigen::MatrixXd columns = rows.transpose();
        const Eigen::VectorXd combination =
          columns.completeOrthogonalDecomposition().solve(e);
        return (columns * combination - e).norm() > 1e-6;
      }



      // Sample by sample.
      std::vector<bool>
      find_creep(const FrictionLaw &law, const JointDutyCycle &joint)
      {
        std::vector<bool> creeps(joint.normal_force.size());
        for (Eigen::Index s = 0; s < joint.normal_force.size(); ++s)
          creeps[s] =
            joint.normal_force[s] > 0. &&
            friction_holds(law,
                           joint.sliding_speed[s],
                           joint.friction_force[s] / joint.normal_force[s]);
        return creeps;
      }



      void
      take_out(JointDutyCycle &joint)
      {
        joint.creep_distance = joint.sliding_distance();
        joint.sliding_increment.setZero();
        joint.sliding_halves.setZero();
        joint.sliding_speed.setZero();
      }



      double
      share_of_creep(const std::vector<bool> &creeps,
                     const JointDutyCycle    &joint)
      {
        const std::size_t n        = creeps.size();
        double            distance = 0.;
        for (std::size_t s = 0; s < n; ++s)
          if (creeps[(s + n - 1) % n] && creeps[s] && creeps[(s + 1) % n])
            distance += joint.sliding_increment[s];
        return distance > 0. ? distance / joint.sliding_distance() : 0.;
      }
    } // namespace



    void
    judge_creep(const Mechanism         &mechanism,
                const EquationsOfMotion &closed,
                DutyCycle               &cycle)
    {
      for (std::size_t j = 0; j < cycle.joints.size(); ++j)
        {
          JointDutyCycle   &joint = cycle.joints[j];
          const JointEntry &entry = mechanism.joints()[j];
          if (!joint.has_contact_law ||
              !turns_freely(entry.bodies, closed, cycle.coordinates.col(0)))
            continue;
          const std::vector<bool> creeps =
            find_creep(mechanism.clearance_joints()[entry.index].friction_law,
                       joint);
          if (std::find(creeps.begin(), creeps.end(), false) == creeps.end())
            take_out(joint);
          else
            joint.creep_share = share_of_creep(creeps, joint);
        }
    }
  } // namespace Multibody
} // namespace Tribody

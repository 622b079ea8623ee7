// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/motion/energy_account.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // Places in the vector of powers; three for each joint follow.
      enum Place
      {
        driver_work,
        force_work,
        damper_loss,
        impact_loss,
        first_joint
      };



      // What the damper of a spring takes [W].
      template <typename SpringType>
      double
      damper_power(const SpringType &spring, const MechanismState &state)
      {
        const PairVector q = spring.bodies.gather(state.q);
        const PairVector v = spring.bodies.gather(state.v);
        // At rest, only the elastic part is left.
        return v.dot(spring.compute_force(q, PairVector::Zero()).force -
                     spring.compute_force(q, v).force);
      }
    } // namespace



    EnergyAccount::EnergyAccount(const EquationsOfMotion &equations)
      : equations(&equations)
    {}



    void
    EnergyAccount::open(const MechanismState &state)
    {
      const unsigned int n_joints =
        equations->mechanism().clearance_joints().size();
      exchanged.setZero(first_joint + 3 * n_joints);
      the_time = state.time;
      powers   = compute_powers(state);
      update_record(state);
      at_opening      = the_record;
      largest_error   = 0.;
      largest_term    = 0.;
      largest_kinetic = 0.;
    }



    void
    EnergyAccount::restart(const MechanismState &state)
    {
      const double before = the_record.kinetic;
      powers              = compute_powers(state);
      update_record(state);
      exchanged(impact_loss) += before - the_record.kinetic;
      the_record.impact_loss = exchanged(impact_loss);
    }



    void
    EnergyAccount::advance(const MechanismState &middle,
                           const MechanismState &end)
    {
      const Eigen::VectorXd at_end = compute_powers(end);
      exchanged += (end.time - the_time) / 6 *
                   (powers + 4 * compute_powers(middle) + at_end);
      the_time = end.time;
      powers   = at_end;
      update_record(end);
      const EnergyRecord change = the_record.since(at_opening);
      largest_error = std::max(largest_error, std::abs(change.balance_error()));
      largest_term  = std::max(largest_term, change.largest_term());
      largest_kinetic = std::max(largest_kinetic, the_record.kinetic);
    }



    double
    EnergyAccount::relative_error() const
    {
      return relative_to_exchange(largest_error, largest_term, largest_kinetic);
    }



    Eigen::VectorXd
    EnergyAccount::compute_powers(const MechanismState &state) const
    {
      const Mechanism   &mechanism = equations->mechanism();
      const unsigned int m         = mechanism.n_constraints();
      Eigen::VectorXd    result    = Eigen::VectorXd::Zero(exchanged.size());
      Eigen::VectorXd    phi_t(m), phi_tt(m);
      equations->assemble_time_derivatives(state.time, phi_t, phi_tt);
      // -v^T Phi_q^T lambda, with Phi_q v = -Phi_t.
      result(driver_work) =
        compute_accelerations(*equations, state).multipliers.dot(phi_t);
      result(force_work) = compute_applied_power(state);
      for (const Spring &spring : mechanism.springs())
        result(damper_loss) += damper_power(spring, state);
      for (const RotationalSpring &spring : mechanism.rotational_springs())
        result(damper_loss) += damper_power(spring, state);
      for (unsigned int j = 0; j < mechanism.clearance_joints().size(); ++j)
        add_joint_powers(j, state, result);
      return result;
    }



    double
    EnergyAccount::compute_applied_power(const MechanismState &state) const
    {
      const Mechanism &mechanism = equations->mechanism();
      double           power     = 0.;
      for (const AppliedForce &force : mechanism.applied_forces())
        {
          const int i = 3 * force.marker.body;
          power += state.v.segment<3>(i).dot(
            force.compute_force(state.time, state.q.segment<3>(i)).force);
        }
      for (const AppliedTorque &torque : mechanism.applied_torques())
        power +=
          torque.bodies.gather(state.v).dot(torque.compute_force(state.time));
      return power;
    }



    void
    EnergyAccount::add_joint_powers(const unsigned int    joint,
                                    const MechanismState &state,
                                    Eigen::VectorXd      &result) const
    {
      const JointContact contact = equations->compute_contact(joint, state);
      if (contact.penetration < 0)
        return;
      const ClearanceJoint &element =
        equations->mechanism().clearance_joints()[joint];
      const PairVector q     = element.bodies.gather(state.q);
      const PairVector v     = element.bodies.gather(state.v);
      const double     total = -v.dot(element.compute_force(q, contact));
      // A stored energy that is known need not be integrated.
      result.segment<3>(first_joint + 3 * joint)
        << (needs_support(element.contact_law) ? 0. : contact.elastic_power),
        contact.normal_power - contact.elastic_power,
        total - contact.normal_power;
    }



    void
    EnergyAccount::update_record(const MechanismState &state)
    {
      const Energy       energy   = equations->compute_energy(state.q, state.v);
      const unsigned int n_joints = (exchanged.size() - first_joint) / 3;
      const Eigen::Map<const Eigen::MatrixXd> of_joints(
        exchanged.data() + first_joint, 3, n_joints);
      the_record.kinetic        = energy.kinetic;
      the_record.potential      = energy.potential;
      the_record.has_work       = true;
      the_record.driver_work    = exchanged(driver_work);
      the_record.force_work     = exchanged(force_work);
      the_record.damper_loss    = exchanged(damper_loss);
      the_record.impact_loss    = exchanged(impact_loss);
      the_record.contact_energy = of_joints.row(0).transpose();
      for (unsigned int j = 0; j < n_joints; ++j)
        if (needs_support(
              equations->mechanism().clearance_joints()[j].contact_law))
          the_record.contact_energy[j] =
            equations->compute_contact(j, state).elastic_energy;
      the_record.normal_loss   = of_joints.row(1).transpose();
      the_record.friction_loss = of_joints.row(2).transpose();
    }
  } // namespace Multibody
} // namespace Tribody

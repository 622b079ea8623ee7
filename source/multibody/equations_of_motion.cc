#include <deal.II/base/exceptions.h>

#include <tribody/multibody/equations_of_motion.h>
#include <tribody/multibody/mechanism.h>
#include <tribody/multibody/mechanism_state.h>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // Of all states, the one of this joint; zero if its law has none.
      double
      friction_state(const ClearanceJoint                    &joint,
                     const Eigen::Ref<const Eigen::VectorXd> &z)
      {
        return joint.friction_state_index < 0 ? 0.
                                              : z(joint.friction_state_index);
      }
    } // namespace



    EquationsOfMotion::EquationsOfMotion(
      const Mechanism                     &mechanism,
      const std::vector<ClearanceProfile> &clearances)
      : system(mechanism)
      , clearances(clearances)
    {
      Assert(clearances.size() == mechanism.clearance_joints().size(),
             dealii::ExcMessage("One clearance per clearance joint."));
    }



    void
    EquationsOfMotion::assemble_constraints(const double t,
                                            ConstVector  q,
                                            Vector       phi) const
    {
      for (const auto &[element, row] : system.constraints())
        phi.segment(row, element->n_equations) =
          element->value(t, element->bodies.gather(q))
            .head(element->n_equations);
    }



    void
    EquationsOfMotion::assemble_constraint_jacobian(ConstVector q,
                                                    Matrix      phi_q) const
    {
      phi_q.setZero();
      for (const auto &[element, row] : system.constraints())
        {
          const unsigned int         n      = element->n_equations;
          const BodyPair            &bodies = element->bodies;
          const Constraint::Jacobian local =
            element->jacobian(bodies.gather(q));
          for (const int k : {0, 1})
            if (bodies.body(k) != ground_body)
              phi_q.block(row, 3 * bodies.body(k), n, 3) =
                local.block(0, 3 * k, n, 3);
        }
    }



    void
    EquationsOfMotion::assemble_time_derivatives(const double t,
                                                 Vector       phi_t,
                                                 Vector       phi_tt) const
    {
      for (const auto &[element, row] : system.constraints())
        {
          const unsigned int n   = element->n_equations;
          phi_t.segment(row, n)  = element->time_derivative(t).head(n);
          phi_tt.segment(row, n) = element->second_time_derivative(t).head(n);
        }
    }



    void
    EquationsOfMotion::assemble_quadratic_terms(ConstVector q,
                                                ConstVector v,
                                                Vector      quadratic) const
    {
      for (const auto &[element, row] : system.constraints())
        {
          const PairVector local_q = element->bodies.gather(q);
          const PairVector local_v = element->bodies.gather(v);
          for (unsigned int k = 0; k < element->n_equations; ++k)
            quadratic(row + k) = local_v.dot(
              element->weighted_hessian(local_q, Eigen::Vector2d::Unit(k)) *
              local_v);
        }
    }



    void
    EquationsOfMotion::add_multiplier_derivative(ConstVector  q,
                                                 ConstVector  multipliers,
                                                 const double factor,
                                                 Matrix       matrix) const
    {
      for (const auto &[element, row] : system.constraints())
        {
          Eigen::Vector2d weights = Eigen::Vector2d::Zero();
          for (unsigned int k = 0; k < element->n_equations; ++k)
            weights(k) = factor * multipliers(row + k);
          element->bodies.add_to(
            element->weighted_hessian(element->bodies.gather(q), weights),
            matrix);
        }
    }



    void
    EquationsOfMotion::add_velocity_derivative(ConstVector q,
                                               ConstVector v,
                                               Matrix      matrix) const
    {
      for (const auto &[element, row] : system.constraints())
        {
          const BodyPair  &bodies  = element->bodies;
          const PairVector local_q = bodies.gather(q);
          const PairVector local_v = bodies.gather(v);
          for (unsigned int k = 0; k < element->n_equations; ++k)
            {
              const PairVector local =
                element->weighted_hessian(local_q, Eigen::Vector2d::Unit(k)) *
                local_v;
              for (const int l : {0, 1})
                if (bodies.body(l) != ground_body)
                  matrix.block<1, 3>(row + k, 3 * bodies.body(l)) +=
                    local.segment<3>(3 * l).transpose();
            }
        }
    }



    void
    EquationsOfMotion::assemble_forces(
      ConstVector                q,
      ConstVector                v,
      const std::vector<double> &approach_speeds,
      Vector                     forces) const
    {
      Assert(system.n_friction_states() == 0,
             dealii::ExcMessage("The states of friction are missing."));
      const Eigen::VectorXd no_states;
      assemble_forces(q, v, approach_speeds, no_states, forces);
    }



    void
    EquationsOfMotion::assemble_forces(
      ConstVector                q,
      ConstVector                v,
      const std::vector<double> &approach_speeds,
      ConstVector                z,
      Vector                     forces) const
    {
      forces = system.weights();
      for (const Spring &spring : system.springs())
        spring.bodies.add_to(
          spring.compute_force(spring.bodies.gather(q), spring.bodies.gather(v))
            .force,
          forces);
      for (unsigned int j = 0; j < clearances.size(); ++j)
        {
          const ClearanceJoint &joint   = system.clearance_joints()[j];
          const PairVector      local_q = joint.bodies.gather(q);
          const JointContact    contact =
            joint.compute_contact(local_q,
                                  joint.bodies.gather(v),
                                  clearances[j],
                                  approach_speeds[j],
                                  friction_state(joint, z));
          if (contact.penetration > 0)
            joint.bodies.add_to(joint.compute_force(local_q, contact), forces);
        }
    }



    void
    EquationsOfMotion::assemble_friction_state_rates(
      ConstVector                q,
      ConstVector                v,
      const std::vector<double> &approach_speeds,
      ConstVector                z,
      Vector                     rates) const
    {
      for (unsigned int j = 0; j < clearances.size(); ++j)
        {
          const ClearanceJoint &joint = system.clearance_joints()[j];
          const int             k     = joint.friction_state_index;
          if (k >= 0)
            rates(k) = joint.compute_friction_state_rate(
              compute_contact(j, q, v, approach_speeds[j], z(k)), z(k));
        }
    }



    void
    EquationsOfMotion::subtract_friction_state_derivatives(
      ConstVector                q,
      ConstVector                v,
      const std::vector<double> &approach_speeds,
      ConstVector                z,
      Matrix                     minus_force_d_state,
      Matrix                     minus_rate_d_position,
      Matrix                     minus_rate_d_velocity,
      Matrix                     minus_rate_d_state) const
    {
      for (unsigned int j = 0; j < clearances.size(); ++j)
        {
          const ClearanceJoint &joint = system.clearance_joints()[j];
          const int             k     = joint.friction_state_index;
          if (k < 0)
            continue;
          const ClearanceForce f =
            joint.compute_force_with_derivatives(joint.bodies.gather(q),
                                                 joint.bodies.gather(v),
                                                 clearances[j],
                                                 approach_speeds[j],
                                                 z(k));
          joint.bodies.add_to(PairVector(-f.d_state),
                              minus_force_d_state.col(k));
          for (const int l : {0, 1})
            if (joint.bodies.body(l) != ground_body)
              {
                const int first = 3 * joint.bodies.body(l);
                minus_rate_d_position.block<1, 3>(k, first) -=
                  f.rate_d_position.segment<3>(3 * l);
                minus_rate_d_velocity.block<1, 3>(k, first) -=
                  f.rate_d_velocity.segment<3>(3 * l);
              }
          minus_rate_d_state(k, k) -= f.rate_d_state;
        }
    }



    void
    EquationsOfMotion::subtract_force_derivatives(
      ConstVector                q,
      ConstVector                v,
      const std::vector<double> &approach_speeds,
      ConstVector                z,
      Matrix                     minus_d_position,
      Matrix                     minus_d_velocity) const
    {
      const auto subtract = [&](const BodyPair &bodies, const PairForce &f) {
        bodies.add_to(PairMatrix(-f.d_position), minus_d_position);
        bodies.add_to(PairMatrix(-f.d_velocity), minus_d_velocity);
      };
      for (const Spring &spring : system.springs())
        subtract(spring.bodies,
                 spring.compute_force(spring.bodies.gather(q),
                                      spring.bodies.gather(v)));
      for (unsigned int j = 0; j < clearances.size(); ++j)
        {
          const ClearanceJoint &joint = system.clearance_joints()[j];
          subtract(joint.bodies,
                   joint.compute_force_with_derivatives(joint.bodies.gather(q),
                                                        joint.bodies.gather(v),
                                                        clearances[j],
                                                        approach_speeds[j],
                                                        friction_state(joint,
                                                                       z)));
        }
    }



    double
    EquationsOfMotion::compute_penetration(const unsigned int joint,
                                           ConstVector        q) const
    {
      const ClearanceJoint &j = system.clearance_joints()[joint];
      return j.compute_penetration(j.bodies.gather(q), clearances[joint]);
    }



    JointContact
    EquationsOfMotion::compute_contact(const unsigned int joint,
                                       ConstVector        q,
                                       ConstVector        v,
                                       const double       approach_speed,
                                       const double       friction_state) const
    {
      const ClearanceJoint &j = system.clearance_joints()[joint];
      return j.compute_contact(j.bodies.gather(q),
                               j.bodies.gather(v),
                               clearances[joint],
                               approach_speed,
                               friction_state);
    }



    JointContact
    EquationsOfMotion::compute_contact(const unsigned int    joint,
                                       const MechanismState &state) const
    {
      return compute_contact(joint,
                             state.q,
                             state.v,
                             state.approach_speeds[joint],
                             friction_state(system.clearance_joints()[joint],
                                            state.friction_states));
    }



    Energy
    EquationsOfMotion::compute_energy(ConstVector q, ConstVector v) const
    {
      Energy energy = {v.dot(system.masses().cwiseProduct(v)) / 2,
                       -system.weights().dot(q)};
      for (const Spring &spring : system.springs())
        energy.potential += spring.potential_energy(spring.bodies.gather(q));
      return energy;
    }



    std::vector<ClearanceProfile>
    nominal_clearances(const Mechanism &mechanism)
    {
      std::vector<ClearanceProfile> clearances;
      for (const ClearanceJoint &joint : mechanism.clearance_joints())
        clearances.emplace_back(joint.nominal_clearance());
      return clearances;
    }
  } // namespace Multibody
} // namespace Tribody

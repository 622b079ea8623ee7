// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>

#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/mechanism.h>
#include <tribody/multibody/system/mechanism_state.h>

#include <algorithm>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // Of all states, the one of this joint; zero if its law has none or none
      // are given.
      double
      friction_state(const ClearanceJoint                    &joint,
                     const Eigen::Ref<const Eigen::VectorXd> &z)
      {
        return joint.friction_state_index < 0 || z.size() == 0
                 ? 0.
                 : z(joint.friction_state_index);
      }
    } // namespace



    EquationsOfMotion::EquationsOfMotion(
      const Mechanism                   &mechanism,
      const std::vector<JointClearance> &clearances,
      const Supports                    &supports)
      : system(mechanism)
    {
      const std::vector<ClearanceJoint> &joints = mechanism.clearance_joints();
      Assert(clearances.size() == joints.size(),
             dealii::ExcMessage("One clearance per clearance joint."));
      Assert(supports.empty() || supports.size() == joints.size(),
             dealii::ExcMessage("One support per clearance joint, or none."));
      for (unsigned int j = 0; j < joints.size(); ++j)
        conditions.push_back(
          joints[j].make_condition(clearances[j],
                                   supports.empty() ? nullptr : supports[j]));
      if (system.n_redundant() > 0)
        set_compliances();
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
    EquationsOfMotion::add_constraint_jacobian(ConstVector        q,
                                               const Eigen::Index first,
                                               MatrixEntries     &entries) const
    {
      for (const auto &[element, row] : system.constraints())
        {
          const Constraint::Jacobian local =
            element->jacobian(element->bodies.gather(q));
          const auto rows = local.topRows(element->n_equations);
          element->bodies.add_rows_to(rows, first + row, 0, entries);
          element->bodies.add_columns_to(rows.transpose(),
                                         0,
                                         first + row,
                                         entries);
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
              element->weighted_hessian(local_q, Constraint::Values::Unit(k)) *
              local_v);
        }
    }



    void
    EquationsOfMotion::set_compliances()
    {
      // Under the weight of the heaviest body, this part of the size.
      constexpr double part = 1e-10, gravity = 9.81;
      // Of a rate per unit of mu. It decides nothing, as mu is zero but for
      // roundings and what gives way above: far below the squares of the
      // singular values of Phi_q, far above what rounding leaves of them.
      constexpr double part_of_rates = 1e-5;
      const double     size          = system.size();
      double           mass          = 0.;
      for (const BodyParameters &body : system.parameters().bodies)
        mass =
          std::max({mass, body.mass, body.moment_of_inertia / size / size});
      const double length_per_force =
        part * size / ((mass > 0. ? mass : 1.) * gravity);
      compliances.resize(system.n_constraints());
      rate_compliances.resize(system.n_constraints());
      for (const auto &[element, row] : system.constraints())
        for (unsigned int i = 0; i < element->n_equations; ++i)
          {
            const bool is_angle = element->is_angle(i);
            compliances(row + i) =
              length_per_force / (is_angle ? size * size : 1.);
            rate_compliances(row + i) =
              part_of_rates * (is_angle ? 1. : std::min(1., size * size));
          }
    }



    void
    EquationsOfMotion::assemble_constraint_terms(const double t,
                                                 ConstVector  q,
                                                 ConstVector  v,
                                                 ConstVector  lambda,
                                                 ConstVector  mu,
                                                 Vector       phi,
                                                 Vector       phi_rate,
                                                 Vector       forces,
                                                 Vector       rates) const
    {
      for (const auto &[element, row] : system.constraints())
        {
          const unsigned int         n        = element->n_equations;
          const BodyPair            &bodies   = element->bodies;
          const PairVector           local_q  = bodies.gather(q);
          const Constraint::Jacobian jacobian = element->jacobian(local_q);

          phi.segment(row, n) = element->value(t, local_q).head(n);
          phi_rate.segment(row, n) =
            (jacobian * bodies.gather(v) + element->time_derivative(t)).head(n);
          bodies.add_to(PairVector(jacobian.transpose() *
                                   element->gather(lambda, row)),
                        forces);
          bodies.add_to(PairVector(-jacobian.transpose() *
                                   element->gather(mu, row)),
                        rates);
        }
      if (system.n_redundant() > 0)
        {
          phi -= compliances.cwiseProduct(lambda);
          phi_rate -= rate_compliances.cwiseProduct(mu);
        }
    }



    void
    EquationsOfMotion::add_constraint_derivatives(ConstVector         q,
                                                  ConstVector         v,
                                                  ConstVector         lambda,
                                                  ConstVector         mu,
                                                  const FirstIndices &first,
                                                  MatrixEntries &entries) const
    {
      for (const auto &[element, row] : system.constraints())
        {
          const unsigned int         n        = element->n_equations;
          const BodyPair            &bodies   = element->bodies;
          const PairVector           local_q  = bodies.gather(q);
          const PairVector           local_v  = bodies.gather(v);
          const Constraint::Jacobian jacobian = element->jacobian(local_q);

          // q' - v - Phi_q^T mu and M v' - Q + Phi_q^T lambda
          bodies.add_to(element->weighted_hessian(local_q,
                                                  -element->gather(mu, row)),
                        first.q,
                        first.q,
                        entries);
          bodies.add_to(element->weighted_hessian(local_q,
                                                  element->gather(lambda, row)),
                        first.v,
                        first.q,
                        entries);
          bodies.add_columns_to(-jacobian.topRows(n).transpose(),
                                first.q,
                                first.mu + row,
                                entries);
          bodies.add_columns_to(jacobian.topRows(n).transpose(),
                                first.v,
                                first.lambda + row,
                                entries);

          // Phi and Phi_q v + Phi_t
          bodies.add_rows_to(jacobian.topRows(n),
                             first.lambda + row,
                             first.q,
                             entries);
          bodies.add_rows_to(jacobian.topRows(n),
                             first.mu + row,
                             first.v,
                             entries);
          for (unsigned int k = 0; k < n; ++k)
            bodies.add_rows_to(
              (element->weighted_hessian(local_q, Constraint::Values::Unit(k)) *
               local_v)
                .transpose(),
              first.mu + row + k,
              first.q,
              entries);
        }
      if (system.n_redundant() > 0)
        for (Eigen::Index i = 0; i < compliances.size(); ++i)
          {
            entries.add(first.lambda + i, first.lambda + i, -compliances(i));
            entries.add(first.mu + i, first.mu + i, -rate_compliances(i));
          }
    }



    void
    EquationsOfMotion::assemble_forces(
      const double               t,
      ConstVector                q,
      ConstVector                v,
      const std::vector<double> &approach_speeds,
      Vector                     forces) const
    {
      const Eigen::VectorXd no_states;
      assemble_forces(t, q, v, approach_speeds, no_states, forces);
    }



    void
    EquationsOfMotion::assemble_forces(
      const double               t,
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
      for (const RotationalSpring &spring : system.rotational_springs())
        spring.bodies.add_to(
          spring.compute_force(spring.bodies.gather(q), spring.bodies.gather(v))
            .force,
          forces);
      for (const AppliedForce &force : system.applied_forces())
        {
          const int i = 3 * force.marker.body;
          forces.segment<3>(i) += force.compute_force(t, q.segment<3>(i)).force;
        }
      for (const AppliedTorque &torque : system.applied_torques())
        torque.bodies.add_to(torque.compute_force(t), forces);
      for (unsigned int j = 0; j < conditions.size(); ++j)
        {
          const ClearanceJoint &joint   = system.clearance_joints()[j];
          const PairVector      local_q = joint.bodies.gather(q);
          const JointContact    contact =
            joint.compute_contact(local_q,
                                  joint.bodies.gather(v),
                                  conditions[j],
                                  approach_speeds[j],
                                  friction_state(joint, z));
          if (contact.penetration >= 0)
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
      for (unsigned int j = 0; j < conditions.size(); ++j)
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
      const Eigen::Index         row,
      const Eigen::Index         q_column,
      const Eigen::Index         v_column,
      const Eigen::Index         state,
      MatrixEntries             &entries) const
    {
      for (unsigned int j = 0; j < conditions.size(); ++j)
        {
          const ClearanceJoint &joint = system.clearance_joints()[j];
          const int             k     = joint.friction_state_index;
          if (k < 0)
            continue;
          const ClearanceForce f =
            joint.compute_force_with_derivatives(joint.bodies.gather(q),
                                                 joint.bodies.gather(v),
                                                 conditions[j],
                                                 approach_speeds[j],
                                                 z(k));
          for (const int l : {0, 1})
            if (joint.bodies.body(l) != ground_body)
              {
                const int first = 3 * joint.bodies.body(l);
                entries.add_block(row + first,
                                  state + k,
                                  -f.d_state.segment<3>(3 * l));
                entries.add_block(state + k,
                                  q_column + first,
                                  -f.rate_d_position.segment<3>(3 * l));
                entries.add_block(state + k,
                                  v_column + first,
                                  -f.rate_d_velocity.segment<3>(3 * l));
              }
          entries.add(state + k, state + k, -f.rate_d_state);
        }
    }



    void
    EquationsOfMotion::subtract_force_derivatives(
      const double               t,
      ConstVector                q,
      ConstVector                v,
      const std::vector<double> &approach_speeds,
      ConstVector                z,
      const Eigen::Index         row,
      const Eigen::Index         q_column,
      const Eigen::Index         v_column,
      MatrixEntries             &entries) const
    {
      const auto subtract = [&](const BodyPair &bodies, const PairForce &f) {
        bodies.add_to(PairMatrix(-f.d_position), row, q_column, entries);
        bodies.add_to(PairMatrix(-f.d_velocity), row, v_column, entries);
      };
      for (const Spring &spring : system.springs())
        subtract(spring.bodies,
                 spring.compute_force(spring.bodies.gather(q),
                                      spring.bodies.gather(v)));
      for (const RotationalSpring &spring : system.rotational_springs())
        subtract(spring.bodies,
                 spring.compute_force(spring.bodies.gather(q),
                                      spring.bodies.gather(v)));
      for (const AppliedForce &force : system.applied_forces())
        {
          const int i = 3 * force.marker.body;
          entries.add_block(
            row + i,
            q_column + i,
            -force.compute_force(t, q.segment<3>(i)).d_position);
        }
      for (unsigned int j = 0; j < conditions.size(); ++j)
        {
          const ClearanceJoint &joint = system.clearance_joints()[j];
          subtract(joint.bodies,
                   joint.compute_force_with_derivatives(joint.bodies.gather(q),
                                                        joint.bodies.gather(v),
                                                        conditions[j],
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
      return j.compute_penetration(j.bodies.gather(q), conditions[joint]);
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
                               conditions[joint],
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
      for (const RotationalSpring &spring : system.rotational_springs())
        energy.potential += spring.potential_energy(spring.bodies.gather(q));
      return energy;
    }



    std::vector<JointClearance>
    nominal_clearances(const Mechanism &mechanism)
    {
      std::vector<JointClearance> clearances;
      for (const ClearanceJoint &joint : mechanism.clearance_joints())
        clearances.emplace_back(PeriodicProfile(joint.nominal_clearance()));
      return clearances;
    }
  } // namespace Multibody
} // namespace Tribody

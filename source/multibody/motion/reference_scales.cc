// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <tribody/multibody/motion/dynamics_parameters.h>
#include <tribody/multibody/motion/motion_integrator.h>
#include <tribody/multibody/motion/reference_scales.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // Where the sliding of a joint reverses, the speed must be known better
      // than friction's transition is wide, already at an accuracy of 1e-3: the
      // two-joint PTFE mechanism did not settle otherwise.
      constexpr double transition_factor = 3.;

      // A joint is loose if its clearance is larger than this many
      // penetrations.
      constexpr double loose_clearance = 10.;

      // What impacts multiply errors by, as far as it is known beforehand.
      constexpr double error_growth_of_impacts = 10.;



      // A joint over a cycle with ideal joints.
      struct IdealJoint
      {
        // Mean reaction [N], and the mean of its vector in the bushing's
        // frame; zero if not known.
        double          mean_force    = 0.;
        Eigen::Vector2d mean_reaction = Eigen::Vector2d::Zero();
        // Range of the angular speed of pin against bushing [rad/s]; such
        // that it contains zero if not known.
        double slowest = 0., fastest = 0.;
      };



      void
      add_sample(const Mechanism         &mechanism,
                 const Motion            &motion,
                 const bool               is_first,
                 const double             weight,
                 std::vector<IdealJoint> &joints)
      {
        for (unsigned int j = 0; j < joints.size(); ++j)
          {
            const JointEntry &entry = mechanism.joints()[j];
            if (!entry.is_revolute)
              continue;
            const unsigned int row =
              mechanism.constraints()[entry.index].first_row;
            const PairVector      v        = entry.bodies.gather(motion.v);
            const double          speed    = v(2) - v(5);
            const Eigen::Vector2d reaction = motion.multipliers.segment<2>(row);
            joints[j].mean_force += weight * reaction.norm();
            joints[j].mean_reaction +=
              weight * turned(reaction, -entry.bodies.gather(motion.q)(5));
            joints[j].slowest =
              is_first ? speed : std::min(joints[j].slowest, speed);
            joints[j].fastest =
              is_first ? speed : std::max(joints[j].fastest, speed);
          }
      }



      std::vector<IdealJoint>
      run_ideal_cycle(const EquationsOfMotion &closed,
                      const double             given_period)
      {
        const Mechanism        &mechanism = closed.mechanism();
        std::vector<IdealJoint> joints(mechanism.joints().size());
        if (mechanism.n_degrees_of_freedom() != 0)
          return joints;
        const ConstraintOffsets none(mechanism.n_constraints());
        const Eigen::VectorXd   no_force =
          Eigen::VectorXd::Zero(mechanism.n_coordinates());
        const double period =
          given_period > 0 ? given_period : mechanism.period();
        constexpr unsigned int n_samples = 72;
        Eigen::VectorXd        q         = assemble_configuration(closed, 0.);
        for (unsigned int k = 0; k < n_samples; ++k)
          {
            const double t      = k * period / n_samples;
            const Motion motion = solve_motion(closed, t, none, no_force, q);
            q                   = motion.q;
            add_sample(mechanism, motion, k == 0, 1. / n_samples, joints);
          }
        return joints;
      }



      // Largest eigenvalue of the inverse mass that a force in the joint
      // meets, the other constraints holding.
      double
      largest_inverse_mass(const Mechanism         &mechanism,
                           const EquationsOfMotion &closed,
                           const Eigen::VectorXd   &q,
                           const unsigned int       joint)
      {
        const unsigned int      n = mechanism.n_coordinates();
        const unsigned int      m = mechanism.n_constraints();
        const EquationsOfMotion open(mechanism, nominal_clearances(mechanism));

        Eigen::MatrixXd phi_q(closed.mechanism().n_constraints(), n);
        closed.assemble_constraint_jacobian(q, phi_q);
        const NumberedConstraint &c =
          closed.mechanism()
            .constraints()[closed.mechanism().joints()[joint].index];
        const Eigen::MatrixXd e_q = phi_q.middleRows(c.first_row, 2);

        Eigen::MatrixXd matrix    = Eigen::MatrixXd::Zero(n + m, n + m);
        matrix.diagonal().head(n) = mechanism.masses();
        open.assemble_constraint_jacobian(q, matrix.bottomLeftCorner(m, n));
        matrix.topRightCorner(n, m) = matrix.bottomLeftCorner(m, n).transpose();
        Eigen::MatrixXd forces      = Eigen::MatrixXd::Zero(n + m, 2);
        forces.topRows(n)           = e_q.transpose();
        // Redundant constraints leave it singular, and what is asked unique.
        Eigen::MatrixXd solution;
        if (mechanism.n_redundant() > 0)
          solution = matrix.fullPivLu().solve(forces);
        else
          solution = matrix.partialPivLu().solve(forces);
        const Eigen::Matrix2d inverse_mass = e_q * solution.topRows(n);
        return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(inverse_mass)
          .eigenvalues()
          .maxCoeff();
      }



      // Penetration at rest under the force of @p scale, and how the normal
      // force changes there with penetration and rate.
      NormalForce
      find_reference_contact(const ClearanceJoint  &joint,
                             const Eigen::Vector2d &mean_reaction,
                             const PinSupport      *support,
                             ReferenceScale        &scale)
      {
        if (support == nullptr)
          {
            scale.penetration = compute_penetration(
              joint.contact_law, scale.force, 0., joint.minimum_approach_speed);
            return compute_normal_force(joint.contact_law,
                                        {scale.penetration,
                                         0.,
                                         joint.minimum_approach_speed});
          }
        const Eigen::Vector2d direction =
          mean_reaction.norm() > 0.
            ? Eigen::Vector2d(mean_reaction.normalized())
            : Eigen::Vector2d::UnitX();
        const Eigen::Vector2d e =
          support->find_position(scale.force * direction, 0.);
        const SupportForce f = support->compute_force(e, 0.);
        // The displacement over which the force changes by its own size.
        NormalForce contact = compute_normal_force(
          joint.contact_law,
          {1., 0., joint.minimum_approach_speed, f.force.norm()});
        contact.d_penetration =
          direction.dot(f.d_force.leftCols<2>() * direction);
        scale.penetration = scale.force / contact.d_penetration;
        return contact;
      }



      // What follows from the laws of contact and friction.
      void
      add_contact_scale(const ClearanceJoint &joint,
                        const IdealJoint     &ideal,
                        const double          inverse_mass,
                        const PinSupport     *support,
                        ReferenceScale       &scale)
      {
        const NormalForce contact =
          find_reference_contact(joint, ideal.mean_reaction, support, scale);
        scale.frequency = std::sqrt(contact.d_penetration * inverse_mass);
        scale.speed     = scale.penetration * scale.frequency;
        if (contact.d_penetration_rate > 0)
          scale.speed =
            std::min(scale.speed, scale.force / contact.d_penetration_rate);
        if (ideal.slowest <= 0 && ideal.fastest >= 0)
          scale.speed = std::min(scale.speed,
                                 transition_factor * compute_transition_speed(
                                                       joint.friction_law));
        scale.is_loose =
          joint.nominal_clearance() > loose_clearance * scale.penetration;
        scale.friction_state =
          compute_steady_friction_state(joint.friction_law,
                                        std::numeric_limits<double>::min());
      }



      // The last bounces before a pin is captured, as high as the capture speed
      // carries them, must be right too.
      void
      resolve_bounces(const Mechanism   &mechanism,
                      const unsigned int joint,
                      const double       inverse_mass,
                      ReferenceScale    &scale)
      {
        for (const ImpactJoint &pin : mechanism.impact_joints())
          if (pin.joint == joint)
            {
              scale.speed       = std::min(scale.speed, pin.capture_speed);
              scale.penetration = std::min(scale.penetration,
                                           scale.speed * scale.speed /
                                             (scale.force * inverse_mass));
            }
      }
    } // namespace



    std::vector<ReferenceScale>
    compute_reference_scales(
      const Mechanism                                      &mechanism,
      const EquationsOfMotion                              &closed,
      const double                                          period,
      const std::vector<std::shared_ptr<const PinSupport>> &supports)
    {
      const auto &joints = mechanism.joints();
      if (mechanism.has_only_ideal_joints())
        return {};
      const std::vector<IdealJoint> ideal = run_ideal_cycle(closed, period);
      const double          default_force = mechanism.masses().maxCoeff();
      const Eigen::VectorXd q             = assemble_configuration(closed, 0.);

      std::vector<ReferenceScale> scales;
      for (unsigned int j = 0; j < ideal.size(); ++j)
        {
          const JointEntry &entry = joints[j];
          if (!entry.has_gap())
            continue;
          ReferenceScale scale;
          scale.bodies = entry.bodies;
          scale.force  = ideal[j].mean_force > 1e-3 * default_force
                           ? ideal[j].mean_force
                           : default_force;
          const double inverse_mass =
            largest_inverse_mass(mechanism, closed, q, j);
          if (entry.has_contact_law())
            add_contact_scale(mechanism.clearance_joints()[entry.index],
                              ideal[j],
                              inverse_mass,
                              supports.empty() ? nullptr
                                               : supports[entry.index].get(),
                              scale);
          else
            {
              scale.penetration = entry.link->length;
              scale.frequency =
                std::sqrt(scale.force * inverse_mass / scale.penetration);
              scale.speed          = scale.penetration * scale.frequency;
              scale.friction_state = 0.;
              scale.is_loose       = false;
              if (entry.model == JointModel::impact)
                resolve_bounces(mechanism, j, inverse_mass, scale);
            }
          scales.push_back(scale);
        }
      return scales;
    }



    namespace
    {
      // A penetration [m] and its speed [m/s].
      struct Resolution
      {
        double length;
        double speed;
      };



      // The finest that a joint asks for.
      Resolution
      find_finest(const Mechanism                   &mechanism,
                  const std::vector<ReferenceScale> &scales,
                  const DynamicsParameters          &parameters)
      {
        if (scales.empty())
          {
            // A part of the mechanism's size, at the pace of a cycle.
            double cycle = 2 * dealii::numbers::PI;
            if (parameters.cycle_duration > 0)
              cycle = parameters.cycle_duration;
            else if (mechanism.has_turning_driver())
              cycle = mechanism.period();
            const double length = 1e-4 * mechanism.size();
            return {length, length * 2 * dealii::numbers::PI / cycle};
          }
        constexpr double infinity = std::numeric_limits<double>::infinity();
        Resolution       finest   = {infinity, infinity};
        for (const ReferenceScale &scale : scales)
          finest = {std::min(finest.length, scale.penetration),
                    std::min(finest.speed, scale.speed)};
        return finest;
      }



      // The finest that a joint of @p body asks for; @p otherwise if there is
      // none.
      Resolution
      find_finest_of(const int                          body,
                     const std::vector<ReferenceScale> &scales,
                     const Resolution                  &otherwise)
      {
        bool       is_first = true;
        Resolution finest   = otherwise;
        for (const ReferenceScale &scale : scales)
          {
            if (scale.bodies.first != body && scale.bodies.second != body)
              continue;
            finest   = is_first
                         ? Resolution{scale.penetration, scale.speed}
                         : Resolution{std::min(finest.length, scale.penetration),
                                    std::min(finest.speed, scale.speed)};
            is_first = false;
          }
        return finest;
      }
    } // namespace



    MotionTolerances
    make_tolerances(const Mechanism                   &mechanism,
                    const std::vector<ReferenceScale> &scales,
                    const DynamicsParameters          &parameters)
    {
      const Resolution finest = find_finest(mechanism, scales, parameters);
      MotionTolerances tolerances;
      tolerances.positions.resize(mechanism.n_coordinates());
      tolerances.velocities.resize(mechanism.n_coordinates());
      for (unsigned int i = 0; i < mechanism.parameters().bodies.size(); ++i)
        {
          const auto [length, speed] = find_finest_of(i, scales, finest);
          double lever               = 0.;
          for (const auto &[name, p] : mechanism.parameters().bodies[i].markers)
            lever = std::max(lever, p.norm());
          if (lever == 0)
            lever = mechanism.size();
          tolerances.positions.segment<3>(3 * i) << length, length,
            length / lever;
          tolerances.velocities.segment<3>(3 * i) << speed, speed,
            speed / lever;
        }
      tolerances.friction_states.resize(mechanism.n_friction_states());
      unsigned int n_states = 0;
      for (const ReferenceScale &scale : scales)
        if (scale.friction_state > 0)
          tolerances.friction_states(n_states++) = scale.friction_state;
      const auto is_loose = [](const ReferenceScale &scale) {
        return scale.is_loose;
      };
      const double accuracy =
        std::any_of(scales.begin(), scales.end(), is_loose)
          ? parameters.accuracy / error_growth_of_impacts
          : parameters.accuracy;
      tolerances.positions *= accuracy;
      tolerances.velocities *= accuracy;
      tolerances.friction_states *= accuracy;
      tolerances.maximum_order = parameters.maximum_order;
      if (tolerances.maximum_order == 0)
        tolerances.maximum_order =
          std::all_of(scales.begin(), scales.end(), is_loose) ? 5 : 2;
      // At the start and after an impact BDF is of first order: its error is
      // half the second derivative, of the size of penetration times frequency
      // squared, times the square of the step.
      double fastest = 0.;
      for (const ReferenceScale &scale : scales)
        fastest = std::max(fastest, scale.frequency);
      if (!scales.empty())
        tolerances.initial_step = 0.5 * std::sqrt(accuracy) / fastest;
      return tolerances;
    }
  } // namespace Multibody
} // namespace Tribody

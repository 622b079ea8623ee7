#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <tribody/multibody/dynamics_parameters.h>
#include <tribody/multibody/equations_of_motion.h>
#include <tribody/multibody/kinematics.h>
#include <tribody/multibody/mechanism.h>
#include <tribody/multibody/motion_integrator.h>
#include <tribody/multibody/reference_scales.h>

#include <algorithm>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // Mean reaction of each joint of the closed mechanism over a cycle.
      std::vector<double>
      mean_ideal_forces(const EquationsOfMotion &closed)
      {
        const Mechanism        &mechanism = closed.mechanism();
        std::vector<double>     means(mechanism.joints().size(), 0.);
        const ConstraintOffsets none(mechanism.n_constraints());
        const Eigen::VectorXd   no_force =
          Eigen::VectorXd::Zero(mechanism.n_coordinates());
        constexpr unsigned int n_samples = 72;
        Eigen::VectorXd        q         = assemble_configuration(closed, 0.);
        for (unsigned int k = 0; k < n_samples; ++k)
          {
            const double t      = k * mechanism.period() / n_samples;
            const Motion motion = solve_motion(closed, t, none, no_force, q);
            q                   = motion.q;
            for (unsigned int j = 0; j < means.size(); ++j)
              {
                const NumberedConstraint &c =
                  mechanism.constraints()[mechanism.joints()[j].index];
                means[j] +=
                  motion.multipliers.segment<2>(c.first_row).norm() / n_samples;
              }
          }
        return means;
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
        const Eigen::Matrix2d inverse_mass =
          e_q * matrix.partialPivLu().solve(forces).topRows(n);
        return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(inverse_mass)
          .eigenvalues()
          .maxCoeff();
      }
    } // namespace



    std::vector<ReferenceScale>
    compute_reference_scales(const Mechanism         &mechanism,
                             const EquationsOfMotion &closed)
    {
      if (mechanism.clearance_joints().empty())
        return {};
      std::vector<double> forces(mechanism.joints().size(), 0.);
      if (closed.mechanism().n_degrees_of_freedom() == 0)
        forces = mean_ideal_forces(closed);
      const double          default_force = mechanism.masses().maxCoeff();
      const Eigen::VectorXd q             = assemble_configuration(closed, 0.);

      std::vector<ReferenceScale> scales;
      for (unsigned int j = 0; j < forces.size(); ++j)
        {
          const JointEntry &entry = mechanism.joints()[j];
          if (!entry.has_clearance)
            continue;
          const ClearanceJoint &joint =
            mechanism.clearance_joints()[entry.index];
          ReferenceScale scale;
          scale.force =
            forces[j] > 1e-3 * default_force ? forces[j] : default_force;
          scale.penetration = compute_penetration(joint.contact_law,
                                                  scale.force,
                                                  0.,
                                                  joint.minimum_approach_speed);
          const double stiffness =
            compute_normal_force(joint.contact_law,
                                 {scale.penetration,
                                  0.,
                                  joint.minimum_approach_speed})
              .d_penetration;
          scale.frequency = std::sqrt(
            stiffness * largest_inverse_mass(mechanism, closed, q, j));
          scales.push_back(scale);
        }
      return scales;
    }



    MotionTolerances
    make_tolerances(const Mechanism                   &mechanism,
                    const std::vector<ReferenceScale> &scales,
                    const DynamicsParameters          &parameters)
    {
      const unsigned int n_bodies = mechanism.parameters().bodies.size();
      // Without contacts: the size of the mechanism, and radians per second.
      double shortest = 1e-4 * mechanism.size(), fastest = 1.;
      for (const ReferenceScale &scale : scales)
        {
          shortest = std::min(shortest, scale.penetration);
          fastest  = std::max(fastest, scale.frequency);
        }

      MotionTolerances tolerances;
      tolerances.positions.resize(mechanism.n_coordinates());
      tolerances.velocities.resize(mechanism.n_coordinates());
      for (unsigned int i = 0; i < n_bodies; ++i)
        {
          double length = 0., frequency = 0.;
          for (unsigned int j = 0; j < scales.size(); ++j)
            {
              const BodyPair &bodies = mechanism.clearance_joints()[j].bodies;
              if (bodies.first != static_cast<int>(i) &&
                  bodies.second != static_cast<int>(i))
                continue;
              length    = (length == 0) ? scales[j].penetration
                                        : std::min(length, scales[j].penetration);
              frequency = std::max(frequency, scales[j].frequency);
            }
          if (length == 0)
            {
              length    = shortest;
              frequency = fastest;
            }
          double lever = 0.;
          for (const auto &[name, p] : mechanism.parameters().bodies[i].markers)
            lever = std::max(lever, p.norm());
          if (lever == 0)
            lever = mechanism.size();
          tolerances.positions.segment<3>(3 * i) << length, length,
            length / lever;
          tolerances.velocities.segment<3>(3 * i) =
            frequency * tolerances.positions.segment<3>(3 * i);
        }
      tolerances.positions *= parameters.accuracy;
      tolerances.velocities *= parameters.accuracy;
      tolerances.maximum_order = parameters.maximum_order;
      if (tolerances.maximum_order == 0)
        tolerances.maximum_order = scales.empty() ? 5 : 2;
      // At the start and after an impact BDF is of first order: its error is
      // half the second derivative, of the size of penetration times frequency
      // squared, times the square of the step.
      if (!scales.empty())
        tolerances.initial_step =
          0.5 * std::sqrt(parameters.accuracy) / fastest;
      return tolerances;
    }
  } // namespace Multibody
} // namespace Tribody

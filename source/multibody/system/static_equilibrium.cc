// SPDX-License-Identifier: LGPL-2.1-or-later

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include <tribody/base/interruption.h>
#include <tribody/base/significant_digits.h>
#include <tribody/multibody/system/constraint_gaps.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>
#include <tribody/multibody/system/static_equilibrium.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // Residual of the balance of forces at which it counts as zero.
      constexpr double tolerance = 1e-11;



      // Balance of the forces at one position. Coordinates are scaled: angles
      // count times the mechanism's size.
      struct Balance
      {
        Eigen::VectorXd multipliers;
        // Applied forces, and the sum of their magnitudes [N].
        Eigen::VectorXd forces;
        double          force_scale = 0.;
        // Columns: directions that the constraints leave free, orthonormal.
        Eigen::MatrixXd free;
        // Forces [N] and stiffness [N/m] in these directions.
        Eigen::VectorXd free_forces;
        Eigen::MatrixXd stiffness;
        // Of the symmetric part of the stiffness.
        double          least_stiffness = 0.;
        double          stiffness_scale = 0.;
        Eigen::VectorXd softest_direction;
        // What rounding of coordinates and reactions leaves of the forces [N].
        double rounding = 0.;

        double
        residual() const
        {
          return force_scale > 0 && free_forces.size() > 0
                   ? free_forces.norm() / force_scale
                   : 0.;
        }

        // Rounding leaves about 1e-14 of the scale.
        bool
        is_stable() const
        {
          return free.cols() == 0 || least_stiffness > -1e-10 * stiffness_scale;
        }
      };



      class StaticSolver
      {
      public:
        StaticSolver(const EquationsOfMotion &equations, const double t);

        StaticEquilibrium
        solve(const Eigen::VectorXd &q_guess);

      private:
        Eigen::VectorXd
        applied_forces(const Eigen::VectorXd &q) const;

        // Sum of the magnitudes of all forces: their resultant may vanish.
        double
        compute_force_scale(const Eigen::VectorXd &q) const;

        Balance
        compute_balance(const Eigen::VectorXd &q) const;

        // Move by a step in the free directions, if that lowers the potential
        // energy. Changes q only then.
        bool
        try_step(const Balance         &balance,
                 const Eigen::VectorXd &step,
                 Eigen::VectorXd       &q) const;

        // What to add to the stiffness, in all: sigma at least.
        double
        compute_shift(const Balance &balance, const double sigma) const;

        // Newton's step in the free directions with a shifted stiffness, cut
        // to the longest one.
        Eigen::VectorXd
        compute_step(const Balance &balance, const double shift) const;

        bool
        has_converged(const Balance         &balance,
                      const double           shift,
                      const Eigen::VectorXd &step) const;

        double
        longest_step() const
        {
          return 0.3 * mechanism.size();
        }

        // Which body is out of balance, for messages.
        std::string
        describe(const Balance &balance) const;

        const EquationsOfMotion &equations;
        const Mechanism         &mechanism;
        const double             t;
        const ConstraintOffsets  none;
        std::vector<double>      approach_speeds;
        // Metres per unit of each coordinate.
        Eigen::VectorXd scales;
      };



      StaticSolver::StaticSolver(const EquationsOfMotion &equations,
                                 const double             t)
        : equations(equations)
        , mechanism(equations.mechanism())
        , t(t)
        , none(mechanism.n_constraints())
        , scales(Eigen::VectorXd::Ones(mechanism.n_coordinates()))
      {
        for (const ClearanceJoint &joint : mechanism.clearance_joints())
          approach_speeds.push_back(joint.minimum_approach_speed);
        for (unsigned int i = 2; i < mechanism.n_coordinates(); i += 3)
          scales(i) = mechanism.size();
      }



      Eigen::VectorXd
      StaticSolver::applied_forces(const Eigen::VectorXd &q) const
      {
        Eigen::VectorXd forces(q.size());
        equations.assemble_forces(
          t, q, Eigen::VectorXd::Zero(q.size()), approach_speeds, forces);
        return forces;
      }



      double
      StaticSolver::compute_force_scale(const Eigen::VectorXd &q) const
      {
        const Eigen::VectorXd v           = Eigen::VectorXd::Zero(q.size());
        const auto            scaled_norm = [&](const PairVector &force) {
          PairVector scaled = force;
          scaled(2) /= mechanism.size();
          scaled(5) /= mechanism.size();
          return scaled.norm();
        };
        double sum = mechanism.weights().norm();
        for (const Spring &spring : mechanism.springs())
          sum += scaled_norm(
            spring
              .compute_force(spring.bodies.gather(q), spring.bodies.gather(v))
              .force);
        for (const RotationalSpring &spring : mechanism.rotational_springs())
          sum += scaled_norm(
            spring
              .compute_force(spring.bodies.gather(q), spring.bodies.gather(v))
              .force);
        for (const AppliedForce &force : mechanism.applied_forces())
          sum += std::abs(force.function.value(t)) * force.vector.norm();
        for (const AppliedTorque &torque : mechanism.applied_torques())
          sum += scaled_norm(torque.compute_force(t));
        return sum;
      }



      Balance
      StaticSolver::compute_balance(const Eigen::VectorXd &q) const
      {
        const unsigned int    n              = mechanism.n_coordinates();
        const unsigned int    m              = mechanism.n_constraints();
        const Eigen::VectorXd inverse_scales = scales.cwiseInverse();
        // Rows of Phi_q that are so to this depend on each other.
        constexpr double dependent = 1e-10;

        Balance balance;
        balance.forces      = applied_forces(q).cwiseProduct(inverse_scales);
        balance.force_scale = compute_force_scale(q);

        const Eigen::MatrixXd columns =
          compute_scaled_jacobian(equations, q).transpose();
        // Of forces: multipliers of angles are moments.
        Eigen::VectorXd multipliers;
        if (m == 0)
          {
            balance.free = Eigen::MatrixXd::Identity(n, n);
          }
        else
          {
            Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(columns);
            decomposition.setThreshold(dependent);
            const Eigen::MatrixXd basis = decomposition.householderQ();
            balance.free = basis.rightCols(n - decomposition.rank());
            if (mechanism.n_redundant() == 0)
              multipliers = decomposition.solve(balance.forces);
            else
              {
                // Of least norm, as they are not unique. Redundant rows depend
                // on each other but for the roundings of the position.
                Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> least;
                least.setThreshold(dependent);
                least.compute(columns);
                multipliers = least.solve(balance.forces);
              }
            balance.multipliers =
              multipliers.cwiseProduct(compute_constraint_scales(mechanism));
          }
        balance.free_forces = balance.free.transpose() * balance.forces;
        if (balance.free.cols() == 0)
          return balance;
        constexpr double epsilon = 10 * std::numeric_limits<double>::epsilon();
        balance.rounding =
          epsilon * (balance.force_scale + multipliers.lpNorm<1>());

        // Of the Jacobian of a motion, the block of forces by coordinates.
        Eigen::MatrixXd jacobian =
          Eigen::MatrixXd::Zero(2 * n + 2 * m, 2 * n + 2 * m);
        DenseEntries          entries(jacobian);
        const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(n);
        equations.subtract_force_derivatives(
          t, q, at_rest, approach_speeds, at_rest.head(0), n, 0, n, entries);
        equations.add_constraint_derivatives(q,
                                             at_rest,
                                             balance.multipliers,
                                             Eigen::VectorXd::Zero(m),
                                             {0, n, 2 * n, 2 * n + m},
                                             entries);
        const auto stiffness = jacobian.block(n, 0, n, n);
        balance.stiffness    = balance.free.transpose() *
                            inverse_scales.asDiagonal() * stiffness *
                            inverse_scales.asDiagonal() * balance.free;
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
          (balance.stiffness + balance.stiffness.transpose()) / 2);
        balance.least_stiffness   = eigen.eigenvalues()(0);
        balance.stiffness_scale   = eigen.eigenvalues().cwiseAbs().maxCoeff();
        balance.softest_direction = eigen.eigenvectors().col(0);
        balance.rounding += epsilon * balance.stiffness_scale *
                            q.cwiseProduct(scales).lpNorm<Eigen::Infinity>();
        return balance;
      }



      bool
      StaticSolver::try_step(const Balance         &balance,
                             const Eigen::VectorXd &step,
                             Eigen::VectorXd       &q) const
      {
        const Eigen::VectorXd wished =
          (balance.free * step).cwiseQuotient(scales);
        Eigen::VectorXd q_new = q + wished;
        if (!solve_positions(equations, t, none, q_new).converged)
          return false;
        const Eigen::VectorXd moved = (q_new - q).cwiseProduct(scales);
        // A large correction has jumped to another branch of positions.
        if ((moved - balance.free * step).norm() > step.norm())
          return false;
        // Work of the forces by the trapezoidal rule.
        const Eigen::VectorXd forces_new =
          applied_forces(q_new).cwiseQuotient(scales);
        const double work = moved.dot(balance.forces + forces_new) / 2;
        // At the end, forces are rounding and their work has no sign.
        if (work < -balance.rounding * moved.norm())
          return false;
        q = q_new;
        return true;
      }



      std::string
      StaticSolver::describe(const Balance &balance) const
      {
        const Eigen::VectorXd rest = balance.free * balance.free_forces;
        Eigen::Index          worst;
        rest.cwiseAbs().maxCoeff(&worst);
        const std::string body = mechanism.parameters().bodies[worst / 3].name;
        return worst % 3 == 2
                 ? "a torque of " +
                     significant_digits(std::abs(rest(worst)) *
                                        mechanism.size()) +
                     " N m is left on body '" + body + "'"
                 : "a force of " + significant_digits(std::abs(rest(worst))) +
                     " N is left on body '" + body + "'";
      }



      double
      StaticSolver::compute_shift(const Balance &balance,
                                  const double   sigma) const
      {
        if (balance.least_stiffness > 1e-10 * balance.stiffness_scale)
          return sigma;
        // More than what is negative; and where there is no stiffness, as much
        // as lets the force move the mechanism by the longest step.
        return sigma + balance.free_forces.norm() / longest_step() -
               2 * std::min(0., balance.least_stiffness);
      }



      Eigen::VectorXd
      StaticSolver::compute_step(const Balance &balance,
                                 const double   shift) const
      {
        const Eigen::Index    n = balance.free.cols();
        const Eigen::VectorXd step =
          (balance.stiffness + shift * Eigen::MatrixXd::Identity(n, n))
            .partialPivLu()
            .solve(balance.free_forces);
        return std::min(1., longest_step() / step.norm()) * step;
      }



      bool
      StaticSolver::has_converged(const Balance         &balance,
                                  const double           shift,
                                  const Eigen::VectorXd &step) const
      {
        if (balance.residual() < tolerance ||
            balance.free_forces.norm() < balance.rounding)
          return true;
        // Stiff contacts: rounding of the positions leaves forces.
        return shift == 0. && step.norm() < 1e-14 * mechanism.size() &&
               balance.residual() < 1e-6;
      }



      StaticEquilibrium
      StaticSolver::solve(const Eigen::VectorXd &q_guess)
      {
        constexpr unsigned int max_iterations = 1000;
        StaticEquilibrium      result;
        SolverReport          &report = result.report;
        result.q                      = q_guess;
        // What the pseudo-transient term adds to the stiffness [N/m].
        double  sigma   = 0.;
        Balance balance = compute_balance(result.q);
        for (; report.n_iterations < max_iterations && std::isfinite(sigma);
             ++report.n_iterations)
          {
            stop_if_interrupted();
            const double    shift = compute_shift(balance, sigma);
            Eigen::VectorXd step  = compute_step(balance, shift);
            if (has_converged(balance, shift, step))
              {
                if (balance.is_stable())
                  {
                    report.converged = true;
                    break;
                  }
                // Down from the ridge: either side will do.
                step = 1e-3 * mechanism.size() * balance.softest_direction;
              }
            if (step.allFinite() && try_step(balance, step, result.q))
              {
                balance = compute_balance(result.q);
                sigma = sigma < 1e-6 * balance.stiffness_scale ? 0. : sigma / 8;
              }
            else
              sigma = std::max({4 * sigma,
                                1e-3 * balance.stiffness_scale,
                                balance.free_forces.norm() / longest_step()});
          }
        report.residual    = balance.residual();
        result.multipliers = balance.multipliers;
        if (!report.converged)
          report.message =
            "no static equilibrium was found at time " +
            significant_digits(t, 6) + " s: after " +
            std::to_string(report.n_iterations) + " steps " +
            describe(balance) +
            ". Does something hold the mechanism, a spring, gravity or a "
            "contact, against the forces that turn or push it?";
        return result;
      }
    } // namespace



    StaticEquilibrium
    solve_static_equilibrium(const EquationsOfMotion &equations,
                             const double             t,
                             const Eigen::VectorXd   &q_guess)
    {
      return StaticSolver(equations, t).solve(q_guess);
    }
  } // namespace Multibody
} // namespace Tribody

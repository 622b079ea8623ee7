// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <tribody/base/exceptions.h>
#include <tribody/base/significant_digits.h>
#include <tribody/base/solver_report.h>
#include <tribody/multibody/assembly/assembly_checks.h>
#include <tribody/multibody/assembly/redundancy.h>
#include <tribody/multibody/system/constraint_gaps.h>
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
      // The body that is not where it was, but for whole turns; -1 if all are.
      int
      find_body_elsewhere(const Mechanism       &mechanism,
                          const Eigen::VectorXd &before,
                          const Eigen::VectorXd &now)
      {
        // Times are rounded, and drivers go on over many turns.
        constexpr double tolerance = 1e-6;
        for (Eigen::Index i = 0; i < now.size(); i += 3)
          {
            const double turned = std::remainder(now(i + 2) - before(i + 2),
                                                 2 * dealii::numbers::PI);
            const double moved =
              (now.segment<2>(i) - before.segment<2>(i)).norm();
            if (std::abs(turned) > tolerance ||
                moved > tolerance * mechanism.size())
              return i / 3;
          }
        return -1;
      }
    } // namespace



    void
    check_return(const EquationsOfMotion &equations,
                 const double             period,
                 const unsigned int       n_steps)
    {
      constexpr unsigned int  most_cycles = 24;
      const Mechanism        &mechanism   = equations.mechanism();
      const ConstraintOffsets none(mechanism.n_constraints());
      const Eigen::VectorXd   start = assemble_configuration(equations, 0.);
      Eigen::VectorXd         q     = start;
      int                     first_elsewhere = -1;
      unsigned int            cycle           = 0;
      bool                    is_back         = false;
      bool                    has_locked      = false;
      while (!is_back && !has_locked && cycle < most_cycles)
        {
          for (unsigned int k = 1; k <= n_steps && !has_locked; ++k)
            has_locked = !solve_positions(equations,
                                          (cycle + 1. * k / n_steps) * period,
                                          none,
                                          q)
                            .converged;
          ++cycle;
          const int body = find_body_elsewhere(mechanism, start, q);
          is_back        = body < 0 && !has_locked;
          if (cycle == 1)
            first_elsewhere = body;
        }
      if (is_back && cycle == 1)
        return;
      throw ExcParameter(
        "Drivers",
        "do not bring the mechanism back to where it began after a cycle of " +
          significant_digits(period, 6) + " s: body '" +
          mechanism.parameters().bodies[std::max(0, first_elsewhere)].name +
          "' is elsewhere" +
          (is_back
             ? ". All are back after " + significant_digits(cycle * period, 6) +
                 " s: write that in 'Dynamics/Cycle duration'"
             : (has_locked ? ", and the mechanism locks later on"
                           : ", and not all are back after " +
                               std::to_string(most_cycles) + " cycles either") +
                 std::string(". Set 'Dynamics/Cycle duration' to a "
                             "time after which all repeats")));
    }



    void
    check_full_cycle(const EquationsOfMotion &equations,
                     const double             period,
                     const unsigned int       n_steps)
    {
      const Mechanism        &mechanism = equations.mechanism();
      const ConstraintOffsets none(mechanism.n_constraints());
      const double            step = period / n_steps;
      Eigen::VectorXd         q    = assemble_configuration(equations, 0.);
      for (unsigned int k = 1; k <= n_steps; ++k)
        {
          const Eigen::VectorXd before = q;
          if (!solve_positions(equations, k * step, none, q).converged)
            {
              const OpenConstraint worst =
                find_open_constraint(equations, k * step, before);
              throw ExcParameter(
                "Drivers",
                "must be able to go through a full cycle with ideal joints, "
                "but the mechanism locks between " +
                  describe_drivers(mechanism, (k - 1) * step) + " and " +
                  describe_drivers(mechanism, k * step) + ", where " +
                  worst.description + " " + worst.problem +
                  ". Are the links' lengths right?");
            }
          const DependentConstraints dependent =
            find_dependent_constraints(equations, q);
          AssertThrow(
            dependent.n <= mechanism.n_redundant(),
            ExcParameter("Drivers",
                         "lead through a singular position, with " +
                           describe_drivers(mechanism, k * step) +
                           ": the constraints of " + dependent.names +
                           " depend on each other there, so that reactions "
                           "and the way on are not determined"));
        }
    }



    void
    check_redundancy(const EquationsOfMotion &equations,
                     const Eigen::VectorXd   &q)
    {
      const DependentConstraints dependent =
        find_dependent_constraints(equations, q);
      const Mechanism &mechanism = equations.mechanism();
      AssertThrow(
        dependent.n <= mechanism.n_redundant(),
        ExcParameter("Joints",
                     std::to_string(dependent.n - mechanism.n_redundant()) +
                       " constraint(s) follow from the others or contradict "
                       "them in the initial configuration. Those that depend "
                       "on each other belong to: " +
                       dependent.names +
                       ". Remove one of them; or if the mechanism is only just "
                       "passing a singular position, start from another one"));
    }



    void
    check_masses(const EquationsOfMotion &equations, const Eigen::VectorXd &q)
    {
      const Mechanism   &mechanism = equations.mechanism();
      const unsigned int n         = mechanism.n_coordinates();
      Eigen::VectorXd    masses    = mechanism.masses();
      if (masses.minCoeff() > 0)
        return;
      for (unsigned int i = 2; i < n; i += 3)
        masses(i) /= mechanism.size() * mechanism.size();

      // Directions that the constraints leave free.
      Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(
        compute_scaled_jacobian(equations, q).transpose());
      decomposition.setThreshold(1e-9);
      const Eigen::MatrixXd basis = decomposition.householderQ();
      const Eigen::MatrixXd free  = basis.rightCols(n - decomposition.rank());
      if (free.cols() == 0)
        return;
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
        free.transpose() * masses.asDiagonal() * free);
      // Rounding leaves 1e-16 of the largest mass.
      if (eigen.eigenvalues()(0) > 1e-13 * masses.maxCoeff())
        return;
      const Eigen::VectorXd motion = free * eigen.eigenvectors().col(0);
      Eigen::Index          worst;
      motion.cwiseAbs().maxCoeff(&worst);
      throw ExcParameter(
        "Body " + mechanism.parameters().bodies[worst / 3].name +
          (worst % 3 == 2 ? "/Moment of inertia" : "/Mass"),
        "is zero, and the joints do not tie this motion of the body to one "
        "with mass: its acceleration is not determined. Give the body a mass "
        "and a moment of inertia");
    }



    std::string
    explain_end_of_motion(const EquationsOfMotion &equations,
                          const double             t,
                          const double             t_next,
                          const Eigen::VectorXd   &q)
    {
      const Mechanism        &mechanism = equations.mechanism();
      const ConstraintOffsets none(mechanism.n_constraints());
      Eigen::VectorXd         q_next = q;
      if (!solve_positions(equations, t_next, none, q_next).converged)
        {
          const OpenConstraint worst =
            find_open_constraint(equations, t_next, q);
          return " shortly after the time " + significant_digits(t, 6) +
                 " s there is no position any more: " + worst.description +
                 " " + worst.problem;
        }
      // Looser than for redundancy: the motion ends near the singular position.
      const DependentConstraints dependent =
        find_dependent_constraints(equations, q_next, 1e-3);
      if (dependent.n > mechanism.n_redundant())
        return " near the time " + significant_digits(t, 6) +
               " s the mechanism is close to a singular position, in which the "
               "constraints of " +
               dependent.names + " depend on each other";
      return "";
    }
  } // namespace Multibody
} // namespace Tribody

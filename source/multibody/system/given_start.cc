// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <Eigen/QR>

#include <tribody/base/significant_digits.h>
#include <tribody/base/solver_report.h>
#include <tribody/multibody/system/constraint_gaps.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/given_start.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>
#include <tribody/multibody/system/sparse_jacobian.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      constexpr double turn = 2 * dealii::numbers::PI;



      bool
      is_angle(const Eigen::Index coordinate)
      {
        return coordinate % 3 == 2;
      }



      // The first angles, body by body, that the constraints and those before
      // leave free at q. Not positions: a body beside its guide is meant to be
      // at the nearest place on it, not at that with the same x.
      std::vector<Eigen::Index>
      find_free_coordinates(const EquationsOfMotion &equations,
                            const Eigen::VectorXd   &q)
      {
        // Less is left of a direction that is nearly tied to others.
        constexpr double          least     = 0.05;
        const Mechanism          &mechanism = equations.mechanism();
        const Eigen::Index        n         = q.size();
        std::vector<Eigen::Index> result;
        if (mechanism.n_degrees_of_freedom() <= 0)
          return result;
        Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(
          compute_scaled_jacobian(equations, q).transpose());
        decomposition.setThreshold(1e-9);
        const Eigen::MatrixXd basis = decomposition.householderQ();
        // Columns: what is left free, less with each coordinate that is found.
        Eigen::MatrixXd free = basis.rightCols(n - decomposition.rank());
        for (Eigen::Index i = 2; i < n; i += 3)
          {
            const Eigen::VectorXd direction = free.row(i);
            const double          left      = direction.norm();
            if (free.cols() == 0 || left < least)
              continue;
            result.push_back(i);
            // A reflection makes it the first column, which is dropped.
            Eigen::VectorXd normal = direction / left;
            normal(0) += normal(0) < 0. ? -1. : 1.;
            free -= (2. / normal.squaredNorm() * (free * normal)) *
                    normal.transpose();
            free = free.rightCols(free.cols() - 1).eval();
          }
        return result;
      }



      double
      difference(const Eigen::Index     i,
                 const Eigen::VectorXd &given,
                 const Eigen::VectorXd &q)
      {
        return is_angle(i) ? std::remainder(given(i) - q(i), turn)
                           : given(i) - q(i);
      }



      // In units of the mechanism's size, and radians.
      double
      find_largest_change(const Mechanism       &mechanism,
                          const Eigen::VectorXd &given,
                          const Eigen::VectorXd &q)
      {
        double largest = 0.;
        for (Eigen::Index i = 0; i < q.size(); ++i)
          largest = std::max(largest,
                             std::abs(difference(i, given, q)) /
                               (is_angle(i) ? 1. : mechanism.size()));
        return largest;
      }



      std::string
      describe_change(const Mechanism   &mechanism,
                      const Eigen::Index i,
                      const double       change)
      {
        const std::string body = mechanism.parameters().bodies[i / 3].name;
        return is_angle(i) ? "body '" + body + "' is turned by " +
                               significant_digits(360. / turn * change, 3) +
                               " deg from its initial angle"
                           : "body '" + body + "' is " +
                               significant_digits(1e3 * change, 3) +
                               " mm from its initial position in " +
                               (i % 3 == 0 ? "x" : "y");
      }
    } // namespace



    void
    turn_to_drivers(const Mechanism &mechanism,
                    const double     t,
                    Eigen::VectorXd &q)
    {
      // A reference body may be turned by its own driver, that by another one.
      for (std::size_t round = 0; round < mechanism.drivers().size(); ++round)
        for (std::size_t d = 0; d < mechanism.drivers().size(); ++d)
          {
            if (!mechanism.parameters().drivers[d].is_angle())
              continue;
            const DriverEntry &driver = mechanism.drivers()[d];
            const Constraint  &constraint =
              *mechanism.constraints()[driver.constraint].constraint;
            const double rest =
              constraint.value(t, constraint.bodies.gather(q))(0);
            const int  body      = constraint.bodies.body(0);
            const int  reference = constraint.bodies.body(1);
            const auto turns     = turn * std::round(rest / turn);
            if (body != ground_body)
              q(3 * body + 2) -= turns;
            else
              q(3 * reference + 2) += turns;
          }
    }



    Eigen::VectorXd
    hold_given_coordinates(const EquationsOfMotion &equations,
                           const double             t,
                           const Eigen::VectorXd   &given,
                           const Eigen::VectorXd   &q)
    {
      const Mechanism        &mechanism = equations.mechanism();
      const ConstraintOffsets none(mechanism.n_constraints());
      // The search for free coordinates takes the third power of their number:
      // many bodies stay where the way to them was shortest.
      if (find_largest_change(mechanism, given, q) < 1e-12 ||
          mechanism.n_constraints() > largest_dense_jacobian)
        return q;
      const auto      free     = find_free_coordinates(equations, q);
      Eigen::VectorXd moved    = q;
      Eigen::VectorXd mobility = Eigen::VectorXd::Ones(q.size());
      for (const Eigen::Index i : free)
        mobility(i) = 1e-6;
      constexpr unsigned int n_steps = 8;
      for (unsigned int k = 0; k < n_steps; ++k)
        {
          for (const Eigen::Index i : free)
            moved(i) += difference(i, given, moved) / (n_steps - k);
          if (!solve_positions(equations, t, none, moved, mobility).converged)
            return q;
        }
      return moved;
    }



    std::string
    explain_changed_start(const EquationsOfMotion &equations,
                          const Eigen::VectorXd   &q)
    {
      const Mechanism       &mechanism = equations.mechanism();
      const Eigen::VectorXd &given     = mechanism.initial_coordinates();
      // In units of the size, and radians.
      constexpr double noticed = 1e-4;
      if (find_largest_change(mechanism, given, q) < noticed)
        return "";
      for (const Eigen::Index i : find_free_coordinates(equations, q))
        {
          const double change = -difference(i, given, q);
          if (std::abs(change) / (is_angle(i) ? 1. : mechanism.size()) >
              noticed)
            return describe_change(mechanism, i, change) +
                   ", where the joints cannot be closed";
        }
      std::vector<bool> is_driven(mechanism.parameters().bodies.size());
      for (const DriverEntry &driver : mechanism.drivers())
        for (const int k : {0, 1})
          {
            const int body = mechanism.constraints()[driver.constraint]
                               .constraint->bodies.body(k);
            if (body != ground_body)
              is_driven[body] = true;
          }
      for (Eigen::Index i = 2; i < q.size(); i += 3)
        {
          const double change = -difference(i, given, q);
          if (!is_driven[i / 3] && std::abs(change) > turn / 4)
            return describe_change(mechanism, i, change) +
                   "; if another way to assemble the mechanism is meant, start "
                   "nearer to it";
        }
      return "";
    }
  } // namespace Multibody
} // namespace Tribody

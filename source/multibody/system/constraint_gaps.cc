// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <Eigen/Cholesky>

#include <tribody/base/significant_digits.h>
#include <tribody/multibody/system/constraint_gaps.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/mechanism.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      std::string
      degrees(const double angle)
      {
        return significant_digits(angle * 180 / dealii::numbers::PI) + " deg";
      }



      std::string
      millimetres(const double length)
      {
        return significant_digits(1e3 * length) + " mm";
      }



      // How far the equations of a constraint are from zero, for messages: of
      // a translational joint, what is worse of its gap and its angle.
      std::string
      describe_gap(const Constraint      &constraint,
                   const Eigen::VectorXd &phi,
                   const double           size)
      {
        double length = 0., angle = 0.;
        for (unsigned int i = 0; i < constraint.n_equations; ++i)
          if (constraint.is_angle(i))
            angle = std::abs(phi(i));
          else
            length = std::hypot(length, phi(i));
        return angle * size > length ? "an angle of " + degrees(angle)
                                     : "a gap of " + millimetres(length);
      }
    } // namespace



    std::string
    describe_drivers(const Mechanism &mechanism, const double t)
    {
      std::string result;
      for (unsigned int i = 0; i < mechanism.drivers().size(); ++i)
        {
          const DriverParameters &driver = mechanism.parameters().drivers[i];
          const double position = mechanism.drivers()[i].motion.value(t);
          result +=
            (result.empty() ? "" : ", ") + driver.name + " at " +
            (driver.is_angle() ? degrees(position) : millimetres(position));
        }
      return result;
    }



    Eigen::VectorXd
    compute_constraint_scales(const Mechanism &mechanism)
    {
      Eigen::VectorXd scales = Eigen::VectorXd::Ones(mechanism.n_constraints());
      for (const auto &[constraint, row] : mechanism.constraints())
        for (unsigned int i = 0; i < constraint->n_equations; ++i)
          if (constraint->is_angle(i))
            scales(row + i) = mechanism.size();
      return scales;
    }



    Eigen::MatrixXd
    compute_scaled_jacobian(const EquationsOfMotion &equations,
                            const Eigen::VectorXd   &q)
    {
      const Mechanism &mechanism = equations.mechanism();
      Eigen::MatrixXd  jacobian(mechanism.n_constraints(),
                               mechanism.n_coordinates());
      equations.assemble_constraint_jacobian(q, jacobian);
      for (unsigned int i = 2; i < mechanism.n_coordinates(); i += 3)
        jacobian.col(i) /= mechanism.size();
      return compute_constraint_scales(mechanism).asDiagonal() * jacobian;
    }



    Eigen::VectorXd
    find_smallest_gaps(const EquationsOfMotion &equations,
                       const double             t,
                       const Eigen::VectorXd   &q_guess,
                       const Constraint        *open)
    {
      const Mechanism   &mechanism = equations.mechanism();
      const unsigned int n         = mechanism.n_coordinates();
      const double       size      = mechanism.size();
      Eigen::VectorXd    weights(mechanism.n_constraints());
      constexpr double   heavy = 1e3;
      for (unsigned int c = 0; c < mechanism.constraints().size(); ++c)
        {
          const auto &[constraint, row] = mechanism.constraints()[c];
          const bool is_light = open == nullptr ? !mechanism.is_driver(c)
                                                : constraint.get() == open;
          weights.segment(row, constraint->n_equations)
            .setConstant(is_light ? 1. : heavy);
        }
      const Eigen::VectorXd scales = compute_constraint_scales(mechanism);
      const auto            gaps   = [&](const Eigen::VectorXd &q) {
        Eigen::VectorXd phi(weights.size());
        equations.assemble_constraints(t, q, phi);
        return Eigen::VectorXd(weights.cwiseProduct(scales).cwiseProduct(phi));
      };

      Eigen::VectorXd q = q_guess, r = gaps(q);
      double          damping = 1e-3;
      for (unsigned int k = 0; k < 500 && damping < 1e12; ++k)
        {
          const Eigen::MatrixXd jacobian =
            weights.asDiagonal() * compute_scaled_jacobian(equations, q);
          const Eigen::MatrixXd matrix =
            jacobian.transpose() * jacobian +
            damping * Eigen::MatrixXd::Identity(n, n);
          Eigen::VectorXd step = -matrix.ldlt().solve(jacobian.transpose() * r);
          const double    length = step.norm();
          if (length < 1e-9 * size)
            break;
          step *= std::min(1., size / length);
          for (unsigned int i = 2; i < n; i += 3)
            step(i) /= size;
          const Eigen::VectorXd r_new = gaps(q + step);
          if (r_new.norm() < r.norm())
            {
              q += step;
              r = r_new;
              damping /= 4;
            }
          else
            damping *= 8;
        }
      return q;
    }



    OpenConstraint
    find_open_constraint(const EquationsOfMotion &equations,
                         const double             t,
                         const Eigen::VectorXd   &q_guess)
    {
      const Mechanism                       &mechanism = equations.mechanism();
      const std::vector<NumberedConstraint> &all = mechanism.constraints();
      Eigen::VectorXd                        phi(mechanism.n_constraints());
      const auto gap_of = [&](const NumberedConstraint &c) {
        return phi.segment(c.first_row, c.constraint->n_equations).norm();
      };

      const Eigen::VectorXd shared = find_smallest_gaps(equations, t, q_guess);
      equations.assemble_constraints(t, shared, phi);
      unsigned int worst = 0;
      for (unsigned int c = 1; c < all.size(); ++c)
        if (gap_of(all[c]) > 1.01 * gap_of(all[worst]))
          worst = c;
      const double              worst_gap  = gap_of(all[worst]);
      std::vector<unsigned int> candidates = {worst};
      for (unsigned int c = all.size(); c > 0; --c)
        candidates.push_back(c - 1);
      const Eigen::VectorXd shared_phi = phi;
      for (const unsigned int c : candidates)
        {
          equations.assemble_constraints(
            t,
            find_smallest_gaps(equations, t, shared, all[c].constraint.get()),
            phi);
          double others = 0.;
          for (unsigned int d = 0; d < all.size(); ++d)
            if (d != c)
              others = std::max(others, gap_of(all[d]));
          if (others < 1e-3 * worst_gap)
            {
              worst = c;
              break;
            }
          if (c == 0)
            phi = shared_phi;
        }
      const Constraint &constraint = *all[worst].constraint;
      return {constraint.description,
              (mechanism.is_driver(worst) ? "cannot be obeyed: "
                                          : "cannot be closed: ") +
                describe_gap(constraint,
                             phi.segment(all[worst].first_row,
                                         constraint.n_equations),
                             mechanism.size()) +
                " remains"};
    }
  } // namespace Multibody
} // namespace Tribody

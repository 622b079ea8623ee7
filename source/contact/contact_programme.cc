// SPDX-License-Identifier: LGPL-2.1-or-later

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <tribody/contact/contact_programme.h>
#include <tribody/contact/rigid_places.h>

#include <algorithm>
#include <limits>

namespace Tribody
{
  namespace Contact
  {
    namespace
    {
      /// Two neighbours of the @p n nodes from @p begin on that carry the whole
      /// force: the first point that satisfies the constraint.
      void
      carry_by_two_nodes(const ContactProgramme   &programme,
                         const Eigen::Index        begin,
                         const Eigen::Index        n,
                         ContactProgrammeSolution &solution)
      {
        const auto &m = programme.directions;
        // All zero forces are carried by no node.
        if (programme.force.norm() == 0.)
          return;
        for (Eigen::Index i = begin; i < begin + n; ++i)
          {
            const Eigen::Index j = begin + (i + 1 - begin) % n;
            Eigen::Matrix2d    pair;
            pair << m.col(i), m.col(j);
            const Eigen::Vector2d share = pair.inverse() * programme.force;
            // A force through a node leaves a rounding of either sign to its
            // neighbours.
            if (m.col(i).dot(programme.force) > 0. &&
                share.minCoeff() >= -1e-12 * programme.force.norm())
              {
                solution.nodal_force[i] = std::max(0., share[0]);
                solution.nodal_force[j] = std::max(0., share[1]);
                solution.active_set.push_back(std::min(i, j));
                solution.active_set.push_back(std::max(i, j));
                return;
              }
          }
      }

      /// The minimum with the forces of all other nodes zero, signs ignored.
      template <int n_free>
      Eigen::VectorXd
      minimise_over(const ActiveSet                      &active,
                    const ContactProgramme               &programme,
                    typename RigidPlaces<n_free>::Vector &step)
      {
        step.setZero();
        if (active.empty())
          return Eigen::VectorXd();
        const Eigen::LLT<Eigen::MatrixXd> factor(
          programme.compliance(active, active));
        const Eigen::VectorXd gap = programme.gap(active);
        if (!programme.pin_is_free)
          return -factor.solve(gap);

        using Places  = RigidPlaces<n_free>;
        using Columns = Eigen::Matrix<double, Eigen::Dynamic, n_free>;
        const Eigen::Index n_bore = programme.gap.size() - programme.n_rim;
        const auto         force  = Places::repeat(programme.force);
        Columns            m      = Columns::Zero(active.size(), n_free);
        for (std::size_t k = 0; k < active.size(); ++k)
          m.template block<1, 2>(k, Places::first_column(active[k], n_bore)) =
            programme.directions.col(active[k]).transpose();
        const Columns                 y = factor.solve(m);
        const Eigen::VectorXd         z = factor.solve(gap);
        const typename Places::Square compliance =
          Places::invert_stiffness(m.transpose() * y, active, n_bore);
        step = compliance * (force + m.transpose() * z);
        // The difference of two large terms balances the force to their
        // rounding only.
        Eigen::VectorXd forces = y * step - z;
        forces += y * (compliance * (force - m.transpose() * forces));
        return forces;
      }

      Eigen::VectorXd
      minimise_over(const ContactProgramme   &programme,
                    ContactProgrammeSolution &solution)
      {
        if (programme.n_rim == 0)
          return minimise_over<2>(solution.active_set,
                                  programme,
                                  solution.pin_step);
        Eigen::Vector4d       step;
        const Eigen::VectorXd forces =
          minimise_over<4>(solution.active_set, programme, step);
        solution.pin_step  = step.head<2>();
        solution.ring_step = step.tail<2>();
        return forces;
      }

      /// The node that the optimality conditions want in contact, or -1.
      Eigen::Index
      find_entering(const ContactProgramme         &programme,
                    const ContactProgrammeSolution &solution,
                    const bool                      smallest_index)
      {
        Eigen::VectorXd gap       = programme.compliance * solution.nodal_force;
        const double    tolerance = std::max(programme.gap_tolerance,
                                          programme.relative_tolerance *
                                            gap.lpNorm<Eigen::Infinity>());
        gap +=
          programme.gap - programme.directions.transpose() * solution.pin_step;
        if (programme.n_rim > 0)
          gap.tail(programme.n_rim) +=
            programme.directions.rightCols(programme.n_rim).transpose() *
            (solution.pin_step - solution.ring_step);
        Eigen::Index entering = -1;
        double       deepest  = -tolerance;
        for (Eigen::Index i = 0; i < gap.size(); ++i)
          if (gap[i] < deepest &&
              !std::binary_search(solution.active_set.begin(),
                                  solution.active_set.end(),
                                  i))
            {
              entering = i;
              deepest  = gap[i];
              if (smallest_index)
                break;
            }
        return entering;
      }

      /// Go towards @p target as far as no force turns into tension; the node
      /// that stops the way leaves the active set. Returns the length of the
      /// way in [0, 1].
      double
      advance(const Eigen::VectorXd &target, ContactProgrammeSolution &solution)
      {
        auto       &active   = solution.active_set;
        double      length   = 1.;
        std::size_t blocking = active.size();
        if (active.empty())
          return length;
        // A node that the balance of forces leaves with nothing but rounding
        // does not pull; released, it would come back for ever.
        const double nothing = -1e-13 * target.lpNorm<Eigen::Infinity>();
        for (std::size_t k = 0; k < active.size(); ++k)
          if (target[k] < nothing)
            {
              const double old  = solution.nodal_force[active[k]];
              const double stop = old / (old - target[k]);
              if (stop < length)
                {
                  length   = stop;
                  blocking = k;
                }
            }
        for (std::size_t k = 0; k < active.size(); ++k)
          {
            double &force = solution.nodal_force[active[k]];
            force         = std::max(0., force + length * (target[k] - force));
          }
        if (blocking < active.size())
          {
            solution.nodal_force[active[blocking]] = 0.;
            active.erase(active.begin() + blocking);
          }
        return length;
      }
    } // namespace



    ContactProgrammeSolution
    solve_contact_programme(const ContactProgramme &programme)
    {
      const Eigen::Index       n = programme.gap.size();
      ContactProgrammeSolution solution;
      solution.nodal_force = Eigen::VectorXd::Zero(n);
      if (programme.pin_is_free)
        {
          carry_by_two_nodes(programme, 0, n - programme.n_rim, solution);
          if (programme.n_rim > 0)
            carry_by_two_nodes(programme,
                               n - programme.n_rim,
                               programme.n_rim,
                               solution);
        }

      bool       was_blocked_at_once = false;
      const auto max_iterations      = static_cast<unsigned int>(20 * n);
      for (auto &i = solution.report.n_iterations; i < max_iterations;)
        {
          ++i;
          const Eigen::VectorXd target = minimise_over(programme, solution);
          const double          length = advance(target, solution);
          if (length < 1.)
            {
              was_blocked_at_once = was_blocked_at_once || (length == 0.);
              continue;
            }
          const Eigen::Index entering =
            find_entering(programme, solution, was_blocked_at_once);
          if (entering < 0)
            {
              solution.report.converged = true;
              return solution;
            }
          auto &active = solution.active_set;
          active.insert(
            std::upper_bound(active.begin(), active.end(), entering), entering);
        }
      solution.report.message = "the quadratic programme needs more than " +
                                std::to_string(max_iterations) + " steps";
      return solution;
    }
  } // namespace Contact
} // namespace Tribody

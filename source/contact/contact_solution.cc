// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <Eigen/QR>

#include <tribody/base/ranks.h>
#include <tribody/contact/contact_solution.h>
#include <tribody/surface/bore_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace Tribody
{
  namespace Contact
  {
    namespace
    {
      /// What changes by more than this part of its nodes jumps.
      constexpr double largest_change = 0.2;

      /// From @p direction counter-clockwise to @p other, in [0, 2 pi).
      double
      turn(const Eigen::Vector2d &direction, const Eigen::Vector2d &other)
      {
        const double sine   = direction[0] * other[1] - direction[1] * other[0];
        const double cosine = direction.dot(other);
        const double angle  = std::atan2(sine, cosine);
        return angle < 0. ? angle + 2. * dealii::numbers::PI : angle;
      }

      /// Where @f$c_0 + c_1 x + c_2 x^2@f$ rises through zero, or NaN.
      double
      rising_root(const Eigen::Vector3d &c)
      {
        const double discriminant = c[1] * c[1] - 4. * c[0] * c[2];
        const double denominator  = c[1] + std::sqrt(discriminant);
        return denominator > 0. ? -2. * c[0] / denominator
                                : std::numeric_limits<double>::quiet_NaN();
      }

      /**
       * How far the end of contact lies beyond the last node in contact, seen
       * from the pin's centre [rad].
       *
       * @param last node in contact.
       * @param outward +1 if the contact ends counter-clockwise, else -1.
       */
      double
      overhang(const ContactSolution &solution,
               const BoreSurface     &surface,
               const Eigen::Index     last,
               const int              outward)
      {
        const Eigen::Index    n = surface.n_nodes();
        const Eigen::Vector2d end =
          surface.positions.col(last) - solution.pin_centre;
        const auto node = [&](const Eigen::Index steps) {
          return ((last + outward * steps) % n + n) % n;
        };
        const auto angle_to = [&](const Eigen::Index steps) {
          const Eigen::Vector2d x =
            surface.positions.col(node(steps)) - solution.pin_centre;
          return outward > 0 ? turn(end, x) : turn(x, end);
        };

        const double spacing = angle_to(1);
        if (solution.active_set.size() < 6 || n < 12)
          return 0.5 * spacing;
        // The first node sees the single nodes that carry the contact, not its
        // end; with eight more, what is left of that averages out.
        constexpr Eigen::Index      first = 2, n_fitted = 8;
        Eigen::Matrix<double, 8, 3> powers;
        Eigen::Matrix<double, 8, 1> heights;
        for (Eigen::Index k = 0; k < n_fitted; ++k)
          {
            const double x   = angle_to(first + k) / spacing;
            const double gap = solution.gap[node(first + k)];
            if (!(gap > 0.))
              return 0.5 * spacing;
            powers.row(k) << 1., x, x * x;
            heights[k] = std::cbrt(gap * gap);
          }
        const double x =
          rising_root(powers.colPivHouseholderQr().solve(heights));
        return spacing * (std::isnan(x) ? 0.5 : std::clamp(x, -0.5, 1.5));
      }

      ActiveSet
      symmetric_difference(const ActiveSet &a, const ActiveSet &b)
      {
        ActiveSet nodes;
        std::set_symmetric_difference(
          a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(nodes));
        return nodes;
      }

      /// Of a ContactSolution or its RimContact. Returns whether anything has
      /// changed.
      template <typename Surface>
      bool
      take_next(Surface &surface, const bool one_by_one)
      {
        const ActiveSet wrong =
          symmetric_difference(surface.active_set, surface.next_active_set);
        if (wrong.empty())
          return false;
        ActiveSet next = surface.next_active_set;
        if (one_by_one)
          next = symmetric_difference(surface.active_set, {wrong.back()});
        const Eigen::VectorXd forces = surface.nodal_force;
        surface.nodal_force.setZero();
        surface.nodal_force(next) = forces(next);
        surface.active_set        = std::move(next);
        return true;
      }

      /// 1 for the @p nodes out of @p n, else 0.
      Eigen::VectorXd
      to_flags(const ActiveSet &nodes, const Eigen::Index n)
      {
        Eigen::VectorXd flags = Eigen::VectorXd::Zero(n);
        flags(nodes).setOnes();
        return flags;
      }

      ActiveSet
      to_nodes(const Eigen::Ref<const Eigen::VectorXd> &flags)
      {
        ActiveSet nodes;
        for (Eigen::Index i = 0; i < flags.size(); ++i)
          if (flags[i] > 0.)
            nodes.push_back(i);
        return nodes;
      }

      void
      broadcast_rim(RimContact        &rim,
                    const unsigned int root,
                    const MPI_Comm    &communicator)
      {
        const Eigen::Index n =
          dealii::Utilities::MPI::broadcast(communicator,
                                            rim.nodal_force.size(),
                                            root);
        if (n == 0)
          {
            rim = RimContact();
            return;
          }
        if (rim.nodal_force.size() != n)
          {
            rim             = RimContact();
            rim.nodal_force = rim.pressure = rim.gap = Eigen::VectorXd::Zero(n);
          }
        Eigen::VectorXd values(5 * n + 4);
        values << rim.nodal_force, rim.pressure, rim.gap,
          to_flags(rim.active_set, n), to_flags(rim.next_active_set, n),
          rim.ring_place, rim.force;
        Ranks::broadcast(values, root, communicator);
        rim.nodal_force     = values.segment(0, n);
        rim.pressure        = values.segment(n, n);
        rim.gap             = values.segment(2 * n, n);
        rim.active_set      = to_nodes(values.segment(3 * n, n));
        rim.next_active_set = to_nodes(values.segment(4 * n, n));
        rim.ring_place      = values.segment<2>(5 * n);
        rim.force           = values.segment<2>(5 * n + 2);
      }



      /// What the surface of @p next, which is the bore's ContactSolution or
      /// the RimContact, takes from those of the two solutions before.
      /// @return whether it differs little from @p last.
      template <typename Surface>
      bool
      extrapolate_forces(const Surface &before,
                         const Surface &last,
                         Surface       &next)
      {
        const Eigen::Index n = last.nodal_force.size();
        AssertDimension(before.gap.size(), n);
        AssertDimension(last.gap.size(), n);
        next.nodal_force.setZero(n);
        if (before.active_set.empty() || last.active_set.empty())
          return before.active_set.empty() && last.active_set.empty();

        const double growth = last.nodal_force.sum() / before.nodal_force.sum();
        // Of what is left of a gap if its power 2/3 halves.
        const double half      = std::pow(0.5, 1.5);
        std::size_t  n_changes = 0;
        for (Eigen::Index i = 0; i < n; ++i)
          {
            const double force  = last.nodal_force[i];
            const double grown  = growth * before.nodal_force[i];
            const double square = 2. * force * force - grown * grown;
            const bool   enters =
              force == 0. && grown == 0. && last.gap[i] < half * before.gap[i];
            if (square > 0.)
              next.nodal_force[i] = std::sqrt(square);
            if (square > 0. || enters)
              next.active_set.push_back(i);
            if ((square > 0. || enters) != (force > 0.))
              ++n_changes;
          }
        return n_changes <= largest_change * last.active_set.size();
      }
    } // namespace



    std::size_t
    n_differing_nodes(const ContactSolution &solution)
    {
      return symmetric_difference(solution.active_set, solution.next_active_set)
               .size() +
             symmetric_difference(solution.rim.active_set,
                                  solution.rim.next_active_set)
               .size();
    }



    void
    take_next_active_set(ContactSolution &solution, const bool one_by_one)
    {
      if (!take_next(solution.rim, one_by_one) || !one_by_one)
        take_next(solution, one_by_one);
    }



    ContactSolution
    extrapolate(const ContactSolution &before, const ContactSolution &last)
    {
      ContactSolution next;
      next.pin_centre     = 2. * last.pin_centre - before.pin_centre;
      next.rim.ring_place = 2. * last.rim.ring_place - before.rim.ring_place;
      if (!extrapolate_forces(before, last, next) ||
          !extrapolate_forces(before.rim, last.rim, next.rim))
        return last;
      return next;
    }



    void
    broadcast(ContactSolution   &solution,
              const unsigned int root,
              const MPI_Comm    &communicator)
    {
      if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1)
        return;
      const Eigen::Index n =
        dealii::Utilities::MPI::broadcast(communicator,
                                          solution.nodal_force.size(),
                                          root);
      if (solution.nodal_force.size() != n)
        {
          solution             = ContactSolution();
          solution.nodal_force = solution.pressure = solution.gap =
            Eigen::VectorXd::Zero(n);
        }
      Eigen::VectorXd values(5 * n + 9);
      values << solution.nodal_force, solution.pressure, solution.gap,
        to_flags(solution.active_set, n), solution.pin_centre, solution.force,
        solution.half_angle, solution.report.converged,
        solution.report.n_iterations, solution.report.residual,
        solution.report.stagnated, to_flags(solution.next_active_set, n);
      Ranks::broadcast(values, root, communicator);

      solution.nodal_force         = values.segment(0, n);
      solution.pressure            = values.segment(n, n);
      solution.gap                 = values.segment(2 * n, n);
      solution.pin_centre          = values.segment<2>(4 * n);
      solution.force               = values.segment<2>(4 * n + 2);
      solution.half_angle          = values[4 * n + 4];
      solution.report.converged    = values[4 * n + 5] > 0.;
      solution.report.n_iterations = std::lround(values[4 * n + 6]);
      solution.report.residual     = values[4 * n + 7];
      solution.report.stagnated    = values[4 * n + 8] > 0.;
      solution.active_set          = to_nodes(values.segment(3 * n, n));
      solution.next_active_set     = to_nodes(values.segment(4 * n + 9, n));
      broadcast_rim(solution.rim, root, communicator);
    }



    double
    contact_half_angle(const ContactSolution &solution,
                       const BoreSurface     &surface)
    {
      const auto       &active = solution.active_set;
      const std::size_t m      = active.size();
      if (m == 0)
        return 0.;
      if (m == static_cast<std::size_t>(surface.n_nodes()))
        return dealii::numbers::PI;

      // The contact lies between the two ends of the widest opening.
      std::size_t before_opening = 0;
      double      widest         = -1.;
      for (std::size_t k = 0; k < m; ++k)
        {
          // Neighbours in contact leave no opening.
          if (m > 1 && active[(k + 1) % m] == active[k] + 1 && widest >= 0.)
            continue;
          const Eigen::Vector2d from =
            surface.positions.col(active[k]) - solution.pin_centre;
          const Eigen::Vector2d to =
            surface.positions.col(active[(k + 1) % m]) - solution.pin_centre;
          const double opening =
            (m == 1) ? 2. * dealii::numbers::PI : turn(from, to);
          if (opening > widest)
            {
              widest         = opening;
              before_opening = k;
            }
        }
      const Eigen::Index last  = active[before_opening];
      const Eigen::Index first = active[(before_opening + 1) % m];
      return 0.5 * (2. * dealii::numbers::PI - widest +
                    overhang(solution, surface, last, +1) +
                    overhang(solution, surface, first, -1));
    }



    double
    peak_pressure(const ContactSolution &solution, const BoreSurface &surface)
    {
      // Exact for cubics, zero for what alternates from node to node.
      const Eigen::Index           n       = surface.n_nodes();
      constexpr std::array<int, 5> weights = {{-1, 4, 10, 4, -1}};
      double                       peak    = 0.;
      for (const Eigen::Index i : solution.active_set)
        {
          std::array<double, 5> p;
          double                fitted     = 0.;
          bool                  surrounded = true;
          for (int k = 0; k < 5; ++k)
            {
              p[k] = solution.pressure[(i + k - 2 + n) % n];
              fitted += weights[k] / 16. * p[k];
              surrounded = surrounded && p[k] > 0.;
            }
          if (!surrounded)
            continue;
          // The top of the parabola, if it lies nearer to this node than to
          // another one; differences over an even number of nodes do not see
          // what alternates.
          const double slope     = 0.5 * (p[3] - p[1]);
          const double curvature = 0.25 * (p[4] - 2. * p[2] + p[0]);
          if (curvature < 0. && std::abs(slope) <= -0.5 * curvature)
            fitted -= 0.5 * slope * slope / curvature;
          peak = std::max(peak, fitted);
        }
      return peak > 0. ? peak : solution.pressure.maxCoeff();
    }
  } // namespace Contact
} // namespace Tribody

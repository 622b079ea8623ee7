#include <deal.II/base/mpi.h>

#include <Eigen/QR>

#include <tribody/base/ranks.h>
#include <tribody/contact/contact_solution.h>
#include <tribody/surface/bore_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace Tribody
{
  namespace Contact
  {
    namespace
    {
      /// From @p direction counter-clockwise to @p other, in [0, 2 pi).
      double
      turn(const Eigen::Vector2d &direction, const Eigen::Vector2d &other)
      {
        const double sine   = direction[0] * other[1] - direction[1] * other[0];
        const double cosine = direction.dot(other);
        const double angle  = std::atan2(sine, cosine);
        return angle < 0. ? angle + 2. * M_PI : angle;
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
    } // namespace



    ActiveSet
    differing_nodes(const ContactSolution &solution)
    {
      ActiveSet nodes;
      std::set_symmetric_difference(solution.active_set.begin(),
                                    solution.active_set.end(),
                                    solution.next_active_set.begin(),
                                    solution.next_active_set.end(),
                                    std::back_inserter(nodes));
      return nodes;
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
      Eigen::VectorXd is_active = Eigen::VectorXd::Zero(n);
      Eigen::VectorXd is_next   = Eigen::VectorXd::Zero(n);
      is_active(solution.active_set).setOnes();
      is_next(solution.next_active_set).setOnes();
      Eigen::VectorXd values(5 * n + 8);
      values << solution.nodal_force, solution.pressure, solution.gap,
        is_active, solution.pin_centre, solution.force, solution.half_angle,
        solution.report.converged, solution.report.n_iterations,
        solution.report.residual, is_next;
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
      solution.active_set.clear();
      solution.next_active_set.clear();
      for (Eigen::Index i = 0; i < n; ++i)
        {
          if (values[3 * n + i] > 0.)
            solution.active_set.push_back(i);
          if (values[4 * n + 8 + i] > 0.)
            solution.next_active_set.push_back(i);
        }
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
        return M_PI;

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
          const double opening = (m == 1) ? 2. * M_PI : turn(from, to);
          if (opening > widest)
            {
              widest         = opening;
              before_opening = k;
            }
        }
      const Eigen::Index last  = active[before_opening];
      const Eigen::Index first = active[(before_opening + 1) % m];
      return 0.5 * (2. * M_PI - widest + overhang(solution, surface, last, +1) +
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

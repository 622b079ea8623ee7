// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>

#include <Eigen/LU>

#include <tribody/algebra/dense_products.h>
#include <tribody/contact/contact_programme.h>
#include <tribody/contact/contact_solver.h>
#include <tribody/contact/pin_gap.h>

#include <algorithm>
#include <iomanip>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace Tribody
{
  namespace Contact
  {
    namespace
    {
      SolverReport
      failure(SolverReport report, const std::string &message)
      {
        report.converged = false;
        report.message   = message;
        return report;
      }

      std::string
      describe_stagnation(const double residual)
      {
        std::ostringstream message;
        message << "gaps or imbalance of the forces stay at " << std::scientific
                << std::setprecision(1) << residual << ", relative";
        return message.str();
      }

      /// Nodes that follow each other.
      struct Arc
      {
        Eigen::Index begin;
        Eigen::Index length;
      };

      /// Add a node behind those that were added before.
      void
      append(const Eigen::Index i, std::vector<Arc> &arcs)
      {
        if (arcs.empty() || arcs.back().begin + arcs.back().length != i)
          arcs.push_back({i, 0});
        ++arcs.back().length;
      }

      /// Those below @p n_bore, and the others less @p n_bore.
      std::pair<ActiveSet, ActiveSet>
      split(const ActiveSet &nodes, const Eigen::Index n_bore)
      {
        const auto rim = std::lower_bound(nodes.begin(), nodes.end(), n_bore);
        std::pair<ActiveSet, ActiveSet> parts{{nodes.begin(), rim},
                                              {rim, nodes.end()}};
        for (Eigen::Index &k : parts.second)
          k -= n_bore;
        return parts;
      }
    } // namespace



    ContactSolver::ContactSolver(const BoreSurface             &surface,
                                 const Compliance              &compliance,
                                 const double                   pin_radius,
                                 const ContactSolverParameters &parameters,
                                 const std::optional<Housing>  &housing)
      : surface(surface)
      , housing(housing)
      , compliance(compliance)
      , pin_radius(pin_radius)
      , parameters(parameters)
      , active_compliance(compliance)
    {
      AssertDimension(compliance.matrix().cols(), n_nodes());
    }



    ContactSolution
    ContactSolver::solve_force_controlled(
      const Eigen::Vector2d &force_per_length,
      const ContactSolution *warm_start)
    {
      const double force = force_per_length.norm();
      if (force == 0.)
        {
          Iterate untouched;
          untouched.nodal_force = Eigen::VectorXd::Zero(n_nodes());
          evaluate_gap(untouched, Rows::all);
          if (untouched.gap.minCoeff() >= -untouched.gap_tolerance)
            return make_solution(untouched, {true, 0, 0., ""});
        }

      Iterate      iterate = first_iterate(force_per_length, warm_start);
      SolverReport report  = iterate_pin_and_forces(force_per_length, iterate);
      if (!report.converged && iterate.is_warm)
        {
          // What it was started from has nothing to do with this force.
          const unsigned int n_before = report.n_iterations;
          iterate = first_iterate(force_per_length, nullptr);
          report  = iterate_pin_and_forces(force_per_length, iterate);
          report.n_iterations += n_before;
        }
      if (!report.converged)
        {
          iterate.pin_centre.setZero();
          iterate.ring_place.setZero();
          iterate.nodal_force.setZero();
          iterate.active_set.clear();
        }
      for (unsigned int k = 0;
           !report.converged && k < parameters.max_linearisations;
           ++k)
        {
          if (!solve_programme(&force_per_length, iterate))
            break;
          // If Newton does not converge from the programme's solution, that is
          // where to linearise next.
          Iterate            polished = iterate;
          const unsigned int n_before = report.n_iterations;
          report = iterate_pin_and_forces(force_per_length, polished);
          report.n_iterations += n_before + 1;
          if (report.converged)
            iterate = polished;
        }
      return make_solution(iterate, report);
    }



    ContactSolution
    ContactSolver::solve_position_controlled(const Eigen::Vector2d &pin_centre,
                                             const ContactSolution *warm_start)
    {
      Assert(!housing, dealii::ExcNotImplemented());
      Iterate iterate;
      iterate.pin_centre  = pin_centre;
      iterate.nodal_force = Eigen::VectorXd::Zero(surface.n_nodes());
      evaluate_gap(iterate, Rows::near_contact);
      if (warm_start != nullptr)
        {
          iterate.active_set = warm_start->active_set;
          iterate.is_warm    = true;
        }
      SolverReport report = iterate_forces(iterate);
      // Where the nodes in contact are known the programme has nothing to add.
      if (!report.converged && !report.stagnated &&
          solve_programme(nullptr, iterate))
        {
          const unsigned int n_before = report.n_iterations;
          report                      = iterate_forces(iterate);
          report.n_iterations += n_before + 1;
        }
      if (!report.converged)
        evaluate_gap(iterate, Rows::all);
      return make_solution(iterate, report);
    }



    PinStiffness
    ContactSolver::compute_pin_stiffness(const ContactSolution &solution,
                                         const Eigen::VectorXd &recess_slope)
    {
      Assert(!housing, dealii::ExcNotImplemented());
      const ActiveSet &active = solution.active_set;
      PinStiffness     result;
      if (active.empty())
        return result;
      // How the gaps close with e and alpha.
      Eigen::MatrixX3d closing = Eigen::MatrixX3d::Zero(active.size(), 3);
      for (std::size_t k = 0; k < active.size(); ++k)
        {
          const Eigen::Vector2d to_node =
            surface.positions.col(active[k]) - solution.pin_centre;
          const double          distance = to_node.norm();
          const Eigen::Vector2d m        = to_node / distance;
          closing.row(k).head<2>()       = m.transpose();
          if (recess_slope.size() > 0)
            closing(k, 2) = -recess_slope[active[k]];
          result.force.leftCols<2>() -=
            solution.nodal_force[active[k]] / distance *
            (Eigen::Matrix2d::Identity() - m * m.transpose());
        }
      active_compliance.update(active, /*small changes = */ true);
      const Eigen::MatrixX3d d_forces = active_compliance.solve(closing);
      result.force += closing.leftCols<2>().transpose() * d_forces;
      result.nodal_force_sum = d_forces.colwise().sum();
      result.moment          = -closing.col(2).transpose() * d_forces;
      return result;
    }



    double
    ContactSolver::stored_energy(const ContactSolution &solution) const
    {
      Assert(!housing, dealii::ExcNotImplemented());
      // Where a force acts, the gap is closed: C lambda is minus the rigid gap.
      double twice = 0.;
      for (const Eigen::Index i : solution.active_set)
        twice += solution.nodal_force[i] *
                 (pin_radius -
                  (surface.positions.col(i) - solution.pin_centre).norm() -
                  (pin_recess.size() > 0 ? pin_recess[i] : 0.));
      return twice / 2.;
    }



    ContactSolution
    ContactSolver::solve_held(const Eigen::Vector2d &force_per_length,
                              const ContactSolution &start)
    {
      if (start.active_set.empty() || (housing && start.rim.active_set.empty()))
        return solve_force_controlled(force_per_length, nullptr);

      Iterate iterate = first_iterate(force_per_length, &start);
      newton_step(force_per_length, iterate);
      if (!iterate.nodal_force.allFinite() || !is_in_place(iterate))
        return solve_force_controlled(force_per_length, nullptr);

      evaluate_gap(iterate, Rows::all);
      const SolverReport report{false, 1, relative_gap(iterate), ""};
      ContactSolution    solution = make_solution(iterate, report);
      std::tie(solution.next_active_set, solution.rim.next_active_set) =
        split(next_active_set(iterate), surface.n_nodes());
      return solution;
    }



    ContactSolver::Iterate
    ContactSolver::first_iterate(const Eigen::Vector2d &force,
                                 const ContactSolution *warm_start) const
    {
      Iterate iterate;
      if (warm_start != nullptr && !warm_start->active_set.empty())
        {
          iterate.pin_centre  = warm_start->pin_centre;
          iterate.nodal_force = warm_start->nodal_force;
          iterate.active_set  = warm_start->active_set;
          iterate.is_warm     = true;
          if (housing)
            {
              const RimContact &rim = warm_start->rim;
              iterate.ring_place    = rim.ring_place;
              iterate.nodal_force.resize(n_nodes());
              iterate.nodal_force << warm_start->nodal_force, rim.nodal_force;
              for (const Eigen::Index k : rim.active_set)
                iterate.active_set.push_back(surface.n_nodes() + k);
            }
        }
      else
        {
          // From a centred pin and too wide a contact the iteration shrinks the
          // contact monotonically in nearly all cases.
          iterate.nodal_force       = Eigen::VectorXd::Zero(n_nodes());
          const Eigen::Index n_bore = surface.n_nodes();
          for (Eigen::Index i = 0; i < n_nodes(); ++i)
            {
              const Eigen::Vector2d normal =
                i < n_bore ? surface.normals.col(i)
                           : housing->rim.normals.col(i - n_bore);
              if (normal.dot(force) >= 0.5 * force.norm())
                iterate.active_set.push_back(i);
            }
        }
      evaluate_gap(iterate, Rows::near_contact);
      return iterate;
    }



    PinGap
    ContactSolver::rigid_gap(const Iterate &iterate) const
    {
      PinGap pin(surface.positions, iterate.pin_centre, pin_radius, pin_recess);
      return housing ? append_rim(pin, *housing, iterate.ring_place) : pin;
    }



    void
    ContactSolver::evaluate_gap(Iterate &iterate, const Rows rows) const
    {
      iterate.pin = rigid_gap(iterate);
      // Near is where the pin overlaps the undeformed bore, and a little more.
      // A free ring bends, and may touch elsewhere.
      const double     limit = (rows == Rows::all || housing)
                                 ? std::numeric_limits<double>::max()
                                 : -0.1 * iterate.pin.gap.minCoeff();
      std::vector<Arc> columns, rows_of_gap;
      if (rows != Rows::beside_contact)
        iterate.yielding.setZero(n_nodes());
      for (const Eigen::Index i : iterate.active_set)
        append(i, columns);
      auto held = iterate.active_set.begin();
      for (Eigen::Index i = 0; i < n_nodes(); ++i)
        {
          const bool is_held = held != iterate.active_set.end() && *held == i;
          if (is_held)
            ++held;
          else
            iterate.yielding[i] = 0.;
          if (is_held ? rows != Rows::beside_contact
                      : iterate.pin.gap[i] < limit)
            append(i, rows_of_gap);
        }

      const Eigen::MatrixXd &C = compliance.matrix();
      for (const Arc &row : rows_of_gap)
        for (const Arc &column : columns)
          DenseProducts::add_product(
            C.block(row.begin, column.begin, row.length, column.length),
            iterate.nodal_force.segment(column.begin, column.length),
            iterate.yielding.segment(row.begin, row.length));
      // A distance is known to a few roundings only; under forces so small
      // that the bore yields less than that, this is all there is.
      iterate.gap_tolerance =
        std::max(8. * std::numeric_limits<double>::epsilon() * pin_radius,
                 parameters.tolerance *
                   iterate.yielding.lpNorm<Eigen::Infinity>());
      iterate.gap = iterate.yielding + iterate.pin.gap;
    }



    SolverReport
    ContactSolver::iterate_pin_and_forces(const Eigen::Vector2d &force,
                                          Iterate               &iterate)
    {
      SolverReport        report;
      std::set<ActiveSet> visited;
      unsigned int        n_unchanged = 0;
      while (report.n_iterations < parameters.max_iterations)
        {
          ++report.n_iterations;
          const std::string lost = what_is_lost(force, iterate);
          if (!lost.empty())
            return failure(report, lost);
          newton_step(force, iterate);
          if (!iterate.nodal_force.allFinite() || !is_in_place(iterate))
            return failure(report, "the pin left the bore");

          evaluate_gap(iterate, Rows::beside_contact);
          report.residual =
            std::max(relative_gap(iterate), imbalance(force, iterate));

          // Unless the force passes through it, the pin would roll off it.
          if (has_single_node(iterate) &&
              report.residual > parameters.tolerance)
            return failure(report, "one node does not hold the pin");

          ActiveSet active = next_active_set(iterate);
          if (active == iterate.active_set &&
              report.residual <= parameters.tolerance)
            {
              evaluate_gap(iterate, Rows::all);
              report.residual =
                std::max(report.residual, relative_gap(iterate));
              active = next_active_set(iterate);
            }
          if (active != iterate.active_set)
            {
              if (!visited.insert(iterate.active_set).second)
                return failure(report, "the active sets repeat themselves");
              change_active_set(std::move(active), iterate);
              n_unchanged = 0;
            }
          else if (report.residual <= parameters.tolerance)
            {
              report.converged = true;
              return report;
            }
          // Newton's method needs no more than three iterations then, unless
          // what is solved with has gone bad.
          else if (++n_unchanged > 3 && active_compliance.refresh())
            n_unchanged = 0;
        }
      report.stagnated = n_unchanged > 3;
      return failure(report,
                     report.stagnated ? describe_stagnation(report.residual)
                                      : "no convergence");
    }



    std::string
    ContactSolver::what_is_lost(const Eigen::Vector2d &force,
                                const Iterate         &iterate) const
    {
      const auto &active = iterate.active_set;
      if (active.empty() || active.front() >= surface.n_nodes())
        return "the contact was lost";
      // A ring that a tight pin widens need not touch its housing.
      if (housing && active.back() < surface.n_nodes() && force.norm() > 0.)
        return "the housing was lost";
      return "";
    }



    bool
    ContactSolver::has_single_node(const Iterate &iterate) const
    {
      const auto &active = iterate.active_set;
      if (!housing)
        return active.size() == 1;
      const auto rim =
        std::lower_bound(active.begin(), active.end(), surface.n_nodes());
      return rim - active.begin() == 1 || active.end() - rim == 1;
    }



    bool
    ContactSolver::is_in_place(const Iterate &iterate) const
    {
      return iterate.pin_centre.norm() < pin_radius &&
             (!housing || iterate.ring_place.norm() < housing->radius);
    }



    double
    ContactSolver::imbalance(const Eigen::Vector2d &force,
                             const Iterate         &iterate) const
    {
      const PinGap          &pin    = iterate.pin;
      const Eigen::VectorXd &forces = iterate.nodal_force;
      if (!housing)
        return (pin.directions * forces - force).norm() / forces.lpNorm<1>();
      const Eigen::Index n_bore = surface.n_nodes();
      const Eigen::Index n_rim  = housing->rim.n_nodes();
      return std::max(
               (pin.directions.leftCols(n_bore) * forces.head(n_bore) - force)
                 .norm(),
               (pin.directions.rightCols(n_rim) * forces.tail(n_rim) - force)
                 .norm()) /
             forces.lpNorm<1>();
    }



    void
    ContactSolver::newton_step(const Eigen::Vector2d &force, Iterate &iterate)
    {
      if (!housing)
        iterate.pin_centre += newton_step<2>(force, iterate);
      else
        {
          const Eigen::Vector4d step = newton_step<4>(force, iterate);
          iterate.pin_centre += step.head<2>();
          iterate.ring_place += step.tail<2>();
        }
    }



    template <int n_free>
    typename RigidPlaces<n_free>::Vector
    ContactSolver::newton_step(const Eigen::Vector2d &force, Iterate &iterate)
    {
      using Places  = RigidPlaces<n_free>;
      using Square  = typename Places::Square;
      using Vector  = typename Places::Vector;
      using Columns = Eigen::Matrix<double, Eigen::Dynamic, n_free + 1>;
      // With y = C_A^{-1} m_A and z = C_A^{-1} g_A, the changes are
      //   dlambda_A = y d - z,   (m_A^T y + H) d = f - m_A^T (lambda_A - z),
      // H = d(sum lambda_i m_i)/de. As changes they correct the rounding errors
      // of the iteration before.
      const PinGap      &pin              = iterate.pin;
      const auto        &active           = iterate.active_set;
      const Eigen::Index n                = active.size();
      const Eigen::Index n_bore           = surface.n_nodes();
      Columns            right_hand_sides = Columns::Zero(n, n_free + 1);
      Square             geometric        = Square::Zero();
      for (Eigen::Index k = 0; k < n; ++k)
        {
          const Eigen::Index i = active[k];
          right_hand_sides.template block<1, 2>(k,
                                                Places::first_column(i,
                                                                     n_bore)) =
            pin.directions.col(i).transpose();
          right_hand_sides(k, n_free) = iterate.gap[i];
          Places::add_curvature(
            geometric, pin, i, n_bore, iterate.nodal_force[i]);
        }
      active_compliance.update(active, iterate.is_warm);
      const Columns yz        = active_compliance.solve(right_hand_sides);
      const auto    m         = right_hand_sides.template leftCols<n_free>();
      const auto    y         = yz.template leftCols<n_free>();
      const Square  stiffness = m.transpose() * y;
      const Square  balancing =
        Places::invert_stiffness(stiffness, active, n_bore);
      // A single node leaves the body where it is sideways.
      const Square    inverse     = Places::are_held(active, n_bore)
                                      ? Square((stiffness + geometric).inverse())
                                      : balancing;
      const Vector    both_forces = Places::repeat(force);
      Eigen::VectorXd forces = iterate.nodal_force(active) - yz.col(n_free);
      const Vector    step   = inverse * (both_forces - m.transpose() * forces);

      forces += y * step;
      // The difference of two large terms balances the force to their rounding
      // only; what is missing is far less than a rounding of the pin's place.
      const Vector balance =
        both_forces - geometric * step - m.transpose() * forces;
      const Vector correction = balancing * balance;
      forces += y * correction;
      iterate.nodal_force(active) = forces;
      iterate.yielding(active) +=
        m * (step + correction) - right_hand_sides.col(n_free);
      return step;
    }



    SolverReport
    ContactSolver::iterate_forces(Iterate &iterate)
    {
      SolverReport        report;
      std::set<ActiveSet> visited;
      // Of the iterations since the nodes in contact have changed, or what is
      // solved with: how many in a row have not halved the smallest residual.
      unsigned int n_in_vain         = 0;
      double       smallest_residual = std::numeric_limits<double>::max();
      if (iterate.active_set.empty())
        iterate.active_set = next_active_set(iterate);
      while (report.n_iterations < parameters.max_iterations)
        {
          ++report.n_iterations;
          const auto &active = iterate.active_set;
          if (!active.empty())
            {
              active_compliance.update(active, iterate.is_warm);
              const Eigen::VectorXd gap = iterate.gap(active);
              iterate.nodal_force(active) -= active_compliance.solve(gap);
              iterate.yielding(active) -= gap;
            }
          evaluate_gap(iterate, Rows::beside_contact);
          ActiveSet next = next_active_set(iterate);
          if (next == active)
            {
              evaluate_gap(iterate, Rows::all);
              next = next_active_set(iterate);
            }
          report.residual = relative_gap(iterate);
          if (next != active)
            {
              if (!visited.insert(active).second)
                return failure(report, "the active sets repeat themselves");
              change_active_set(std::move(next), iterate);
              n_in_vain         = 0;
              smallest_residual = std::numeric_limits<double>::max();
            }
          else if (report.residual <= parameters.tolerance)
            {
              report.converged = true;
              return report;
            }
          else if (report.residual <= 0.5 * smallest_residual)
            {
              n_in_vain         = 0;
              smallest_residual = report.residual;
            }
          else if (++n_in_vain > 2)
            {
              if (!active_compliance.refresh())
                {
                  report.stagnated = true;
                  return failure(report, describe_stagnation(report.residual));
                }
              n_in_vain         = 0;
              smallest_residual = std::numeric_limits<double>::max();
            }
        }
      return failure(report, "no convergence");
    }



    bool
    ContactSolver::solve_programme(const Eigen::Vector2d *force,
                                   Iterate               &iterate) const
    {
      iterate.pin = rigid_gap(iterate);
      const ContactProgramme programme{
        compliance.matrix(),
        iterate.pin.gap,
        iterate.pin.directions,
        force != nullptr,
        force != nullptr ? *force : Eigen::Vector2d(0., 0.),
        8. * std::numeric_limits<double>::epsilon() * pin_radius,
        parameters.tolerance,
        n_nodes() - surface.n_nodes()};
      const auto solution = solve_contact_programme(programme);
      Iterate    moved    = iterate;
      moved.pin_centre += solution.pin_step;
      moved.ring_place += solution.ring_step;
      const bool usable = solution.report.converged && is_in_place(moved);
      if (usable)
        {
          iterate.pin_centre  = moved.pin_centre;
          iterate.ring_place  = moved.ring_place;
          iterate.nodal_force = solution.nodal_force;
          iterate.active_set  = solution.active_set;
        }
      evaluate_gap(iterate, Rows::all);
      return usable;
    }



    void
    ContactSolver::change_active_set(ActiveSet next, Iterate &iterate) const
    {
      // What is released pulls no longer.
      auto kept = next.begin();
      for (const Eigen::Index i : iterate.active_set)
        {
          while (kept != next.end() && *kept < i)
            ++kept;
          if (kept == next.end() || *kept != i)
            {
              iterate.yielding -=
                iterate.nodal_force[i] * compliance.matrix().col(i);
              iterate.nodal_force[i] = 0.;
            }
        }
      iterate.gap        = iterate.yielding + iterate.pin.gap;
      iterate.active_set = std::move(next);
    }



    ActiveSet
    ContactSolver::next_active_set(const Iterate &iterate)
    {
      ActiveSet active;
      active.reserve(iterate.active_set.size() + 16);
      auto held = iterate.active_set.begin();
      for (Eigen::Index i = 0; i < iterate.gap.size(); ++i)
        if (held != iterate.active_set.end() && *held == i)
          {
            ++held;
            if (iterate.nodal_force[i] > 0.)
              active.push_back(i);
          }
        else if (iterate.gap[i] < -iterate.gap_tolerance)
          active.push_back(i);
      return active;
    }



    double
    ContactSolver::relative_gap(const Iterate &iterate) const
    {
      double largest = 0.;
      for (const Eigen::Index i : iterate.active_set)
        largest = std::max(largest, std::abs(iterate.gap[i]));
      return largest / iterate.gap_tolerance * parameters.tolerance;
    }



    ContactSolution
    ContactSolver::make_solution(const Iterate      &iterate,
                                 const SolverReport &report) const
    {
      const Eigen::Index n_bore = surface.n_nodes();
      ContactSolution    solution;
      solution.nodal_force = iterate.nodal_force.head(n_bore);
      solution.pressure   = solution.nodal_force.cwiseQuotient(surface.weights);
      solution.gap        = iterate.gap.head(n_bore);
      solution.pin_centre = iterate.pin_centre;
      solution.force =
        iterate.pin.directions.leftCols(n_bore) * solution.nodal_force;
      std::tie(solution.active_set, solution.rim.active_set) =
        split(iterate.active_set, n_bore);
      solution.next_active_set = solution.active_set;
      if (housing)
        {
          RimContact        &rim   = solution.rim;
          const Eigen::Index n_rim = housing->rim.n_nodes();
          rim.nodal_force          = iterate.nodal_force.tail(n_rim);
          rim.pressure   = rim.nodal_force.cwiseQuotient(housing->rim.weights);
          rim.gap        = iterate.gap.tail(n_rim);
          rim.ring_place = iterate.ring_place;
          rim.force = iterate.pin.directions.rightCols(n_rim) * rim.nodal_force;
          rim.next_active_set = rim.active_set;
        }
      solution.report     = report;
      solution.half_angle = contact_half_angle(solution, surface);
      return solution;
    }
  } // namespace Contact
} // namespace Tribody

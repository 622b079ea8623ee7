#include <Eigen/LU>

#include <tribody/contact/contact_programme.h>
#include <tribody/contact/contact_solver.h>
#include <tribody/contact/dense_products.h>
#include <tribody/contact/pin_gap.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
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
    } // namespace



    ContactSolver::ContactSolver(const BoreSurface             &surface,
                                 const Eigen::MatrixXd         &compliance,
                                 const double                   pin_radius,
                                 const ContactSolverParameters &parameters)
      : surface(surface)
      , compliance(compliance)
      , pin_radius(pin_radius)
      , parameters(parameters)
    {}



    ContactSolution
    ContactSolver::solve_force_controlled(
      const Eigen::Vector2d &force_per_length,
      const ContactSolution *warm_start)
    {
      const double force = force_per_length.norm();
      if (force == 0.)
        {
          Iterate untouched;
          untouched.nodal_force = Eigen::VectorXd::Zero(surface.n_nodes());
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
      Iterate iterate;
      iterate.pin_centre  = pin_centre;
      iterate.nodal_force = Eigen::VectorXd::Zero(surface.n_nodes());
      evaluate_gap(iterate, Rows::near);
      if (warm_start != nullptr)
        {
          iterate.active_set = warm_start->active_set;
          iterate.is_warm    = true;
        }
      SolverReport report = iterate_forces(iterate);
      if (!report.converged && solve_programme(nullptr, iterate))
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
      active_compliance.update(compliance, active, /*small changes = */ true);
      const Eigen::MatrixX3d d_forces = active_compliance.solve(closing);
      result.force += closing.leftCols<2>().transpose() * d_forces;
      result.nodal_force_sum = d_forces.colwise().sum();
      result.moment          = -closing.col(2).transpose() * d_forces;
      return result;
    }



    double
    ContactSolver::stored_energy(const ContactSolution &solution) const
    {
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
      if (start.active_set.empty())
        return solve_force_controlled(force_per_length, nullptr);

      Iterate iterate = first_iterate(force_per_length, &start);
      newton_step(force_per_length, iterate);
      if (!iterate.nodal_force.allFinite() ||
          !(iterate.pin_centre.norm() < pin_radius))
        return solve_force_controlled(force_per_length, nullptr);

      evaluate_gap(iterate, Rows::all);
      const SolverReport report{false, 1, relative_gap(iterate), ""};
      ContactSolution    solution = make_solution(iterate, report);
      solution.next_active_set    = next_active_set(iterate);
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
        }
      else
        {
          // From a centred pin and too wide a contact the iteration shrinks the
          // contact monotonically in nearly all cases.
          iterate.nodal_force = Eigen::VectorXd::Zero(surface.n_nodes());
          for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
            if (surface.normals.col(i).dot(force) >= 0.5 * force.norm())
              iterate.active_set.push_back(i);
        }
      evaluate_gap(iterate, Rows::near);
      return iterate;
    }



    void
    ContactSolver::evaluate_gap(Iterate &iterate, const Rows rows) const
    {
      iterate.pin =
        PinGap(surface.positions, iterate.pin_centre, pin_radius, pin_recess);
      // Near is where the pin overlaps the undeformed bore, and a little more.
      const double     limit = (rows == Rows::all)
                                 ? std::numeric_limits<double>::max()
                                 : -0.1 * iterate.pin.gap.minCoeff();
      std::vector<Arc> columns, rows_of_gap;
      for (const Eigen::Index i : iterate.active_set)
        append(i, columns);
      auto held = iterate.active_set.begin();
      for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
        {
          const bool is_held = held != iterate.active_set.end() && *held == i;
          if (is_held)
            ++held;
          if (is_held || iterate.pin.gap[i] < limit)
            append(i, rows_of_gap);
        }

      iterate.gap.setZero(surface.n_nodes());
      for (const Arc &row : rows_of_gap)
        for (const Arc &column : columns)
          add_product(compliance.block(
                        row.begin, column.begin, row.length, column.length),
                      iterate.nodal_force.segment(column.begin, column.length),
                      iterate.gap.segment(row.begin, row.length));
      // A distance is known to a few roundings only; under forces so small
      // that the bore yields less than that, this is all there is.
      iterate.gap_tolerance =
        std::max(8. * std::numeric_limits<double>::epsilon() * pin_radius,
                 parameters.tolerance * iterate.gap.lpNorm<Eigen::Infinity>());
      iterate.gap += iterate.pin.gap;
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
          if (iterate.active_set.empty())
            return failure(report, "the contact was lost");
          newton_step(force, iterate);
          if (!iterate.nodal_force.allFinite() ||
              !(iterate.pin_centre.norm() < pin_radius))
            return failure(report, "the pin left the bore");

          evaluate_gap(iterate, Rows::near);
          const double imbalance =
            (iterate.pin.directions * iterate.nodal_force - force).norm() /
            iterate.nodal_force.lpNorm<1>();
          report.residual = std::max(relative_gap(iterate), imbalance);

          // Unless the force passes through it, the pin would roll off it.
          if (iterate.active_set.size() == 1 &&
              report.residual > parameters.tolerance)
            return failure(report, "one node does not hold the pin");

          ActiveSet active = next_active_set(iterate);
          if (active == iterate.active_set &&
              report.residual <= parameters.tolerance)
            {
              evaluate_gap(iterate, Rows::all);
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
          else if (++n_unchanged > 3 && active_compliance.refresh(compliance))
            n_unchanged = 0;
        }
      return failure(report, "no convergence");
    }



    void
    ContactSolver::newton_step(const Eigen::Vector2d &force, Iterate &iterate)
    {
      // With y = C_A^{-1} m_A and z = C_A^{-1} g_A, the changes are
      //   dlambda_A = y d - z,   (m_A^T y + H) d = f - m_A^T (lambda_A - z),
      // H = d(sum lambda_i m_i)/de. As changes they correct the rounding errors
      // of the iteration before.
      const PinGap      &pin    = iterate.pin;
      const auto        &active = iterate.active_set;
      const Eigen::Index n      = active.size();
      Eigen::MatrixX3d   right_hand_sides(n, 3);
      Eigen::Matrix2d    geometric = Eigen::Matrix2d::Zero();
      for (Eigen::Index k = 0; k < n; ++k)
        {
          const Eigen::Index    i = active[k];
          const Eigen::Vector2d m = pin.directions.col(i);
          right_hand_sides.row(k) << m[0], m[1], iterate.gap[i];
          geometric -= iterate.nodal_force[i] / pin.distances[i] *
                       (Eigen::Matrix2d::Identity() - m * m.transpose());
        }
      active_compliance.update(compliance, active, iterate.is_warm);
      const Eigen::MatrixX3d yz = active_compliance.solve(right_hand_sides);
      const auto             m  = right_hand_sides.leftCols<2>();
      const auto             y  = yz.leftCols<2>();
      const Eigen::Matrix2d  stiffness = m.transpose() * y;
      const Eigen::Matrix2d  balancing = invert_pin_stiffness(stiffness, n);
      // A single node leaves the pin where it is sideways.
      const Eigen::Matrix2d inverse =
        (n == 1) ? balancing
                 : Eigen::Matrix2d((stiffness + geometric).inverse());
      Eigen::VectorXd       forces = iterate.nodal_force(active) - yz.col(2);
      const Eigen::Vector2d step   = inverse * (force - m.transpose() * forces);

      forces += y * step;
      // The difference of two large terms balances the force to their rounding
      // only; what is missing is far less than a rounding of the pin's place.
      const Eigen::Vector2d balance =
        force - geometric * step - m.transpose() * forces;
      forces += y * (balancing * balance);
      iterate.nodal_force(active) = forces;
      iterate.pin_centre += step;
    }



    SolverReport
    ContactSolver::iterate_forces(Iterate &iterate)
    {
      SolverReport        report;
      std::set<ActiveSet> visited;
      unsigned int        n_unchanged = 0;
      if (iterate.active_set.empty())
        iterate.active_set = next_active_set(iterate);
      while (report.n_iterations < parameters.max_iterations)
        {
          ++report.n_iterations;
          const auto &active = iterate.active_set;
          if (!active.empty())
            {
              active_compliance.update(compliance, active, iterate.is_warm);
              const Eigen::VectorXd change =
                active_compliance.solve(iterate.gap(active));
              iterate.nodal_force(active) -= change;
            }
          evaluate_gap(iterate, Rows::near);
          report.residual = relative_gap(iterate);
          ActiveSet next  = next_active_set(iterate);
          if (next == active)
            {
              evaluate_gap(iterate, Rows::all);
              next = next_active_set(iterate);
            }
          if (next != active)
            {
              if (!visited.insert(active).second)
                return failure(report, "the active sets repeat themselves");
              change_active_set(std::move(next), iterate);
              n_unchanged = 0;
            }
          else if (report.residual <= parameters.tolerance ||
                   (++n_unchanged > 2 &&
                    !active_compliance.refresh(compliance)))
            {
              report.converged = true;
              return report;
            }
        }
      return failure(report, "no convergence");
    }



    bool
    ContactSolver::solve_programme(const Eigen::Vector2d *force,
                                   Iterate               &iterate) const
    {
      iterate.pin =
        PinGap(surface.positions, iterate.pin_centre, pin_radius, pin_recess);
      const ContactProgramme programme{
        compliance,
        iterate.pin.gap,
        iterate.pin.directions,
        force != nullptr,
        force != nullptr ? *force : Eigen::Vector2d(0., 0.),
        8. * std::numeric_limits<double>::epsilon() * pin_radius,
        parameters.tolerance};
      const auto            solution = solve_contact_programme(programme);
      const Eigen::Vector2d moved    = iterate.pin_centre + solution.pin_step;
      const bool            usable =
        solution.report.converged && moved.norm() < pin_radius;
      if (usable)
        {
          iterate.pin_centre  = moved;
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
              iterate.gap -= iterate.nodal_force[i] * compliance.col(i);
              iterate.nodal_force[i] = 0.;
            }
        }
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
      ContactSolution solution;
      solution.nodal_force = iterate.nodal_force;
      solution.pressure    = iterate.nodal_force.cwiseQuotient(surface.weights);
      solution.gap         = iterate.gap;
      solution.pin_centre  = iterate.pin_centre;
      solution.force       = iterate.pin.directions * iterate.nodal_force;
      solution.active_set  = iterate.active_set;
      solution.next_active_set = iterate.active_set;
      solution.report          = report;
      solution.half_angle      = contact_half_angle(solution, surface);
      return solution;
    }
  } // namespace Contact
} // namespace Tribody

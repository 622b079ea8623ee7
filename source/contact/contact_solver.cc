#include <Eigen/LU>

#include <tribody/contact/contact_programme.h>
#include <tribody/contact/contact_solver.h>
#include <tribody/contact/pin_gap.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>

namespace Tribody
{
  namespace Contact
  {
    namespace
    {
      /**
       * Nodes in contact stay as long as they are pressed, others enter when
       * the pin would penetrate them. A node is released because its force
       * has turned to tension, not because its gap has opened: as long as it
       * is held, its gap is zero by construction.
       */
      ActiveSet
      update_active_set(const Eigen::VectorXd &nodal_force,
                        const Eigen::VectorXd &gap,
                        const ActiveSet       &old,
                        const double           gap_tolerance)
      {
        ActiveSet active;
        active.reserve(old.size() + 16);
        auto next_old = old.begin();
        for (Eigen::Index i = 0; i < gap.size(); ++i)
          if (next_old != old.end() && *next_old == i)
            {
              ++next_old;
              if (nodal_force[i] > 0.)
                active.push_back(i);
            }
          else if (gap[i] < -gap_tolerance)
            active.push_back(i);
        return active;
      }

      double
      largest(const Eigen::VectorXd &values, const ActiveSet &active)
      {
        double result = 0.;
        for (const Eigen::Index i : active)
          result = std::max(result, std::abs(values[i]));
        return result;
      }

      SolverReport
      failure(SolverReport report, const std::string &message)
      {
        report.converged = false;
        report.message   = message;
        return report;
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
      const PinGap centred(surface.positions,
                           Eigen::Vector2d::Zero(),
                           pin_radius);
      const double force = force_per_length.norm();
      if (force == 0. && centred.gap.minCoeff() >= 0.)
        {
          Iterate untouched;
          untouched.nodal_force = Eigen::VectorXd::Zero(surface.n_nodes());
          return make_solution(untouched, {true, 0, 0., ""});
        }

      Iterate iterate =
        first_iterate(force > 0. ? Eigen::Vector2d(force_per_length / force)
                                 : Eigen::Vector2d(Eigen::Vector2d::Zero()),
                      warm_start);
      SolverReport report = iterate_pin_and_forces(force_per_length, iterate);
      if (!report.converged)
        iterate.pin_centre.setZero();
      for (unsigned int k = 0;
           !report.converged && k < parameters.max_linearisations;
           ++k)
        {
          if (!solve_programme(&force_per_length, iterate))
            break;
          // The programme's pin centre is where to linearise next; Newton
          // converges from there, or leaves it as it was.
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
      if (warm_start != nullptr)
        iterate.active_set = warm_start->active_set;
      SolverReport report = iterate_forces(iterate);
      if (!report.converged && solve_programme(nullptr, iterate))
        {
          const unsigned int n_before = report.n_iterations;
          report                      = iterate_forces(iterate);
          report.n_iterations += n_before + 1;
        }
      return make_solution(iterate, report);
    }



    ContactSolver::Iterate
    ContactSolver::first_iterate(const Eigen::Vector2d &direction,
                                 const ContactSolution *warm_start) const
    {
      Iterate iterate;
      if (warm_start != nullptr && !warm_start->active_set.empty())
        {
          iterate.pin_centre  = warm_start->pin_centre;
          iterate.nodal_force = warm_start->nodal_force;
          iterate.active_set  = warm_start->active_set;
          return iterate;
        }
      // From a centred pin and too wide a contact the iteration shrinks the
      // contact monotonically in nearly all cases.
      iterate.nodal_force = Eigen::VectorXd::Zero(surface.n_nodes());
      for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
        if (surface.normals.col(i).dot(direction) >= 0.5 * direction.norm())
          iterate.active_set.push_back(i);
      return iterate;
    }



    SolverReport
    ContactSolver::iterate_pin_and_forces(const Eigen::Vector2d &force,
                                          Iterate               &iterate)
    {
      SolverReport        report;
      std::set<ActiveSet> visited;
      PinGap pin(surface.positions, iterate.pin_centre, pin_radius);
      while (report.n_iterations < parameters.max_iterations)
        {
          ++report.n_iterations;
          if (iterate.active_set.empty())
            return failure(report, "the contact was lost");
          newton_step(force, pin, iterate);
          if (!iterate.nodal_force.allFinite() ||
              !(iterate.pin_centre.norm() < pin_radius))
            return failure(report, "the pin left the bore");

          pin = PinGap(surface.positions, iterate.pin_centre, pin_radius);
          const Eigen::VectorXd displacement =
            compute_elastic_displacement(iterate);
          const Eigen::VectorXd gap       = pin.gap + displacement;
          const double          tolerance = gap_tolerance(displacement);
          const double          imbalance =
            (pin.directions * iterate.nodal_force - force).norm() /
            iterate.nodal_force.lpNorm<1>();
          report.residual = std::max(largest(gap, iterate.active_set) /
                                       tolerance * parameters.tolerance,
                                     imbalance);

          ActiveSet active = update_active_set(iterate.nodal_force,
                                               gap,
                                               iterate.active_set,
                                               tolerance);
          if (active != iterate.active_set)
            {
              if (!visited.insert(iterate.active_set).second)
                return failure(report, "the active sets repeat themselves");
              iterate.active_set = std::move(active);
            }
          else if (report.residual <= parameters.tolerance)
            {
              report.converged = true;
              return report;
            }
        }
      return failure(report, "no convergence");
    }



    void
    ContactSolver::newton_step(const Eigen::Vector2d &force,
                               const PinGap          &pin,
                               Iterate               &iterate)
    {
      // With y = C_A^{-1} m_A and z = C_A^{-1} g^0_A:
      //   lambda_A = y d - z,   (m_A^T y + H) d = f + m_A^T z,
      // H = d(sum lambda_i m_i)/de.
      const auto        &active = iterate.active_set;
      const Eigen::Index n      = active.size();
      Eigen::MatrixX3d   right_hand_sides(n, 3);
      Eigen::Matrix2d    geometric = Eigen::Matrix2d::Zero();
      for (Eigen::Index k = 0; k < n; ++k)
        {
          const Eigen::Index    i = active[k];
          const Eigen::Vector2d m = pin.directions.col(i);
          right_hand_sides.row(k) << m[0], m[1], pin.gap[i];
          geometric -= iterate.nodal_force[i] / pin.distances[i] *
                       (Eigen::Matrix2d::Identity() - m * m.transpose());
        }
      active_compliance.update(compliance, active);
      const Eigen::MatrixX3d yz = active_compliance.solve(right_hand_sides);
      const auto             m  = right_hand_sides.leftCols<2>();
      const auto             y  = yz.leftCols<2>();
      const Eigen::Matrix2d  stiffness = m.transpose() * y;
      const Eigen::Vector2d  step =
        (stiffness + geometric).inverse() * (force + m.transpose() * yz.col(2));

      Eigen::VectorXd forces = y * step - yz.col(2);
      // The difference of two large terms balances the force to their rounding
      // only; what is missing is far less than a rounding of the pin's place.
      const Eigen::Vector2d balance =
        force - geometric * step - m.transpose() * forces;
      forces += y * (stiffness.inverse() * balance);
      iterate.nodal_force.setZero();
      iterate.nodal_force(active) = forces;
      iterate.pin_centre += step;
    }



    SolverReport
    ContactSolver::iterate_forces(Iterate &iterate)
    {
      SolverReport        report;
      std::set<ActiveSet> visited;
      const PinGap pin(surface.positions, iterate.pin_centre, pin_radius);
      if (iterate.active_set.empty())
        iterate.active_set =
          update_active_set(iterate.nodal_force, pin.gap, {}, 0.);
      while (report.n_iterations < parameters.max_iterations)
        {
          ++report.n_iterations;
          iterate.nodal_force.setZero();
          const auto &active = iterate.active_set;
          if (!active.empty())
            {
              active_compliance.update(compliance, active);
              const Eigen::VectorXd forces =
                -active_compliance.solve(pin.gap(active));
              iterate.nodal_force(active) = forces;
            }
          const Eigen::VectorXd displacement =
            compute_elastic_displacement(iterate);
          const Eigen::VectorXd gap       = pin.gap + displacement;
          const double          tolerance = gap_tolerance(displacement);
          report.residual =
            largest(gap, active) / tolerance * parameters.tolerance;
          ActiveSet next =
            update_active_set(iterate.nodal_force, gap, active, tolerance);
          if (next == active)
            {
              report.converged = true;
              return report;
            }
          if (!visited.insert(active).second)
            return failure(report, "the active sets repeat themselves");
          iterate.active_set = std::move(next);
        }
      return failure(report, "no convergence");
    }



    bool
    ContactSolver::solve_programme(const Eigen::Vector2d *force,
                                   Iterate               &iterate) const
    {
      const PinGap pin(surface.positions, iterate.pin_centre, pin_radius);
      const ContactProgramme programme{compliance,
                                       pin.gap,
                                       pin.directions,
                                       force != nullptr,
                                       force != nullptr
                                         ? *force
                                         : Eigen::Vector2d(0., 0.),
                                       gap_tolerance(Eigen::VectorXd::Zero(1)),
                                       parameters.tolerance};
      const auto             solution = solve_contact_programme(programme);
      const Eigen::Vector2d  moved    = iterate.pin_centre + solution.pin_step;
      if (!solution.report.converged || !(moved.norm() < pin_radius))
        return false;
      iterate.pin_centre  = moved;
      iterate.nodal_force = solution.nodal_force;
      iterate.active_set  = solution.active_set;
      return true;
    }



    Eigen::VectorXd
    ContactSolver::compute_elastic_displacement(const Iterate &iterate) const
    {
      Eigen::VectorXd displacement = Eigen::VectorXd::Zero(compliance.rows());
      for (const Eigen::Index i : iterate.active_set)
        displacement += iterate.nodal_force[i] * compliance.col(i);
      return displacement;
    }



    double
    ContactSolver::gap_tolerance(
      const Eigen::VectorXd &elastic_displacement) const
    {
      // A distance is known to a few roundings only; under forces so small
      // that the bore yields less than that, this is all there is.
      const double rounding =
        8. * std::numeric_limits<double>::epsilon() * pin_radius;
      return std::max(rounding,
                      parameters.tolerance *
                        elastic_displacement.lpNorm<Eigen::Infinity>());
    }



    ContactSolution
    ContactSolver::make_solution(const Iterate      &iterate,
                                 const SolverReport &report) const
    {
      const PinGap    pin(surface.positions, iterate.pin_centre, pin_radius);
      ContactSolution solution;
      solution.nodal_force = iterate.nodal_force;
      solution.pressure    = iterate.nodal_force.cwiseQuotient(surface.weights);
      solution.gap         = pin.gap + compute_elastic_displacement(iterate);
      solution.pin_centre  = iterate.pin_centre;
      solution.force       = pin.directions * iterate.nodal_force;
      solution.active_set  = iterate.active_set;
      solution.report      = report;
      solution.half_angle  = contact_half_angle(solution, surface);
      return solution;
    }
  } // namespace Contact
} // namespace Tribody

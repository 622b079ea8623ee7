// SPDX-License-Identifier: LGPL-2.1-or-later

#include <Eigen/LU>

#include <tribody/base/exceptions.h>
#include <tribody/base/interruption.h>
#include <tribody/base/units.h>
#include <tribody/multibody/following/following_pins.h>
#include <tribody/multibody/following/slow_motion_start.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // Of the farthest marker of a body.
      double
      lever(const Mechanism &mechanism, const unsigned int body)
      {
        double result = 0.;
        for (const auto &[name, p] :
             mechanism.parameters().bodies[body].markers)
          result = std::max(result, p.norm());
        return result;
      }



      constexpr int n_times = 5;
      constexpr int centre  = n_times / 2;

      // One value per time, and one row per time of the derivative.
      using TimeMatrix = Eigen::Matrix<double, n_times, n_times>;

      // Derivatives of the polynomial through values at -2, -1, 0, 1, 2 are
      // values times the transpose of this: from Vandermonde matrices.
      TimeMatrix
      differentiation_matrix(const int order)
      {
        TimeMatrix powers, derivatives = TimeMatrix::Zero();
        for (int i = 0; i < n_times; ++i)
          for (int k = 0; k < n_times; ++k)
            {
              powers(i, k) = std::pow(i - centre, k);
              if (k >= order)
                derivatives(i, k) = std::pow(i - centre, k - order) *
                                    std::tgamma(k + 1.) /
                                    std::tgamma(k - order + 1.);
            }
        return derivatives * powers.inverse();
      }



      // Turn the velocities of pins at a fixed distance, which differences give
      // up to their error, along the bores.
      void
      keep_distances(const FollowingPins    &pins,
                     const Eigen::Matrix2Xd &e,
                     PinRates               &rates)
      {
        const auto &joints = pins.equations_of_motion().mechanism().joints();
        for (Eigen::Index p = 0; p < e.cols(); ++p)
          if (joints[pins.joints()[p]].link != nullptr)
            {
              const Eigen::Vector2d n = e.col(p).normalized();
              auto                  v = rates.velocities.col(p);
              v -= n.dot(v) * n;
            }
      }



      // By differences of the places at all times.
      std::array<PinRates, n_times>
      find_rates(const FollowingPins                         &pins,
                 const std::array<FollowingInstant, n_times> &instants,
                 const double                                 spacing)
      {
        static const TimeMatrix first  = differentiation_matrix(1),
                                second = differentiation_matrix(2);
        std::array<PinRates, n_times> rates;
        for (int k = 0; k < n_times; ++k)
          {
            rates[k] = pins.no_rates();
            for (int i = 0; i < n_times; ++i)
              {
                const Eigen::Matrix2Xd &e = instants[i].eccentricities;
                rates[k].velocities += first(k, i) / spacing * e;
                rates[k].accelerations +=
                  second(k, i) / (spacing * spacing) * e;
              }
            keep_distances(pins, instants[k].eccentricities, rates[k]);
          }
        return rates;
      }



      double
      largest_column(const Eigen::Matrix2Xd &columns)
      {
        return columns.colwise().norm().maxCoeff();
      }



      // Pins that follow their bores around the time t_0. Throws ExcRun where
      // their own motion matters too much.
      FollowingInstant
      follow_motion(const FollowingPins   &pins,
                    const double           t_0,
                    const double           spacing,
                    const Eigen::VectorXd &q)
      {
        constexpr unsigned int max_passes = 30;
        // Of the forces: what the pins' motion may change them by, and where
        // the passes end. Second differences over a short time magnify what a
        // pass changes. With much of it the passes grow, and may end at a
        // motion of the pins that has nothing to do with that of the mechanism:
        // each is to change no more than half of what the one before did.
        constexpr double follows = 0.02, tolerance = 1e-8, shrinks = 0.5;

        std::array<FollowingInstant, n_times> instants;
        std::array<PinRates, n_times>         rates;
        rates.fill(pins.no_rates());
        FollowingInstant best;
        double           last_change = 0.;
        for (unsigned int pass = 0; pass < max_passes; ++pass)
          {
            stop_if_interrupted();
            const Eigen::Matrix2Xd before = instants[centre].reactions;
            for (int k = 0; k < n_times; ++k)
              instants[k] = pins.find(t_0 + (k - centre) * spacing,
                                      pass == 0 ? q : instants[k].state.q,
                                      rates[k]);
            if (pass > 0)
              {
                const double force = largest_column(before);
                const double change =
                  largest_column(instants[centre].reactions - before);
                AssertThrow(pass > 1 || change <= follows * force,
                            ExcRun("by their motion in the bores, which the "
                                   "turning of the forces asks of them, these "
                                   "would change from " +
                                   Units::to_string(force, "N", "N") + " by " +
                                   Units::to_string(change, "N", "N")));
                if (pass > 1 && change > shrinks * last_change)
                  return best;
                best        = instants[centre];
                last_change = change;
                if (change <= tolerance * force)
                  return best;
              }
            rates = find_rates(pins, instants, spacing);
          }
        return best;
      }



      // Speeds of the bodies: linear ones and those of their farthest markers.
      double
      largest_speed(const Mechanism &mechanism, const Eigen::VectorXd &v)
      {
        double largest = 0.;
        for (unsigned int b = 0; b < mechanism.parameters().bodies.size(); ++b)
          largest = std::max({largest,
                              v.segment<2>(3 * b).norm(),
                              lever(mechanism, b) * std::abs(v(3 * b + 2))});
        return largest;
      }



      // Why pins that sit as at start are none to begin with, beside the motion
      // of the mechanism with ideal joints; empty if they are.
      std::string
      find_fault(const FollowingPins    &pins,
                 const FollowingInstant &start,
                 const Motion           &ideal,
                 const Eigen::Matrix2Xd &ideal_reactions)
      {
        const Mechanism &mechanism = pins.equations_of_motion().mechanism();
        // What offsets of the pins do to a motion is as much as they are of the
        // shortest body, and more where the mechanism translates it; and to
        // forces friction adds to it.
        constexpr double translation = 5., of_friction = 0.25;
        double           shortest = mechanism.size();
        for (unsigned int b = 0; b < mechanism.parameters().bodies.size(); ++b)
          if (lever(mechanism, b) > 0.)
            shortest = std::min(shortest, lever(mechanism, b));
        const double share =
          translation * start.eccentricities.colwise().norm().sum() / shortest;

        const double speed =
          std::max(largest_speed(mechanism, ideal.v),
                   std::sqrt(shortest * largest_speed(mechanism, ideal.a)));
        const double change = largest_speed(mechanism, start.state.v - ideal.v);
        if (change > share * speed)
          return "bodies would begin with velocities " +
                 Units::to_string(change, "m/s", "m/s") +
                 " off those with ideal joints";
        const double           force = largest_column(ideal_reactions);
        const Eigen::Matrix2Xd off   = start.reactions - ideal_reactions;
        for (Eigen::Index p = 0; p < off.cols(); ++p)
          if (!(off.col(p).norm() <= (share + of_friction) * force))
            return "the force of joint '" +
                   mechanism.joints()[pins.joints()[p]].name + "' would be " +
                   Units::to_string(start.reactions.col(p).norm(), "N", "N") +
                   " instead of the " +
                   Units::to_string(ideal_reactions.col(p).norm(), "N", "N") +
                   " of an ideal joint";
        return "";
      }



      // Reactions of ideal joints with the smallest velocities that the
      // constraints allow.
      Eigen::VectorXd
      ideal_reactions(const EquationsOfMotion &closed,
                      const MechanismState    &state,
                      const ConstraintOffsets &none)
      {
        const MechanismState slow = {
          state.time,
          state.q,
          compute_velocities(closed, state.time, none, state.q),
          {}};
        return compute_accelerations(closed, slow).multipliers;
      }



      // Move the pins of massless links to their ends.
      void
      add_links(const EquationsOfMotion &equations,
                const EquationsOfMotion &closed,
                MechanismState          &state,
                ConstraintOffsets       &offsets)
      {
        const Mechanism &mechanism = equations.mechanism();
        const Mechanism &ideal     = closed.mechanism();
        Eigen::VectorXd  reactions;
        for (unsigned int j = 0; j < mechanism.joints().size(); ++j)
          {
            if (mechanism.joints()[j].model != JointModel::massless_link)
              continue;
            if (reactions.size() == 0)
              reactions = ideal_reactions(closed, state, offsets);
            const unsigned int row =
              ideal.constraints()[ideal.joints()[j].index].first_row;
            Eigen::Vector2d direction = reactions.segment<2>(row);
            if (!(direction.norm() > 0))
              direction = Eigen::Vector2d::UnitX();
            offsets.value.segment<2>(row) =
              mechanism.joints()[j].link->length * direction.normalized();
          }
        if (reactions.size() == 0)
          return;
        const SolverReport report =
          solve_positions(closed, state.time, offsets, state.q);
        AssertThrow(report.converged,
                    ExcRun("The mechanism cannot be assembled with its "
                           "massless links at time " +
                           std::to_string(state.time) + " s."));
      }
    } // namespace



    StartingState
    compute_centred_start(const EquationsOfMotion &equations,
                          const EquationsOfMotion &closed,
                          const double             t_0)
    {
      StartingState     start;
      ConstraintOffsets offsets(closed.mechanism().n_constraints());
      start.state.time = t_0;
      start.state.q    = assemble_configuration(closed, t_0);
      add_links(equations, closed, start.state, offsets);
      start.state.v = compute_initial_velocities(closed, t_0, start.state.q);
      start.report.converged = true;
      return start;
    }



    StartingState
    compute_slow_motion_start(const EquationsOfMotion &equations,
                              const EquationsOfMotion &closed,
                              const double             t_0,
                              const double             spacing)
    {
      const FollowingPins pins(equations, closed);
      const Mechanism    &ideal_mechanism = closed.mechanism();
      StartingState       start;
      std::string         reasons;
      if (ideal_mechanism.n_degrees_of_freedom() < 0)
        reasons = "the forces of ideal joints are not determined";
      else
        {
          const Eigen::VectorXd q = assemble_configuration(closed, t_0);
          const Motion          ideal =
            solve_motion(closed,
                         t_0,
                         ConstraintOffsets(ideal_mechanism.n_constraints()),
                         Eigen::VectorXd::Zero(ideal_mechanism.n_coordinates()),
                         q);
          const Eigen::Matrix2Xd reactions = pins.reactions(ideal.multipliers);
          // Whether it has been accepted.
          const auto try_start = [&](const auto &find) {
            try
              {
                const FollowingInstant instant = find();
                const std::string      fault =
                  find_fault(pins, instant, ideal, reactions);
                if (fault.empty())
                  {
                    start.state            = instant.state;
                    start.report.converged = true;
                    return true;
                  }
                reasons += (reasons.empty() ? "" : "; ") + fault;
              }
            catch (const ExcRun &error)
              {
                reasons += (reasons.empty() ? "" : "; ") + message_of(error);
              }
            return false;
          };
          // A free motion is known at its beginning only.
          if (ideal_mechanism.n_degrees_of_freedom() == 0 &&
              try_start([&]() { return follow_motion(pins, t_0, spacing, q); }))
            return start;
          const bool has_other_start =
            try_start([&]() { return pins.find(t_0, q, pins.no_rates()); });
          if (has_other_start)
            {
              if (!reasons.empty())
                start.report.message =
                  "the pins began at rest in their bores, where their forces "
                  "press them, as they cannot follow (" +
                  reasons + ")";
              return start;
            }
        }
      start = compute_centred_start(equations, closed, t_0);
      start.report.message =
        "the pins began in the middle of their bushings, as no place at the "
        "bores was found to start from (" +
        reasons + ")";
      return start;
    }
  } // namespace Multibody
} // namespace Tribody

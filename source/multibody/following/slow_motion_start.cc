// SPDX-License-Identifier: LGPL-2.1-or-later

#include <Eigen/LU>

#include <tribody/base/exceptions.h>
#include <tribody/base/interruption.h>
#include <tribody/multibody/following/resting_pin.h>
#include <tribody/multibody/following/slow_motion_start.h>
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



      // The search for e(t): see compute_slow_motion_start().
      class SlowMotionSearch
      {
      public:
        SlowMotionSearch(const EquationsOfMotion &equations,
                         const EquationsOfMotion &closed,
                         const double             t_0,
                         const double             spacing);

        StartingState
        solve();

      private:
        // Motion at all times with the present e(t) and friction moments.
        void
        update_motion();

        // New e(t) from the reactions; returns the largest change relative to
        // the penetration.
        double
        update_eccentricities();

        void
        update_eccentricity(const unsigned int j, const int k);

        void
        update_link(const unsigned int j, const int k);

        const EquationsOfMotion &equations;
        const EquationsOfMotion &closed;
        const double             t_0;
        const double             spacing;
        const TimeMatrix         first;
        const TimeMatrix         second;

        // One entry per joint that is not ideal: its index among those with
        // contact forces, or its link if it has none.
        std::vector<unsigned int>                      contact_indices;
        std::vector<const MasslessLinkConstraint *>    links;
        std::vector<unsigned int>                      rows;
        std::vector<Eigen::Matrix<double, 2, n_times>> e;
        std::vector<Eigen::Matrix<double, 1, n_times>> penetrations;
        std::vector<Eigen::VectorXd>                   extra_forces;
        std::vector<Motion>                            motions;
      };



      SlowMotionSearch::SlowMotionSearch(const EquationsOfMotion &equations,
                                         const EquationsOfMotion &closed,
                                         const double             t_0,
                                         const double             spacing)
        : equations(equations)
        , closed(closed)
        , t_0(t_0)
        , spacing(spacing)
        , first(differentiation_matrix(1) / spacing)
        , second(differentiation_matrix(2) / (spacing * spacing))
      {
        const Mechanism &mechanism = equations.mechanism();
        for (unsigned int j = 0; j < mechanism.joints().size(); ++j)
          if (mechanism.joints()[j].has_gap())
            {
              contact_indices.push_back(mechanism.joints()[j].index);
              links.push_back(mechanism.joints()[j].link.get());
              rows.push_back(
                closed.mechanism()
                  .constraints()[closed.mechanism().joints()[j].index]
                  .first_row);
            }
        e.assign(rows.size(), Eigen::Matrix<double, 2, n_times>::Zero());
        penetrations.assign(rows.size(),
                            Eigen::Matrix<double, 1, n_times>::Zero());
        extra_forces.assign(n_times,
                            Eigen::VectorXd::Zero(mechanism.n_coordinates()));
        motions.resize(n_times);
        for (Motion &motion : motions)
          motion.q = assemble_configuration(closed, t_0);
      }



      void
      SlowMotionSearch::update_motion()
      {
        for (int k = 0; k < n_times; ++k)
          {
            ConstraintOffsets offsets(closed.mechanism().n_constraints());
            for (unsigned int j = 0; j < rows.size(); ++j)
              {
                offsets.value.segment<2>(rows[j]) = e[j].col(k);
                offsets.first_derivative.segment<2>(rows[j]) =
                  e[j] * first.row(k).transpose();
                offsets.second_derivative.segment<2>(rows[j]) =
                  e[j] * second.row(k).transpose();
              }
            motions[k] = solve_motion(closed,
                                      t_0 + (k - centre) * spacing,
                                      offsets,
                                      extra_forces[k],
                                      motions[k].q);
          }
      }



      void
      SlowMotionSearch::update_link(const unsigned int j, const int k)
      {
        const Eigen::Vector2d reaction =
          motions[k].multipliers.segment<2>(rows[j]);
        const double force = reaction.norm();
        e[j].col(k)        = force > 0
                               ? Eigen::Vector2d(links[j]->length / force * reaction)
                               : Eigen::Vector2d(links[j]->length, 0.);
        penetrations[j](k) = links[j]->length;
      }



      void
      SlowMotionSearch::update_eccentricity(const unsigned int j, const int k)
      {
        if (links[j] != nullptr)
          {
            update_link(j, k);
            return;
          }
        const unsigned int    index = contact_indices[j];
        const ClearanceJoint &joint =
          equations.mechanism().clearance_joints()[index];
        const Motion         &motion   = motions[k];
        const Eigen::Vector2d reaction = motion.multipliers.segment<2>(rows[j]);
        const JointContact    contact  = equations.compute_contact(
          index, motion.q, motion.v, joint.minimum_approach_speed);

        // Far from the solution the rate has no meaning yet, and a law may not
        // allow a force at large negative ones.
        const double     rate = std::clamp(contact.penetration_rate,
                                       -0.5 * joint.minimum_approach_speed,
                                       0.5 * joint.minimum_approach_speed);
        const RestingPin pin =
          find_resting_pin(equations, index, motion, contact, reaction, rate);
        penetrations[j](k) = pin.penetration;
        e[j].col(k)        = pin.eccentricity;

        PairVector moments = PairVector::Zero();
        moments(2)         = pin.moments(0);
        moments(5)         = pin.moments(1);
        joint.bodies.add_to(moments, extra_forces[k]);
      }



      double
      SlowMotionSearch::update_eccentricities()
      {
        for (Eigen::VectorXd &forces : extra_forces)
          forces.setZero();
        double change = 0.;
        for (unsigned int j = 0; j < rows.size(); ++j)
          {
            const Eigen::Matrix<double, 2, n_times> old = e[j];
            for (int k = 0; k < n_times; ++k)
              update_eccentricity(j, k);
            change = std::max(change,
                              (e[j] - old).colwise().norm().maxCoeff() /
                                penetrations[j].maxCoeff());
          }
        return change;
      }



      StartingState
      SlowMotionSearch::solve()
      {
        StartingState          start;
        SolverReport          &report         = start.report;
        constexpr unsigned int max_iterations = 100;
        constexpr double       tolerance      = 1e-8;
        while (!report.converged && report.n_iterations < max_iterations)
          {
            stop_if_interrupted();
            update_motion();
            report.residual  = update_eccentricities();
            report.converged = report.residual < tolerance;
            ++report.n_iterations;
          }
        update_motion();
        start.state = {t_0, motions[centre].q, motions[centre].v, {}};
        if (!report.converged)
          report.message = "the search stopped after " +
                           std::to_string(report.n_iterations) + " iterations";
        return start;
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
      return SlowMotionSearch(equations, closed, t_0, spacing).solve();
    }
  } // namespace Multibody
} // namespace Tribody

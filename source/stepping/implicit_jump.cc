// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/stepping/implicit_jump.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // Depth that counts as none [m]: a small part of the clearance.
      double
      smallest_depth(const WearingBushing &bushing)
      {
        const Multibody::JointParameters &joint = bushing.joint_parameters();
        return 0.05 * std::max(joint.clearance(), 1e-5 * joint.bushing_radius);
      }



      // Some 3 iterations are usual; when that many do not do, a shorter step
      // is the better way.
      constexpr unsigned int max_iterations = 40;
      // In the second case they are changed one by one until it gets better.
      constexpr unsigned int max_in_vain = 3;
      // Part of the rate, in the norm of the errors: forces that are less sure
      // than that say nothing about the nodes in contact.
      constexpr double max_inconsistency = 1e-2;
    } // namespace



    ImplicitJump::ImplicitJump(std::list<WearingBushing> &bushings,
                               const StopConditions      &stop_conditions,
                               const double               tolerance)
      : CycleJump(bushings, stop_conditions)
      , tolerance(tolerance)
      , first_entry(1, 0)
      , integrator(make_equation(), tolerance)
    {
      for (const WearingBushing &bushing : bushings)
        first_entry.push_back(first_entry.back() + bushing.depth().size());
    }



    Wear::WearEquation
    ImplicitJump::make_equation()
    {
      return {[this](const double           cycles,
                     const Eigen::VectorXd &a,
                     const double           gamma,
                     const Eigen::VectorXd &guess) {
                return solve_stage(cycles, a, gamma, guess);
              },
              [this](const Eigen::VectorXd &y) {
                return stop_conditions.evaluate(depths_after(y));
              },
              stop_conditions.n_conditions()};
    }



    int
    ImplicitJump::advance(RunState &state, const double end)
    {
      // What is known already of the state at which the step begins.
      run                  = &state;
      Eigen::VectorXd rate = rate_of(state.contacts);
      if (rate_change.size() > 0)
        rate = integrator.end_rate() + rate_change;
      take_contacts(state.contacts);
      compute_weights(state.contacts);

      integrator.start(state.cycles,
                       Eigen::VectorXd::Zero(first_entry.back()),
                       rate,
                       weights,
                       max_step);
      const bool stopped = integrator.step(end);

      const Eigen::VectorXd              y      = integrator.state();
      const std::vector<Eigen::VectorXd> depths = depths_after(y);
      std::size_t                        b      = 0;
      for (WearingBushing &bushing : bushings)
        {
          wear(bushing, state.totals[b], depths[b], part(y, b));
          ++b;
        }
      state.cycles = integrator.cycles();
      if (!stopped)
        return -1;
      int condition = -1;
      stop_conditions.evaluate(depths).maxCoeff(&condition);
      return condition;
    }



    void
    ImplicitJump::compute_weights(const std::vector<CycleContact> &contacts)
    {
      weights.resize(first_entry.back());
      largest_depths.clear();
      std::size_t b = 0;
      for (const WearingBushing &bushing : bushings)
        {
          const CycleContact   &contact = contacts[b];
          const Eigen::VectorXd depth   = bushing.depth();
          for (const WearingSurface &surface : bushing.surfaces())
            {
              const Eigen::VectorXd h = surface.part_of(depth);
              const Eigen::VectorXd D =
                surface.part_of(contact.area_derivative);
              // Depths that do not matter for the clearance do not tighten the
              // tolerance.
              const double floor = smallest_depth(bushing);
              const double max_rate =
                surface.part_of(contact.wear_rate).maxCoeff();
              const double max_depth = std::max(floor, h.maxCoeff());
              double       area      = D.dot(h);
              double       arc       = D.sum();
              if (max_rate > 0.)
                {
                  area += floor / max_rate *
                          surface.part_of(contact.removed_area).sum();
                  arc = area / (h.maxCoeff() + floor);
                }
              largest_depths.push_back(max_depth);
              const Eigen::Index first = first_entry[b] + surface.first_node;
              weights.segment(first, D.size()) =
                (D * arc).cwiseSqrt().cwiseInverse() / max_depth;
            }
          ++b;
        }
    }



    void
    ImplicitJump::take_contacts(const std::vector<CycleContact> &begin)
    {
      // Which nodes the last stage held says more than the contacts at the
      // beginning: where the bore is stiff, what has changed since the last
      // step decides those.
      bool is_similar = contacts.size() == begin.size();
      for (std::size_t b = 0; is_similar && b < begin.size(); ++b)
        is_similar = contacts[b].samples.size() == begin[b].samples.size();
      if (!is_similar)
        contacts = begin;
    }



    std::optional<Eigen::VectorXd>
    ImplicitJump::solve_stage(const double           cycles,
                              const Eigen::VectorXd &a,
                              const double           gamma,
                              const Eigen::VectorXd &guess)
    {
      const auto norm = [this](const Eigen::VectorXd &v) {
        return v.cwiseProduct(weights).norm();
      };
      Eigen::VectorXd           y = guess;
      std::vector<CycleContact> best;
      std::size_t  fewest    = std::numeric_limits<std::size_t>::max();
      unsigned int n_in_vain = 0;
      for (unsigned int k = 0; k < max_iterations; ++k)
        {
          // Newton's step for all contacts and the wear together: the contacts
          // at y, what the wear then is, and the contacts there.
          ++n_evaluations;
          const Eigen::VectorXd first = rate_of(hold_nodes(cycles, y));
          stage_matrix.compute(compute_jacobian(), gamma);
          y += stage_matrix.solve(a + gamma * first - y);

          contacts                       = hold_nodes(cycles, y);
          const Eigen::VectorXd rate     = rate_of(contacts);
          const Eigen::VectorXd residual = a + gamma * rate - y;
          if (norm(residual) > max_inconsistency * gamma * norm(rate))
            continue;

          const std::size_t n_wrong = count_wrong_nodes();
          if (n_wrong == 0)
            return y + stage_matrix.solve(residual);
          if (n_wrong < fewest)
            {
              fewest    = n_wrong;
              best      = contacts;
              n_in_vain = 0;
            }
          else if (++n_in_vain == max_in_vain)
            contacts = best;
          change_nodes(n_in_vain >= max_in_vain);
        }
      return {};
    }



    std::vector<CycleContact>
    ImplicitJump::hold_nodes(const double           cycles,
                             const Eigen::VectorXd &y) const
    {
      const std::vector<Eigen::VectorXd> depths = depths_after(y);
      std::vector<CycleContact>          result;
      for (const WearingBushing &bushing : bushings)
        {
          const std::size_t                b = result.size();
          const Multibody::JointDutyCycle &cycle =
            run->duty_cycle.joint(bushing.name());
          result.push_back(
            bushing.compute_held_contact(depths[b],
                                         cycle,
                                         contacts[b],
                                         run->totals[b].sliding_distance +
                                           (cycles - run->cycles) *
                                             cycle.sliding_distance()));
        }
      return result;
    }



    std::size_t
    ImplicitJump::count_wrong_nodes() const
    {
      std::size_t n = 0, b = 0;
      for (const WearingBushing &bushing : bushings)
        n += bushing.count_wrong_nodes(contacts[b++]);
      return n;
    }



    void
    ImplicitJump::change_nodes(const bool one_by_one)
    {
      for (CycleContact &contact : contacts)
        for (Contact::ContactSolution &sample : contact.samples)
          Contact::take_next_active_set(sample, one_by_one);
    }



    Eigen::VectorXd
    ImplicitJump::rate_of(const std::vector<CycleContact> &contacts) const
    {
      Eigen::VectorXd rate(first_entry.back());
      for (std::size_t b = 0; b < contacts.size(); ++b)
        rate.segment(first_entry[b], first_entry[b + 1] - first_entry[b]) =
          contacts[b].removed_area;
      return rate;
    }



    Eigen::MatrixXd
    ImplicitJump::compute_jacobian() const
    {
      Eigen::MatrixXd jacobian =
        Eigen::MatrixXd::Zero(first_entry.back(), first_entry.back());
      std::size_t b = 0;
      for (const WearingBushing &bushing : bushings)
        {
          const Eigen::VectorXd &D = contacts[b].area_derivative;
          jacobian.block(first_entry[b], first_entry[b], D.size(), D.size()) =
            D.asDiagonal() * bushing.compute_wear_rate_jacobian(contacts[b]) *
            D.cwiseInverse().asDiagonal();
          ++b;
        }
      return jacobian;
    }



    std::vector<StepError>
    ImplicitJump::estimate_error(
      const std::vector<CycleContact> &contacts_after,
      const double                     cycles_kept)
    {
      // What the integrator estimates, and half of what the new duty cycle and
      // compliance change in the rate, times the cycles that they were kept
      // for, as far as the wear under way does not level it again.
      const Eigen::VectorXd local = integrator.local_error();
      rate_change =
        stage_matrix.solve(rate_of(contacts_after) - integrator.end_rate());
      const Eigen::VectorXd lag = 0.5 * cycles_kept * rate_change;

      const double relative_lag = lag.cwiseProduct(weights).norm();
      max_step                  = relative_lag > 0.
                                    ? 0.9 * cycles_kept * std::sqrt(tolerance / relative_lag)
                                    : 0.;

      std::vector<StepError> errors;
      std::size_t            b = 0, n_surfaces = 0;
      for (const WearingBushing &bushing : bushings)
        {
          StepError   error{Eigen::VectorXd(bushing.depth().size()), {}};
          std::size_t i = 0;
          for (const WearingSurface &surface : bushing.surfaces())
            {
              const auto of_surface = [&](const Eigen::VectorXd &y) {
                return y.segment(first_entry[b] + surface.first_node,
                                 surface.n_nodes);
              };
              double       depth_error   = 0.;
              const double largest_depth = largest_depths[n_surfaces++];
              for (const Eigen::VectorXd &e : {local, lag})
                {
                  depth_error +=
                    of_surface(e).cwiseProduct(of_surface(weights)).norm() *
                    largest_depth;
                  error.volumes[i] += std::abs(of_surface(e).sum()) *
                                      bushing.bushing_parameters().axial_length;
                }
              error.depth.segment(surface.first_node, surface.n_nodes)
                .setConstant(depth_error);
              ++i;
            }
          errors.push_back(error);
          ++b;
        }
      return errors;
    }



    std::vector<Eigen::VectorXd>
    ImplicitJump::depths_after(const Eigen::VectorXd &y) const
    {
      std::vector<Eigen::VectorXd> depths;
      for (const WearingBushing &bushing : bushings)
        depths.push_back(bushing.depth_after_removing(part(y, depths.size())));
      return depths;
    }



    Eigen::VectorXd
    ImplicitJump::part(const Eigen::VectorXd &y, const std::size_t b) const
    {
      return y.segment(first_entry[b], first_entry[b + 1] - first_entry[b]);
    }
  } // namespace Coupling
} // namespace Tribody

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
      // Part of the tolerance of a step: nodes whose change moves a stage by
      // less than that may go on changing, as those that carry next to nothing
      // do among hundreds of loads.
      constexpr double max_stage_error = 1e-2;



      std::vector<CycleContact>
      contacts_of(const std::vector<JointState> &joints)
      {
        std::vector<CycleContact> contacts;
        for (const JointState &joint : joints)
          contacts.push_back(joint.contact);
        return contacts;
      }
    } // namespace



    ImplicitJump::ImplicitJump(const std::deque<WearingBushing> &bushings,
                               const StopConditions &stop_conditions,
                               const double          tolerance)
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



    WearStep
    ImplicitJump::advance(RunState &state, const double end)
    {
      run           = &state;
      n_evaluations = 0;
      // What is known already of the state at which the step begins.
      const std::vector<CycleContact> begin   = contacts_of(state.joints);
      StepperState                   &stepper = state.stepper;
      contacts                                = stepper.contacts;
      take_contacts(begin);
      compute_weights(begin);

      integrator.restore(stepper.extrapolation);
      integrator.start(state.cycles,
                       Eigen::VectorXd::Zero(first_entry.back()),
                       stepper.rate.size() > 0 ? stepper.rate : rate_of(begin),
                       weights,
                       stepper.max_step);
      const bool stopped = integrator.step(end);

      stepper.contacts      = contacts;
      stepper.extrapolation = integrator.lasting_memory();

      const Eigen::VectorXd y = integrator.state();
      WearStep              step;
      step.cycles             = integrator.cycles();
      step.depths             = depths_after(y);
      step.n_rate_evaluations = n_evaluations;
      for (std::size_t j = 0; j < bushings.size(); ++j)
        step.removed_areas.push_back(part(y, j));
      if (stopped)
        {
          Eigen::Index condition = 0;
          stop_conditions.evaluate(step.depths).maxCoeff(&condition);
          step.reached = condition;
        }
      return step;
    }



    void
    ImplicitJump::compute_weights(const std::vector<CycleContact> &contacts)
    {
      weights.resize(first_entry.back());
      largest_depths.assign(bushings.size(), {});
      for (std::size_t j = 0; j < bushings.size(); ++j)
        {
          const WearingBushing &bushing = bushings[j];
          const CycleContact   &contact = contacts[j];
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
              largest_depths[j].push_back(max_depth);
              const Eigen::Index first = first_entry[j] + surface.first_node;
              weights.segment(first, D.size()) =
                (D * arc).cwiseSqrt().cwiseInverse() / max_depth;
            }
        }
    }



    void
    ImplicitJump::take_contacts(const std::vector<CycleContact> &begin)
    {
      // Which nodes the last stage held says more than the contacts at the
      // beginning: where the bore is stiff, what has changed since the last
      // step decides those.
      bool is_similar = contacts.size() == begin.size();
      for (std::size_t j = 0; is_similar && j < begin.size(); ++j)
        is_similar = contacts[j].samples.size() == begin[j].samples.size();
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
      // Whether the nodes that were wrong have just changed, all or one of each
      // sample.
      bool changed_nodes = false, one_by_one = false;
      for (unsigned int k = 0; k < max_iterations; ++k)
        {
          // Newton's step for all contacts and the wear together: the contacts
          // at y, what the wear then is, and the contacts there.
          ++n_evaluations;
          const Eigen::VectorXd first = rate_of(hold_nodes(cycles, y));
          stage_matrix.compute(compute_jacobian(), gamma);
          const Eigen::VectorXd correction =
            stage_matrix.solve(a + gamma * first - y);
          y += correction;

          contacts                       = hold_nodes(cycles, y);
          const Eigen::VectorXd rate     = rate_of(contacts);
          const Eigen::VectorXd residual = a + gamma * rate - y;
          if (norm(residual) > max_inconsistency * gamma * norm(rate))
            {
              changed_nodes = false;
              continue;
            }

          // What changing the nodes before has moved is more than changing
          // those that are left will.
          const std::size_t n_wrong = count_wrong_nodes();
          const double moved = (one_by_one ? n_wrong : 1.) * norm(correction);
          if (n_wrong == 0 ||
              (changed_nodes && moved <= max_stage_error * tolerance))
            return y + stage_matrix.solve(residual);
          if (n_wrong < fewest)
            {
              fewest    = n_wrong;
              best      = contacts;
              n_in_vain = 0;
            }
          else if (++n_in_vain == max_in_vain)
            contacts = best;
          one_by_one    = n_in_vain >= max_in_vain;
          changed_nodes = true;
          change_nodes(one_by_one);
        }
      return {};
    }



    std::vector<CycleContact>
    ImplicitJump::hold_nodes(const double           cycles,
                             const Eigen::VectorXd &y) const
    {
      const std::vector<Eigen::VectorXd> depths = depths_after(y);
      std::vector<CycleContact>          result;
      for (std::size_t j = 0; j < bushings.size(); ++j)
        {
          const JointState &joint = run->joints[j];
          const double      distance =
            joint.totals.sliding_distance +
            (cycles - run->cycles) * joint.loads.sliding_distance();
          result.push_back(bushings[j].compute_held_contact(
            depths[j], joint.loads, contacts[j], distance));
        }
      return result;
    }



    std::size_t
    ImplicitJump::count_wrong_nodes() const
    {
      std::size_t n = 0;
      for (std::size_t j = 0; j < bushings.size(); ++j)
        n += bushings[j].count_wrong_nodes(contacts[j]);
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
      for (std::size_t j = 0; j < contacts.size(); ++j)
        rate.segment(first_entry[j], first_entry[j + 1] - first_entry[j]) =
          contacts[j].removed_area;
      return rate;
    }



    Eigen::MatrixXd
    ImplicitJump::compute_jacobian() const
    {
      Eigen::MatrixXd jacobian =
        Eigen::MatrixXd::Zero(first_entry.back(), first_entry.back());
      for (std::size_t j = 0; j < bushings.size(); ++j)
        {
          const Eigen::VectorXd &D = contacts[j].area_derivative;
          jacobian.block(first_entry[j], first_entry[j], D.size(), D.size()) =
            D.asDiagonal() *
            bushings[j].compute_wear_rate_jacobian(contacts[j]) *
            D.cwiseInverse().asDiagonal();
        }
      return jacobian;
    }



    std::vector<StepError>
    ImplicitJump::estimate_error(RunState &state, const double cycles_kept)
    {
      // What the integrator estimates, and half of what the new duty cycle and
      // compliance change in the rate, times the cycles that they were kept
      // for, as far as the wear under way does not level it again.
      const Eigen::VectorXd local       = integrator.local_error();
      const Eigen::VectorXd rate_change = stage_matrix.solve(
        rate_of(contacts_of(state.joints)) - integrator.end_rate());
      const Eigen::VectorXd lag = 0.5 * cycles_kept * rate_change;

      const double relative_lag = lag.cwiseProduct(weights).norm();
      state.stepper.rate        = integrator.end_rate() + rate_change;
      state.stepper.max_step =
        relative_lag > 0.
          ? 0.9 * cycles_kept * std::sqrt(tolerance / relative_lag)
          : 0.;

      std::vector<StepError> errors;
      for (std::size_t j = 0; j < bushings.size(); ++j)
        {
          StepError error{Eigen::VectorXd(bushings[j].depth().size()), {}};
          const std::vector<WearingSurface> surfaces = bushings[j].surfaces();
          for (std::size_t i = 0; i < surfaces.size(); ++i)
            {
              const auto of_surface = [&](const Eigen::VectorXd &y) {
                return y.segment(first_entry[j] + surfaces[i].first_node,
                                 surfaces[i].n_nodes);
              };
              double depth_error = 0.;
              for (const Eigen::VectorXd &e : {local, lag})
                {
                  depth_error +=
                    of_surface(e).cwiseProduct(of_surface(weights)).norm() *
                    largest_depths[j][i];
                  error.volumes[i] +=
                    std::abs(of_surface(e).sum()) *
                    bushings[j].bushing_parameters().axial_length;
                }
              error.depth.segment(surfaces[i].first_node, surfaces[i].n_nodes)
                .setConstant(depth_error);
            }
          errors.push_back(error);
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
    ImplicitJump::part(const Eigen::VectorXd &y, const std::size_t j) const
    {
      return y.segment(first_entry[j], first_entry[j + 1] - first_entry[j]);
    }
  } // namespace Coupling
} // namespace Tribody

#include <tribody/coupling/implicit_jump.h>

#include <algorithm>
#include <cmath>

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
        return 0.05 * std::max(joint.bushing_radius - joint.pin_radius,
                               1e-5 * joint.bushing_radius);
      }
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
      return {[this](const double cycles, const Eigen::VectorXd &y) {
                return compute_rate(cycles, y);
              },
              [this]() { return compute_jacobian(); },
              [this](const Eigen::VectorXd &y) {
                return stop_conditions.evaluate(depths_after(y));
              },
              stop_conditions.n_conditions()};
    }



    int
    ImplicitJump::advance(RunState &state, const double end)
    {
      // What is known already of the state at which the step begins.
      run         = &state;
      last_cycles = state.cycles;
      last_y      = Eigen::VectorXd::Zero(first_entry.back());
      contacts    = state.contacts;
      compute_weights();

      integrator.start(state.cycles, last_y, weights, metric, max_step);
      const bool stopped = integrator.step(end);

      const Eigen::VectorXd              y      = integrator.state();
      const std::vector<Eigen::VectorXd> depths = depths_after(y);
      std::size_t                        b      = 0;
      for (WearingBushing &bushing : bushings)
        {
          wear(bushing, state.totals[b], depths[b], part(y, b));
          ++b;
        }
      last_step    = integrator.cycles() - state.cycles;
      state.cycles = integrator.cycles();
      if (!stopped)
        return -1;
      int condition = -1;
      stop_conditions.evaluate(depths).maxCoeff(&condition);
      return condition;
    }



    void
    ImplicitJump::compute_weights()
    {
      weights.resize(first_entry.back());
      metric.resize(first_entry.back());
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
              // Nothing is solved for where nothing wears.
              const double k = surface.law.archard.wear_coefficient;
              metric.segment(first, D.size()) =
                D.cwiseInverse() / (k > 0. ? k : 1.);
            }
          ++b;
        }
    }



    Eigen::VectorXd
    ImplicitJump::compute_rate(const double cycles, const Eigen::VectorXd &y)
    {
      if (y != last_y || (cycles != last_cycles && !rate_is_constant()))
        {
          const std::vector<Eigen::VectorXd> depths = depths_after(y);
          std::size_t                        b      = 0;
          for (const WearingBushing &bushing : bushings)
            {
              const Multibody::JointDutyCycle &cycle =
                run->duty_cycle.joint(bushing.name());
              contacts[b] =
                bushing.compute_cycle_contact(depths[b],
                                              cycle,
                                              &contacts[b],
                                              run->totals[b].sliding_distance +
                                                (cycles - run->cycles) *
                                                  cycle.sliding_distance());
              ++b;
            }
          last_y      = y;
          last_cycles = cycles;
          ++n_evaluations;
        }

      Eigen::VectorXd rate(y.size());
      for (std::size_t b = 0; b < contacts.size(); ++b)
        rate.segment(first_entry[b], first_entry[b + 1] - first_entry[b]) =
          contacts[b].removed_area;
      return rate;
    }



    bool
    ImplicitJump::rate_is_constant() const
    {
      for (const WearingBushing &bushing : bushings)
        for (const WearingSurface &surface : bushing.surfaces())
          if (!surface.law.is_constant())
            return false;
      return true;
    }



    Eigen::MatrixXd
    ImplicitJump::compute_jacobian() const
    {
      Eigen::MatrixXd jacobian =
        Eigen::MatrixXd::Zero(last_y.size(), last_y.size());
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
      const std::vector<CycleContact> &contacts_after)
    {
      // What the integrator estimates, and half a step's worth of what the new
      // duty cycle and compliance change in the rate, as far as the wear under
      // way does not level it again.
      const Eigen::VectorXd local = integrator.local_error();
      Eigen::VectorXd       change(first_entry.back());
      for (std::size_t b = 0; b < contacts_after.size(); ++b)
        change.segment(first_entry[b], first_entry[b + 1] - first_entry[b]) =
          contacts_after[b].removed_area;
      const Eigen::VectorXd lag =
        integrator.damp(0.5 * last_step * (change - integrator.end_rate()));

      const double relative_lag = lag.cwiseProduct(weights).norm();
      max_step                  = relative_lag > 0.
                                    ? 0.9 * last_step * std::sqrt(tolerance / relative_lag)
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

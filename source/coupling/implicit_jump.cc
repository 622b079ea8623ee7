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
        first_entry.push_back(first_entry.back() +
                              bushing.profile().depth.size());
    }



    Wear::WearEquation
    ImplicitJump::make_equation()
    {
      return {[this](const Eigen::VectorXd &y) { return compute_rate(y); },
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
      duty_cycle = &state.duty_cycle;
      last_y     = Eigen::VectorXd::Zero(first_entry.back());
      contacts   = state.contacts;
      compute_weights();

      integrator.start(state.cycles, last_y, weights, max_step);
      const bool stopped = integrator.step(end);

      const Eigen::VectorXd              y      = integrator.state();
      const std::vector<Eigen::VectorXd> depths = depths_after(y);
      std::size_t                        b      = 0;
      for (WearingBushing &bushing : bushings)
        {
          bushing.set_depth(depths[b]);
          state.totals[b].removed_volume +=
            part(y, b).sum() * bushing.bushing_parameters().axial_length;
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
      area_derivatives.clear();
      largest_depths.clear();
      worn_arcs.clear();
      for (const WearingBushing &bushing : bushings)
        {
          const std::size_t      b       = worn_arcs.size();
          const CycleContact    &contact = contacts[b];
          const Eigen::VectorXd &depth   = bushing.profile().depth;
          const Eigen::VectorXd  D =
            bushing.profile().area_derivative(contact.surface);
          // Depths that do not matter for the clearance do not tighten the
          // tolerance.
          const double floor     = smallest_depth(bushing);
          const double max_rate  = contact.wear_rate.maxCoeff();
          const double max_depth = std::max(floor, depth.maxCoeff());
          double       area      = D.dot(depth);
          double       arc       = D.sum();
          if (max_rate > 0.)
            {
              area += floor / max_rate * contact.removed_area.sum();
              arc = area / (depth.maxCoeff() + floor);
            }
          area_derivatives.push_back(D);
          largest_depths.push_back(max_depth);
          worn_arcs.push_back(arc);
          weights.segment(first_entry[b], D.size()) =
            (D * arc).cwiseSqrt().cwiseInverse() / max_depth;
        }
    }



    Eigen::VectorXd
    ImplicitJump::compute_rate(const Eigen::VectorXd &y)
    {
      if (y != last_y)
        {
          const std::vector<Eigen::VectorXd> depths = depths_after(y);
          std::size_t                        b      = 0;
          for (const WearingBushing &bushing : bushings)
            {
              contacts[b] =
                bushing.compute_cycle_contact(depths[b],
                                              duty_cycle->joint(bushing.name()),
                                              &contacts[b]);
              ++b;
            }
          last_y = y;
          ++n_evaluations;
        }

      Eigen::VectorXd rate(y.size());
      for (std::size_t b = 0; b < contacts.size(); ++b)
        rate.segment(first_entry[b], first_entry[b + 1] - first_entry[b]) =
          contacts[b].removed_area;
      return rate;
    }



    Eigen::MatrixXd
    ImplicitJump::compute_jacobian() const
    {
      Eigen::MatrixXd jacobian =
        Eigen::MatrixXd::Zero(last_y.size(), last_y.size());
      std::size_t b = 0;
      for (const WearingBushing &bushing : bushings)
        {
          const Eigen::VectorXd D =
            bushing.profile().area_derivative(contacts[b].surface);
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
      std::size_t            b = 0;
      for (const WearingBushing &bushing : bushings)
        {
          const auto measure = [&](const Eigen::VectorXd &y) {
            return part(y, b).cwiseProduct(part(weights, b)).norm() *
                   largest_depths[b];
          };
          const auto area = [&](const Eigen::VectorXd &y) {
            return std::abs(part(y, b).sum());
          };
          errors.push_back(
            {Eigen::VectorXd::Constant(part(local, b).size(),
                                       measure(local) + measure(lag)),
             (area(local) + area(lag)) *
               bushing.bushing_parameters().axial_length});
          ++b;
        }
      return errors;
    }



    std::vector<Eigen::VectorXd>
    ImplicitJump::depths_after(const Eigen::VectorXd &y) const
    {
      std::vector<Eigen::VectorXd> depths;
      for (const WearingBushing &bushing : bushings)
        depths.push_back(
          bushing.profile().depth_after_removing(part(y, depths.size())));
      return depths;
    }



    Eigen::VectorXd
    ImplicitJump::part(const Eigen::VectorXd &y, const std::size_t b) const
    {
      return y.segment(first_entry[b], first_entry[b + 1] - first_entry[b]);
    }
  } // namespace Coupling
} // namespace Tribody

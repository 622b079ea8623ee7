#include <boost/math/tools/toms748_solve.hpp>

#include <tribody/coupling/cycle_jump.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // Far enough below the stable length that a sawtooth decays; whole
      // cycles as long as there is more than one.
      double
      safe_step(const double max_stable_step)
      {
        const double step = 0.8 * max_stable_step;
        return step > 1. ? std::floor(step) : step;
      }
    } // namespace



    CycleJump::CycleJump(std::list<WearingBushing> &bushings,
                         const StopConditions      &stop_conditions)
      : bushings(bushings)
      , stop_conditions(stop_conditions)
    {}



    ConstantJump::ConstantJump(std::list<WearingBushing> &bushings,
                               const StopConditions      &stop_conditions,
                               const double               cycles_per_step)
      : CycleJump(bushings, stop_conditions)
      , cycles_per_step(cycles_per_step)
    {}



    int
    ConstantJump::advance(RunState &state, const double end)
    {
      update_stable_step(state);
      const Wear::ConstantExtrapolation extrapolation{
        cycles_per_step > 0. ? cycles_per_step
                             : safe_step(state.max_stable_step)};

      rates_before.clear();
      for (const CycleContact &contact : state.contacts)
        rates_before.push_back(contact.wear_rate);
      const auto depths_after = [&](const double n_cycles) {
        std::vector<Eigen::VectorXd> depths;
        for (const WearingBushing &bushing : bushings)
          depths.push_back(bushing.profile().depth +
                           n_cycles * rates_before[depths.size()]);
        return depths;
      };

      // Within an explicit step the depth is linear in the cycles: the moment
      // at which a limit is passed is a root of one number.
      last_step   = extrapolation.next_step(state.cycles, end);
      int reached = -1;
      for (unsigned int i = 0; i < stop_conditions.n_conditions(); ++i)
        {
          const auto value = [&](const double n_cycles) {
            return stop_conditions.evaluate(depths_after(n_cycles))[i];
          };
          if (value(last_step) < 0.)
            continue;
          boost::uintmax_t max_iterations = 100;
          last_step                       = boost::math::tools::toms748_solve(
                        value,
                        0.,
                        last_step,
                        boost::math::tools::eps_tolerance<double>(40),
                        max_iterations)
                        .second;
          reached = i;
        }

      const std::vector<Eigen::VectorXd> depths = depths_after(last_step);
      std::size_t                        b      = 0;
      for (WearingBushing &bushing : bushings)
        {
          bushing.set_depth(depths[b]);
          state.totals[b].removed_volume +=
            last_step * state.contacts[b].removed_area.sum() *
            bushing.bushing_parameters().axial_length;
          ++b;
        }
      state.cycles += last_step;
      return reached;
    }



    void
    ConstantJump::update_stable_step(RunState &state)
    {
      // The bound follows the compliance, and costs an eigenvalue problem.
      unsigned int n_builds = 0;
      for (const WearingBushing &bushing : bushings)
        n_builds += bushing.n_compliance_builds();
      if (n_builds == stable_step_builds)
        return;

      state.max_stable_step = std::numeric_limits<double>::max();
      for (const WearingBushing &bushing : bushings)
        state.max_stable_step = std::min(
          state.max_stable_step,
          bushing.max_stable_step(
            state.duty_cycle.joint(bushing.name()).sliding_distance()));
      stable_step_builds = n_builds;
    }



    Eigen::VectorXd
    ConstantJump::estimate_error(const std::size_t      b,
                                 const Eigen::VectorXd &rate_after) const
    {
      return Wear::euler_error(rates_before[b], rate_after, last_step);
    }



    ImplicitJump::ImplicitJump(std::list<WearingBushing> &bushings,
                               const StopConditions      &stop_conditions,
                               const double               tolerance)
      : CycleJump(bushings, stop_conditions)
      , settings([&]() {
        Wear::ImplicitSettings s;
        s.tolerance = tolerance;
        for (const WearingBushing &bushing : bushings)
          s.n_depths += bushing.profile().depth.size();
        return s;
      }())
      , integrator(make_equation(), settings)
    {}



    Wear::WearEquation
    ImplicitJump::make_equation()
    {
      return {[this](const Eigen::VectorXd &y) { return compute_rate(y); },
              [this]() { return compute_jacobian(); },
              [this](const Eigen::VectorXd &y) {
                return stop_conditions.evaluate(depths_in(y));
              },
              stop_conditions.n_conditions()};
    }



    int
    ImplicitJump::advance(RunState &state, const double end)
    {
      // What is known already of the state at which the step begins.
      duty_cycle = &state.duty_cycle;
      last_y     = pack(state);
      contacts   = state.contacts;

      integrator.start(state.cycles, last_y);
      const bool stopped = integrator.step(end);

      const Eigen::VectorXd              y      = integrator.state();
      const std::vector<Eigen::VectorXd> depths = depths_in(y);
      std::size_t                        b      = 0;
      for (WearingBushing &bushing : bushings)
        {
          bushing.set_depth(depths[b]);
          state.totals[b].removed_volume = y[settings.n_depths + b];
          ++b;
        }
      last_step    = integrator.cycles() - state.cycles;
      last_error   = integrator.local_error();
      state.cycles = integrator.cycles();
      // The rates of the old duty cycle at the new shape, to see what the new
      // one changes.
      compute_rate(y);
      if (!stopped)
        return -1;
      int condition = -1;
      stop_conditions.evaluate(depths).maxCoeff(&condition);
      return condition;
    }



    Eigen::VectorXd
    ImplicitJump::compute_rate(const Eigen::VectorXd &y)
    {
      const std::vector<Eigen::VectorXd> depths = depths_in(y);
      if (y.size() != last_y.size() || y != last_y || contacts.empty())
        {
          std::size_t b = 0;
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
      Eigen::Index    first = 0;
      std::size_t     b     = 0;
      for (const WearingBushing &bushing : bushings)
        {
          rate.segment(first, depths[b].size()) = contacts[b].wear_rate;
          rate[settings.n_depths + b] =
            contacts[b].removed_area.sum() *
            bushing.bushing_parameters().axial_length;
          first += depths[b].size();
          ++b;
        }
      return rate;
    }



    Eigen::MatrixXd
    ImplicitJump::compute_jacobian() const
    {
      Eigen::MatrixXd jacobian =
        Eigen::MatrixXd::Zero(last_y.size(), last_y.size());
      Eigen::Index first = 0;
      std::size_t  b     = 0;
      for (const WearingBushing &bushing : bushings)
        {
          const Eigen::MatrixXd of_bushing =
            bushing.compute_wear_rate_jacobian(contacts[b]);
          const Eigen::Index n               = of_bushing.rows();
          jacobian.block(first, first, n, n) = of_bushing;
          jacobian.row(settings.n_depths + b).segment(first, n) =
            bushing.bushing_parameters().axial_length *
            bushing.profile().area_derivative(contacts[b].surface).transpose() *
            of_bushing;
          first += n;
          ++b;
        }
      return jacobian;
    }



    Eigen::VectorXd
    ImplicitJump::estimate_error(const std::size_t      b,
                                 const Eigen::VectorXd &rate_after) const
    {
      // What the integrator estimates, wherever on the bore, and half a step's
      // worth of what the duty cycle has changed meanwhile.
      Eigen::Index first = 0;
      std::size_t  other = 0;
      for (const WearingBushing &bushing : bushings)
        if (other++ < b)
          first += bushing.profile().depth.size();
      const double local =
        last_error.segment(first, rate_after.size()).lpNorm<Eigen::Infinity>();
      return (0.5 * last_step * (rate_after - contacts[b].wear_rate))
               .cwiseAbs()
               .array() +
             local;
    }



    Eigen::VectorXd
    ImplicitJump::pack(const RunState &state) const
    {
      Eigen::VectorXd y(settings.n_depths + bushings.size());
      Eigen::Index    first = 0;
      std::size_t     b     = 0;
      for (const WearingBushing &bushing : bushings)
        {
          const Eigen::VectorXd &depth   = bushing.profile().depth;
          y.segment(first, depth.size()) = depth;
          y[settings.n_depths + b]       = state.totals[b].removed_volume;
          first += depth.size();
          ++b;
        }
      return y;
    }



    std::vector<Eigen::VectorXd>
    ImplicitJump::depths_in(const Eigen::VectorXd &y) const
    {
      std::vector<Eigen::VectorXd> depths;
      Eigen::Index                 first = 0;
      for (const WearingBushing &bushing : bushings)
        {
          const Eigen::Index n = bushing.profile().depth.size();
          depths.push_back(y.segment(first, n));
          first += n;
        }
      return depths;
    }
  } // namespace Coupling
} // namespace Tribody

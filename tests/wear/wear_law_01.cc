// SPDX-License-Identifier: LGPL-2.1-or-later

// Wear coefficients that are not constant. Known:
// - With k = k_1 (p/p_1)^m (v/v_1)^2 under a given pressure a node loses
//   k_1 w p_1^-m p^(1+m) (v/v_1)^2 ds, and the derivative with respect to its
//   force is (1 + m) times that over the force.
// - Running-in over the distance S under a constant load F removes
//   k F [S + (f_0 - 1) s_0 (1 - exp(-S/s_0))], whether it is given by its
//   parameters or as an expression; integrated over cycles to the tolerance.
// - The product of both factors has the derivative that central differences
//   give (their step of 1e-4 leaves 1e-8).
// - Without factors the law is Archard's.
// - An expression that is negative or cannot be parsed is named with its place.

#include <tribody/base/exceptions.h>
#include <tribody/wear/implicit_extrapolation.h>
#include <tribody/wear/wear_law.h>

#include <cmath>
#include <iostream>
#include <optional>

using namespace Tribody;
using namespace Tribody::Wear;

constexpr double k = 1e-13;

const Eigen::VectorXd pressures = 1e6 * Eigen::VectorXd::LinSpaced(5, 0., 4.);
const Eigen::VectorXd weights   = 1e-3 * Eigen::VectorXd::LinSpaced(5, 1., 2.);
const Eigen::VectorXd forces    = pressures.cwiseProduct(weights);

void
test_power()
{
  const WearLaw         law{{k},
                    {FactorExpression("factor", "(p/2e6)^0.5 * (v/0.1)^2")}};
  const Sliding         sliding{0.01, 0.3, 7.};
  const Eigen::VectorXd areas  = law.area_increments(forces, weights, sliding);
  const Eigen::VectorXd slopes = law.area_derivatives(forces, weights, sliding);
  const Eigen::ArrayXd  expected = k * weights.array() / std::sqrt(2e6) *
                                  pressures.array().pow(1.5) * 9. * 0.01;
  const double area_error =
    (areas.array() - expected).abs().maxCoeff() / expected.maxCoeff();
  const double slope_error =
    (slopes.array() * forces.array() - 1.5 * expected).abs().maxCoeff() /
    expected.maxCoeff();
  std::cout << "power of the pressure: area right to 1e-12: "
            << (area_error < 1e-12)
            << ", derivative right to 1e-8: " << (slope_error < 1e-8)
            << std::endl;
}

void
test_running_in()
{
  const double initial = 5., s_0 = 30., per_cycle = 0.06, end = 4000.;
  const double distance = end * per_cycle;
  const double expected =
    k * forces.sum() *
    (distance + (initial - 1.) * s_0 * (1. - std::exp(-distance / s_0)));
  for (const CoefficientFactor &factor :
       {CoefficientFactor(RunningIn{initial, s_0}),
        CoefficientFactor(FactorExpression("factor", "1 + 4*exp(-s/30)"))})
    {
      const WearLaw law{{k}, {factor}};
      const auto    rate = [&](const double cycles) {
        return law.area_increments(forces,
                                   weights,
                                   {per_cycle, 0.1, cycles * per_cycle});
      };
      const WearEquation    equation{[&](const double           cycles,
                                      const Eigen::VectorXd &a,
                                      const double           gamma,
                                      const Eigen::VectorXd &) {
                                    return std::optional<Eigen::VectorXd>(
                                      a + gamma * rate(cycles));
                                  },
                                  {},
                                  0};
      constexpr double      tolerance = 1e-4;
      ImplicitExtrapolation integrator(equation, tolerance);
      const Eigen::VectorXd scale = Eigen::VectorXd::Constant(5, 1. / expected);
      integrator.start(0., Eigen::VectorXd::Zero(5), rate(0.), scale);
      // Every step may err by the tolerance, and all err to the same side.
      unsigned int n_steps = 0;
      while (integrator.cycles() < end)
        {
          integrator.step(end);
          ++n_steps;
        }
      const double error = integrator.state().sum() / expected - 1.;
      std::cout << "running-in: removed area right to the tolerance per step: "
                << (std::abs(error) < n_steps * tolerance) << std::endl;
    }
}

void
test_product()
{
  const WearLaw         law{{k},
                    {FactorExpression("factor", "2 + sin(p/1e6) + v*s"),
                             RunningIn{3., 10.}}};
  const Sliding         sliding{0.01, 0.3, 7.};
  constexpr double      step = 1e-4;
  const Eigen::VectorXd difference =
    (law.area_increments((1. + step) * forces, weights, sliding) -
     law.area_increments((1. - step) * forces, weights, sliding)) /
    (2. * step);
  const Eigen::VectorXd slopes =
    law.area_derivatives(forces, weights, sliding).cwiseProduct(forces);
  std::cout << "product: derivative right to 1e-7: "
            << ((slopes - difference).lpNorm<Eigen::Infinity>() <
                1e-7 * slopes.maxCoeff())
            << std::endl;

  const WearLaw archard{{k}, {}};
  std::cout << "no factor: constant " << archard.is_constant()
            << ", Archard's area "
            << (archard.area_increments(forces, weights, sliding) ==
                k * 0.01 * forces)
            << std::endl;
}

int
main()
{
  test_power();
  test_running_in();
  test_product();

  for (const std::string expression : {"1 - p/1e6", "1/(p - 3e6)", "2*q"})
    try
      {
        const WearLaw law{{k}, {FactorExpression("factor", expression)}};
        law.area_increments(forces, weights, {0.01, 0.3, 7.});
        std::cout << "NO EXCEPTION" << std::endl;
      }
    catch (const ExcRun &exception)
      {
        std::cout << message_of(exception) << std::endl;
      }
    catch (const ExcParameter &exception)
      {
        std::cout << message_of(exception) << std::endl;
      }
}

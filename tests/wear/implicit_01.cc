// SPDX-License-Identifier: LGPL-2.1-or-later

// Implicit cycle jumps against a closed form: dh/dN = -A (h - b N) with a stiff
// matrix A (eigenvalues 1e-4 to 1, symmetric), whose solution from h = 0 is
// h = b N - A^-1 b (1 - exp(-A N)). The error stays below the tolerance and
// falls with it, with few steps where explicit ones would need thousands, and
// an event (the largest depth passes a limit) is found where the closed form
// has it. That is so, too, if stages are solved to a part only (to 1e-4 of what
// they change, now more, now less, as iterations do that begin elsewhere), or
// if a solution is not found at the first attempt, so that a step becomes
// shorter than asked for: the place is then as good as the solutions, the limit
// is still met. An exception in a function of the equation comes through.

#include <Eigen/Dense>

#include <tribody/base/exceptions.h>
#include <tribody/wear/implicit_extrapolation.h>

#include <cmath>
#include <iostream>
#include <optional>

using namespace Tribody;
using namespace Tribody::Wear;

namespace
{
  constexpr Eigen::Index n = 8;

  // Symmetric, with the given eigenvalues and the eigenvectors of a cosine
  // transform.
  struct Problem
  {
    Eigen::VectorXd eigenvalues{n};
    Eigen::MatrixXd vectors{n, n};
    Eigen::VectorXd load{n};

    Problem()
    {
      for (Eigen::Index i = 0; i < n; ++i)
        {
          eigenvalues[i] = std::pow(10., -4. + 4. * i / (n - 1));
          load[i]        = 1e-9 * (1. + 0.1 * i);
          for (Eigen::Index j = 0; j < n; ++j)
            vectors(j, i) = std::sqrt((i == 0 ? 1. : 2.) / n) *
                            std::cos(M_PI * i * (j + 0.5) / n);
        }
    }

    Eigen::MatrixXd
    matrix() const
    {
      return vectors * eigenvalues.asDiagonal() * vectors.transpose();
    }

    Eigen::VectorXd
    depth(const double cycles) const
    {
      Eigen::VectorXd modes = vectors.transpose() * load;
      for (Eigen::Index i = 0; i < n; ++i)
        modes[i] *=
          cycles + std::expm1(-eigenvalues[i] * cycles) / eigenvalues[i];
      return vectors * modes;
    }
  };



  // The last entry of y is the number of cycles, left out of the error test.
  WearEquation
  make_equation(const Problem &problem, const double limit)
  {
    return {[&problem](const double,
                       const Eigen::VectorXd &a,
                       const double           gamma,
                       const Eigen::VectorXd &) {
              Eigen::VectorXd y(n + 1);
              y[n] = a[n] + gamma;
              y.head(n) =
                (Eigen::MatrixXd::Identity(n, n) + gamma * problem.matrix())
                  .ldlt()
                  .solve(a.head(n) +
                         gamma * y[n] * problem.matrix() * problem.load);
              return std::optional<Eigen::VectorXd>(y);
            },
            [limit](const Eigen::VectorXd &y) {
              return Eigen::VectorXd(
                Eigen::VectorXd::Constant(1,
                                          y.head(n).maxCoeff() / limit - 1.));
            },
            1};
  }
} // namespace

int
main()
{
  const Problem problem;
  const double  end = 20000.;

  // Relative to the largest depth at the end; the number of cycles does not
  // count.
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(n + 1);
  weights.head(n).setConstant(1. / problem.depth(end).maxCoeff());
  Eigen::VectorXd first_rate = Eigen::VectorXd::Zero(n + 1);
  first_rate[n]              = 1.;

  double previous_error = 1.;
  for (const double tolerance : {1e-2, 1e-3, 1e-4})
    {
      ImplicitExtrapolation integrator(make_equation(problem, 1.), tolerance);
      integrator.start(0., Eigen::VectorXd::Zero(n + 1), first_rate, weights);
      unsigned int n_steps = 0;
      while (integrator.cycles() < end)
        {
          integrator.step(end);
          ++n_steps;
        }
      const Eigen::VectorXd exact = problem.depth(end);
      const double          error =
        (integrator.state().head(n) - exact).lpNorm<Eigen::Infinity>() /
        exact.maxCoeff();
      std::cout << "tolerance " << tolerance
                << ": ends at the cycle asked for: "
                << (integrator.cycles() == end)
                << ", error below it: " << (error < tolerance)
                << ", smaller than before: " << (error < previous_error)
                << ", steps below 100: " << (n_steps < 100) << std::endl;
      previous_error = error;
    }

  // Stop where the largest depth passes the value that the closed form has at
  // 5000 cycles: at the value itself, whatever the tolerance, and at the cycle
  // as exactly as the tolerance says.
  for (const double tolerance : {1e-4, 1e-7})
    {
      const double          limit = problem.depth(5000.).maxCoeff();
      ImplicitExtrapolation integrator(make_equation(problem, limit),
                                       tolerance);
      integrator.start(0., Eigen::VectorXd::Zero(n + 1), first_rate, weights);
      bool stopped = false;
      while (!stopped && integrator.cycles() < end)
        stopped = integrator.step(end);
      const double error = integrator.state().head(n).maxCoeff() / limit - 1.;
      std::cout << "tolerance " << tolerance << ": event found: " << stopped
                << ", to 1e-9: " << (std::abs(error) < 1e-9)
                << ", within ten tolerances of its place: "
                << (std::abs(integrator.cycles() / 5000. - 1.) <
                    10. * tolerance)
                << std::endl;
    }

  for (const bool fails : {false, true})
    {
      const double       limit    = problem.depth(5000.).maxCoeff();
      WearEquation       equation = make_equation(problem, limit);
      const WearEquation exact    = equation;
      unsigned int       n_calls  = 0;
      equation.solve_stage        = [&](const double           cycles,
                                 const Eigen::VectorXd &a,
                                 const double           gamma,
                                 const Eigen::VectorXd &guess) {
        auto y = exact.solve_stage(cycles, a, gamma, guess);
        ++n_calls;
        if (fails && n_calls % 23 == 0)
          y.reset();
        else if (!fails)
          *y += 1e-4 * std::sin(1. * n_calls) * (*y - a);
        return y;
      };
      ImplicitExtrapolation integrator(equation, 1e-3);
      integrator.start(0., Eigen::VectorXd::Zero(n + 1), first_rate, weights);
      bool stopped = false;
      while (!stopped && integrator.cycles() < end)
        stopped = integrator.step(end);
      const double error = integrator.state().head(n).maxCoeff() / limit - 1.;
      std::cout << (fails ? "stages that fail: " : "stages solved to 1e-4: ")
                << "event found: " << stopped
                << ", to 1e-9: " << (std::abs(error) < 1e-9)
                << ", within 1 % of its place: "
                << (std::abs(integrator.cycles() / 5000. - 1.) < 1e-2)
                << std::endl;
    }

  WearEquation broken = make_equation(problem, 1.);
  broken.solve_stage =
    [](const double,
       const Eigen::VectorXd &,
       const double,
       const Eigen::VectorXd &) -> std::optional<Eigen::VectorXd> {
    throw ExcRun("no rate today");
  };
  try
    {
      ImplicitExtrapolation integrator(broken, 5e-3);
      integrator.start(0., Eigen::VectorXd::Zero(n + 1), first_rate, weights);
      integrator.step(end);
      std::cout << "NO EXCEPTION" << std::endl;
    }
  catch (const ExcRun &exception)
    {
      std::cout << message_of(exception) << std::endl;
    }
}

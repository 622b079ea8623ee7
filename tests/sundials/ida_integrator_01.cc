// SPDX-License-Identifier: LGPL-2.1-or-later

// Zeros that the integration does not leave at once. y' = 1, y(0) = 0, and a
// root function that rises to zero at y = 1 and stays there until y = 2, like a
// gap that closes to rounding only. Known: IDA finds a zero at the end of the
// first step beyond t = 1, at most 0.1 long, once, and goes on to t = 3 with
// y = t, which BDF integrates exactly, to the roundings of some 100 steps.

#include <tribody/sundials/ida_integrator.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace Tribody;
using namespace Tribody::Sundials;

int
main()
{
  ImplicitSystem system;
  system.residual = [](const double,
                       const ImplicitSystem::ConstVector &,
                       const ImplicitSystem::ConstVector &y_t,
                       ImplicitSystem::Vector &F) { F[0] = y_t[0] - 1.; };
  system.jacobian = [](const double,
                       const double c,
                       const ImplicitSystem::ConstVector &,
                       const ImplicitSystem::ConstVector &,
                       MatrixEntries &entries) { entries.add(0, 0, c); };
  system.n_roots  = 1;
  system.roots =
    [](const double, const ImplicitSystem::ConstVector &y, double *g) {
      g[0] = std::min(y[0] - 1., 0.) + std::max(y[0] - 2., 0.);
    };

  IdaSettings settings;
  settings.relative_tolerance  = 1e-6;
  settings.absolute_tolerances = Eigen::VectorXd::Constant(1, 1e-6);
  settings.is_differential     = Eigen::VectorXd::Ones(1);
  settings.maximum_step        = 0.1;

  IdaIntegrator integrator(system, settings);
  integrator.start(0., Eigen::VectorXd::Zero(1), Eigen::VectorXd::Ones(1));
  while (integrator.time() < 3.)
    {
      const auto roots = integrator.step(4.);
      if (roots[0] != 0)
        std::cout << "zero found, at most 0.1 beyond 1: "
                  << (std::abs(integrator.time() - 1.05) <= 0.05) << '\n';
    }
  std::cout << "y is t to 1e-12: "
            << (std::abs(integrator.solution()[0] / integrator.time() - 1.) <
                1e-12)
            << '\n';
}

// SPDX-License-Identifier: LGPL-2.1-or-later

// Wear laws that have closed forms.
//
// Crescent: the depth is checked by differences of the sliding distance
// against dh/ds = k F/[R L (t + sin 2t/2)]; the volume against k times the
// integral of pressure over area and distance, with the pressure
// p = F cos(angle)/[R L (t + sin 2t/2)], integrated here by the midpoint rule
// (error about 1e-7 with 2000 points); integral of p dA / F tends to 4/pi.
//
// Profile: the area that the law removes is what the curve loses; the
// difference is of second order in the step, so its rate is 2.
//
// Explicit steps: below max_stable_step() the linear problem
// dh/dN = -k s D^-1 C^-1 h decays, above it grows, since the bound is sharp
// when all nodes are in contact.
//
// Oscillation: a sawtooth of amplitude a gives a, whatever smooth field it
// rides on.

#include <Eigen/Dense>

#include <tribody/wear/archard_law.h>
#include <tribody/wear/constant_extrapolation.h>
#include <tribody/wear/crescent.h>
#include <tribody/wear/wear_profile.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace Tribody;
using namespace Tribody::Wear;

void
test_crescent()
{
  // The validation joint of Mukras et al. with 60 N.
  const Crescent crescent{9.535e-3, 10e-6, 8.6e-3, 5.05e-13, 60.};

  double rate_error = 0., inverse_error = 0.;
  for (const double depth : {1e-7, 1e-5, 1e-4, 4.5e-4})
    {
      const double step = 1e-3 * depth;
      const double t =
        std::acos(crescent.clearance / (depth + crescent.clearance));
      const double rate = 2. * step /
                          (crescent.sliding_distance(depth + step) -
                           crescent.sliding_distance(depth - step));
      const double expected =
        crescent.wear_coefficient * crescent.normal_force /
        (crescent.radius * crescent.axial_length * (t + 0.5 * std::sin(2 * t)));
      rate_error = std::max(rate_error, std::abs(rate / expected - 1.));
      inverse_error =
        std::max(inverse_error,
                 std::abs(crescent.depth(crescent.sliding_distance(depth)) /
                            depth -
                          1.));
    }
  // The difference quotient's own error is of order 1e-6.
  std::cout << "crescent: rate right to 1e-5: " << (rate_error < 1e-5)
            << ", inverse right to 1e-9: " << (inverse_error < 1e-9)
            << std::endl;

  const double distance = crescent.sliding_distance(4.5e-4);
  const int    n        = 2000;
  double       volume = 0., last_ratio = 0.;
  for (int i = 0; i < n; ++i)
    {
      // Points that crowd at the start, where the depth grows fastest.
      const double x = (i + 0.5) / n, ds = 2. * x * distance / n;
      const double h = crescent.depth(x * x * distance);
      const double t = std::acos(crescent.clearance / (h + crescent.clearance));
      last_ratio     = 2. * std::sin(t) / (t + 0.5 * std::sin(2. * t));
      volume +=
        crescent.wear_coefficient * crescent.normal_force * last_ratio * ds;
    }
  std::cout << "crescent: volume right to 1e-5: "
            << (std::abs(crescent.volume(4.5e-4) / volume - 1.) < 1e-5)
            << ", pressure over force " << std::setprecision(3) << last_ratio
            << " (4/pi = " << 4. / M_PI << ")" << std::endl;
}

void
test_profile()
{
  const unsigned int n = 120;
  Eigen::Matrix2Xd   directions(2, n);
  for (unsigned int i = 0; i < n; ++i)
    directions.col(i) << std::cos(2. * M_PI * i / n),
      std::sin(2. * M_PI * i / n);

  double error[2];
  for (unsigned int level = 0; level < 2; ++level)
    {
      WearProfile profile = make_wear_profile(directions, directions, 2);
      for (unsigned int i = 0; i < n; ++i)
        profile.depth[i] = 0.05 * std::max(0., directions(0, i));
      const BoreSurface before = profile.surface();

      const ArchardLaw archard{1e-3};
      Eigen::VectorXd  removed(n);
      for (unsigned int i = 0; i < n; ++i)
        removed[i] = archard.area_increment(std::max(0., directions(1, i)),
                                            level == 0 ? 1. : 0.5);
      profile.depth += profile.depth_for_removed_area(before, removed);
      error[level] = std::abs(profile.surface().enclosed_area -
                              before.enclosed_area - removed.sum());
    }
  std::cout << "profile: rate of the volume defect " << std::fixed
            << std::setprecision(2) << std::log2(error[0] / error[1]);

  // With the derivative at the mean depth there is no defect but round-off.
  WearProfile profile = make_wear_profile(directions, directions, 2);
  for (unsigned int i = 0; i < n; ++i)
    profile.depth[i] = 0.05 * std::max(0., directions(0, i));
  Eigen::VectorXd removed(n);
  for (unsigned int i = 0; i < n; ++i)
    removed[i] = 5e-3 * std::max(0., directions(1, i));
  const double before = profile.surface().enclosed_area;
  profile.depth       = profile.depth_after_removing(removed);
  std::cout << ", exact update right to 1e-12: "
            << (std::abs((profile.surface().enclosed_area - before) /
                           removed.sum() -
                         1.) < 1e-12)
            << std::endl;
}

void
test_stability()
{
  const unsigned int n = 40;
  Eigen::MatrixXd    compliance(n, n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      compliance(i, j) = 1. / (1. + std::abs(double(i) - double(j)));
  const Eigen::VectorXd weights = Eigen::VectorXd::LinSpaced(n, 1., 2.);
  const double          step    = max_stable_step(compliance, weights, 3.);

  for (const double factor : {0.99, 1.01})
    {
      Eigen::VectorXd h = Eigen::VectorXd::Ones(n);
      h[3]              = 2.;
      const Eigen::LLT<Eigen::MatrixXd> factored(compliance);
      const double                      start = h.norm();
      for (unsigned int i = 0; i < 2000; ++i)
        h -= factor * step * 3. * factored.solve(h).cwiseQuotient(weights);
      std::cout << "explicit steps of " << factor << " times the bound "
                << (h.norm() < start ? "decay" : "grow") << std::endl;
    }

  const ConstantExtrapolation steps{30.};
  std::cout << "last of the steps to 100: " << steps.next_step(90., 100.)
            << ", one before: " << steps.next_step(60., 100.) << std::endl;

  // dh/dN = -h/T by Euler steps to N = T: the depth that is lost, 1 - 1/e,
  // comes out too large by about half a step's worth.
  Eigen::VectorXd depth = Eigen::VectorXd::Zero(1);
  double          error = 0.;
  const double    dt    = 0.01;
  for (unsigned int i = 0; i < 100; ++i)
    {
      const Eigen::VectorXd before = Eigen::VectorXd::Ones(1) - depth;
      depth += dt * before;
      error += euler_error(before, Eigen::VectorXd::Ones(1) - depth, dt)[0];
    }
  const double exact = 1. - std::exp(-1.);
  std::cout << "error estimate over true error between 1 and 3: "
            << (std::abs(error) > std::abs(depth[0] - exact) &&
                std::abs(error) < 3. * std::abs(depth[0] - exact))
            << std::endl;
}

void
test_oscillation()
{
  Eigen::VectorXd values(360);
  for (int i = 0; i < 360; ++i)
    values[i] = std::max(0., std::cos(M_PI * (i - 180) / 180.));
  std::cout << "smooth field, oscillation below 1e-6: "
            << (mesh_oscillation(values) < 1e-6);
  for (const double amplitude : {0.01, 2.})
    {
      Eigen::VectorXd sawtooth = values;
      // The larger one is cut off at zero, as a pressure is.
      for (int i = 120; i < 240; ++i)
        sawtooth[i] =
          std::max(0., values[i] + (i % 2 == 0 ? amplitude : -amplitude));
      std::cout << "; with a sawtooth of " << amplitude << ": "
                << mesh_oscillation(sawtooth);
    }
  // Where the contacts of many instants end at one place, the field jumps, or
  // peaks in a single node.
  Eigen::VectorXd edge = values;
  edge.segment(150, 60) += Eigen::VectorXd::Constant(60, 0.5);
  edge[150] += 0.5;
  std::cout << "; with a jump and a peak below 1e-6: "
            << (mesh_oscillation(edge) < 1e-6) << std::endl;
}

int
main()
{
  test_crescent();
  test_profile();
  test_stability();
  test_oscillation();
}

// SPDX-License-Identifier: LGPL-2.1-or-later

// Motions whose distance from the one that repeats is known: x_n = x + c mu^n.
// What is told is that distance over |mu|, or the last change if that is more;
// noise is as far as it changes.

#include <tribody/multibody/cycle/settling_monitor.h>

#include <cmath>
#include <complex>
#include <iostream>
#include <random>

using namespace Tribody::Multibody;

namespace
{
  constexpr int n = 200;

  // What repeats is 5 cos(k), what is left a vector that turns.
  RepeatingQuantity
  quantity(const std::complex<double> left)
  {
    RepeatingQuantity result{Eigen::Matrix2Xd(2, n), 5.};
    for (int k = 0; k < n; ++k)
      {
        const auto now = left * std::exp(std::complex<double>(0., 0.3 * k));
        result.values.col(k) << 5. * std::cos(k) + now.real(), now.imag();
      }
    return result;
  }



  void
  decay(const char *name, const std::complex<double> mu)
  {
    SettlingMonitor      monitor;
    std::complex<double> left = 2.;
    for (int cycle = 0; cycle < 6; ++cycle)
      {
        left *= mu;
        monitor.add({quantity(left)});
      }
    const double true_distance = std::abs(left) / 5.;
    const double expected =
      std::max(1., std::abs(mu - 1.)) / std::abs(mu) * true_distance;
    std::cout << name << ": as expected "
              << (std::abs(monitor.distance() / expected - 1.) < 1e-9)
              << ", decays " << (std::abs(monitor.decay() - mu.real()) < 1e-9)
              << std::endl;
  }
} // namespace

int
main()
{
  decay("slow", 0.99);
  decay("fast", 0.1);
  decay("alternating", -0.9);
  decay("slow and turning", std::polar(0.98, 0.5));
  decay("half a turn", std::polar(0.95, 3.));
  decay("growing", 1.1);

  SettlingMonitor unknown;
  unknown.add({quantity(1.)});
  std::cout << "one cycle: infinite " << std::isinf(unknown.difference());
  unknown.add({quantity(0.9)});
  std::cout << "; two: change 0.02 "
            << (std::abs(unknown.difference() - 0.02) < 1e-9) << ", distance "
            << unknown.distance() << std::endl;

  std::mt19937                     engine(1);
  std::normal_distribution<double> normal(0., 1e-3);
  SettlingMonitor                  noise;
  double                           most = 0.;
  for (int cycle = 0; cycle < 20; ++cycle)
    {
      RepeatingQuantity x = quantity(0.);
      for (int k = 0; k < n; ++k)
        x.values(0, k) += normal(engine);
      noise.add({x});
      if (cycle > 1)
        most = std::max(most, noise.distance() / noise.difference());
    }
  // The correlation of n such changes is -1/2, give or take 1/sqrt(n).
  std::cout << "noise: as far as it changes " << (most == 1.) << std::endl;
}

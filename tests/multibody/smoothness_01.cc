// SPDX-License-Identifier: LGPL-2.1-or-later

// Jumps and kinks of functions of time, whose places and kinds are known, are
// found; functions with a continuous derivative have none, however fast they
// are within a thousandth of the interval.

#include <tribody/multibody/elements/smoothness.h>

#include <cmath>
#include <iostream>

using namespace Tribody::Multibody;

namespace
{
  template <typename Function>
  void
  report(const char *name, const Function &function, const double known)
  {
    const auto found = find_roughness(function, 0., 2.);
    std::cout << name << ": ";
    if (!found)
      std::cout << "smooth";
    else
      std::cout << (found->is_jump ? "jump" : "kink") << ", at the known time "
                << (std::abs(found->time - known) < 1e-6);
    std::cout << std::endl;
  }
} // namespace

int
main()
{
  const double t_0 = 0.7321;
  report(
    "constant", [](const double) { return 3.; }, 0.);
  report(
    "linear", [](const double t) { return 1e3 * t; }, 0.);
  report(
    "sine", [](const double t) { return std::sin(20. * t); }, 0.);
  report(
    "fast pulse",
    [&](const double t) { return std::exp(-std::pow((t - t_0) / 2e-3, 2)); },
    0.);
  report(
    "parabola that begins",
    [&](const double t) { return t < t_0 ? 0. : std::pow(t - t_0, 2); },
    0.);
  report(
    "step", [&](const double t) { return t < t_0 ? 0. : 1.; }, t_0);
  report(
    "stop", [&](const double t) { return t < t_0 ? t : t_0; }, t_0);
  report(
    "small kink on a sine",
    [&](const double t) { return std::sin(3. * t) + 0.01 * std::abs(t - t_0); },
    t_0);
  report(
    "triangle", [](const double t) { return std::abs(t - 0.5); }, 0.5);
}

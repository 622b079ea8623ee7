// SPDX-License-Identifier: LGPL-2.1-or-later

// Periodic functions from tables. Known: a linear table is exact for straight
// lines and has an error of h^2/8 |f''| for a sine; a cubic spline goes through
// its rows, its error for equal steps is h^4/384 |f''''|, that of its slope
// sqrt(3)/216 h^3 |f''''| and that of its second derivative h^2/12 |f''''|
// (largest values of Bernoulli's polynomials); unequal steps leave these
// powers. Value, slope and second derivative are continuous everywhere, also
// where the period ends, and derivatives are those of central differences.

#include <tribody/tables/periodic_table.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>

using namespace Tribody;

namespace
{
  constexpr double period = 0.7, start = -0.2, omega = 2. * M_PI / period;

  double
  sine(const double t)
  {
    return std::sin(omega * t + 0.3);
  }

  double
  slope(const double t)
  {
    return omega * std::cos(omega * t + 0.3);
  }

  double
  curvature(const double t)
  {
    return -omega * omega * sine(t);
  }

  struct Errors
  {
    double value = 0., slope = 0., curvature = 0.;
  };

  // @param skew how unequal the steps are, smoothly distributed.
  PeriodicTable
  make_table(const unsigned int       n,
             const double             skew,
             const TableInterpolation interpolation)
  {
    Eigen::VectorXd times(n + 1), values(n + 1);
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double x = static_cast<double>(i) / n;
        times[i]       = start + period * (x + skew * std::sin(2. * M_PI * x));
        values[i]      = sine(times[i]);
      }
    times[n]  = start + period;
    values[n] = values[0];
    return {times, values, interpolation};
  }

  // Largest errors in three periods.
  Errors
  measure(const PeriodicTable &table)
  {
    Errors                 errors;
    constexpr unsigned int n = 9973;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double t             = -1. + 3. * period * i / n;
        const auto [first, second] = table.derivatives(t);
        errors.value =
          std::max(errors.value, std::abs(table.value(t) - sine(t)));
        errors.slope =
          std::max(errors.slope, std::abs(first - slope(t)) / omega);
        errors.curvature =
          std::max(errors.curvature,
                   std::abs(second - curvature(t)) / (omega * omega));
      }
    return errors;
  }

  double
  order(const double coarse, const double fine)
  {
    return std::log2(coarse / fine);
  }

  void
  converge(const double skew)
  {
    Errors before;
    for (unsigned int n = 16; n <= 256; n *= 2)
      {
        const Errors errors =
          measure(make_table(n, skew, TableInterpolation::cubic));
        if (n > 64)
          std::cout << "cubic, skew " << skew << ", " << n
                    << " rows: orders of value, slope, second derivative "
                    << std::setprecision(2) << order(before.value, errors.value)
                    << ' ' << order(before.slope, errors.slope) << ' '
                    << order(before.curvature, errors.curvature) << std::endl;
        before = errors;
      }
  }
} // namespace

int
main()
{
  const double h = omega * period / 128;
  const Errors linear =
    measure(make_table(128, 0., TableInterpolation::linear));
  const Errors cubic = measure(make_table(128, 0., TableInterpolation::cubic));
  std::cout << "errors over those of the theory, linear: "
            << std::setprecision(2) << linear.value / (h * h / 8.)
            << ", cubic: " << cubic.value / (std::pow(h, 4) / 384.) << ' '
            << cubic.slope / (std::sqrt(3.) / 216. * std::pow(h, 3)) << ' '
            << cubic.curvature / (h * h / 12.) << std::endl;
  converge(0.);
  converge(0.1);

  // A saw: straight lines between unequal rows, many periods away too.
  const PeriodicTable saw(Eigen::Vector4d(1., 1.1, 1.75, 3.),
                          Eigen::Vector4d(2., -1., 0.3, 2.),
                          TableInterpolation::linear);
  double              error = 0.;
  for (int k = -5; k <= 5; ++k)
    {
      error = std::max(error, std::abs(saw.value(1.05 + 2. * k) - 0.5));
      error = std::max(error, std::abs(saw.value(1.425 + 2. * k) + 0.35));
      error =
        std::max(error, std::abs(saw.derivatives(2. + 2. * k)[0] - 1.7 / 1.25));
      error = std::max(error, std::abs(saw.derivatives(2. + 2. * k)[1]));
      error = std::max(error, std::abs(saw.value(3. + 2. * k) - 2.));
    }
  std::cout << "linear, error of straight lines: "
            << (error < 1e-13 ? "none" : "WRONG") << ", period " << saw.period()
            << " s" << std::endl;

  // Through the rows and smooth there, the end of the period included; the
  // steps differ by a factor of twelve.
  const Eigen::VectorXd times  = Eigen::Vector4d(1., 1.1, 1.75, 3.);
  const Eigen::VectorXd values = Eigen::Vector4d(2., -1., 0.3, 2.);
  const PeriodicTable   spline(times, values, TableInterpolation::cubic);
  double                jump = 0., miss = 0., difference = 0.;
  for (Eigen::Index i = 0; i < times.size(); ++i)
    for (const double turns : {-3., 0., 1.})
      {
        const double t = times[i] + turns * spline.period(), step = 1e-9;
        const auto   left = spline.derivatives(t - step),
                   right  = spline.derivatives(t + step);
        miss = std::max(miss, std::abs(spline.value(t) - values[i]));
        // Over two steps the second derivative of some 1e3 changes the slope
        // by 1e-6 and itself by about as much.
        jump = std::max(
          {jump,
           std::abs(spline.value(t + step) - spline.value(t - step)) * 1e-2,
           std::abs(right[0] - left[0]) * 1e-2,
           std::abs(right[1] - left[1]) * 1e-3});
      }
  for (double t = 0.; t < 4.; t += 0.0371)
    {
      const double step = 1e-6;
      const double first =
        (spline.value(t + step) - spline.value(t - step)) / (2. * step);
      const double second =
        (spline.derivatives(t + step)[0] - spline.derivatives(t - step)[0]) /
        (2. * step);
      difference =
        std::max({difference,
                  std::abs(first - spline.derivatives(t)[0]),
                  std::abs(second - spline.derivatives(t)[1]) / 1e3});
    }
  std::cout << "cubic, misses its rows: " << (miss < 1e-13 ? "no" : "YES")
            << ", jumps: " << (jump < 1e-7 ? "no" : "YES")
            << ", derivatives by differences: "
            << (difference < 1e-6 ? "right" : "WRONG") << std::endl;

  // What comes again at once is constant.
  const PeriodicTable constant(Eigen::Vector2d(0., 1.),
                               Eigen::Vector2d(5., 5.),
                               TableInterpolation::cubic);
  std::cout << "constant: " << constant.value(0.3) << ' '
            << constant.derivatives(-7.1)[0] << ' '
            << constant.derivatives(0.)[1] << std::endl;
}

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>
#include <boost/math/interpolators/makima.hpp>

#include <tribody/surface/periodic_profile.h>

#include <cmath>
#include <vector>

namespace Tribody
{
  namespace
  {
    // The periodic continuation on each side of the turn. The influence of
    // the end conditions on a cubic spline falls by 0.27 from node to node.
    constexpr int n_padding = 24;

    // Values on an equidistant grid of one turn that starts at angles(0).
    std::vector<double>
    equidistant_values(const Eigen::VectorXd &angles,
                       const Eigen::VectorXd &values)
    {
      const int    n       = angles.size();
      const double spacing = 2. * dealii::numbers::PI / n;
      bool         is_even = true;
      for (int i = 0; i < n; ++i)
        is_even =
          is_even && std::abs(angles(i) - angles(0) - i * spacing) < 1e-9;
      if (is_even)
        return {values.data(), values.data() + n};

      constexpr int       wrap = 4;
      std::vector<double> x, y;
      for (int i = -wrap; i < n + wrap; ++i)
        {
          const int turn = (i < 0) ? -1 : i / n;
          x.push_back(angles(i - turn * n) + turn * 2. * dealii::numbers::PI);
          y.push_back(values(i - turn * n));
        }
      const boost::math::interpolators::makima<std::vector<double>> curve(
        std::move(x), std::move(y));

      std::vector<double> result(4 * n);
      for (int i = 0; i < 4 * n; ++i)
        result[i] = curve(angles(0) + i * 2. * dealii::numbers::PI / (4 * n));
      return result;
    }
  } // namespace



  struct PeriodicProfile::Spline
  {
    Spline(const std::vector<double> &values, const double origin)
      : n_nodes(values.size())
      , origin(origin)
      , curve(make_curve(values))
    {}

    static boost::math::interpolators::cardinal_cubic_b_spline<double>
    make_curve(const std::vector<double> &values)
    {
      const int           n       = values.size();
      const double        spacing = 2. * dealii::numbers::PI / n;
      std::vector<double> padded(n + 2 * n_padding + 1);
      const auto          periodic = [&](const int i) {
        return values[((i % n) + n) % n];
      };
      for (int i = 0; i < static_cast<int>(padded.size()); ++i)
        padded[i] = periodic(i - n_padding);
      const auto slope = [&](const int i) {
        return (periodic(i + 1) - periodic(i - 1)) / (2 * spacing);
      };
      return {padded.data(),
              padded.size(),
              -n_padding * spacing,
              spacing,
              slope(-n_padding),
              slope(n + n_padding)};
    }

    // The argument of the curve, in [0, 2 pi).
    double
    reduced(const double angle) const
    {
      const double x = angle - origin;
      return x - 2. * dealii::numbers::PI *
                   std::floor(x / (2. * dealii::numbers::PI));
    }

    unsigned int                                                n_nodes;
    double                                                      origin;
    boost::math::interpolators::cardinal_cubic_b_spline<double> curve;
  };



  PeriodicProfile::PeriodicProfile(const double value)
    : the_mean(value)
  {}



  PeriodicProfile::PeriodicProfile(const Eigen::VectorXd &angles,
                                   const Eigen::VectorXd &values)
  {
    Assert(angles.size() == values.size() && angles.size() >= 4,
           dealii::ExcMessage("A profile needs at least four points."));
    const std::vector<double> equidistant = equidistant_values(angles, values);
    the_mean =
      Eigen::Map<const Eigen::VectorXd>(equidistant.data(), equidistant.size())
        .mean();
    spline = std::make_shared<const Spline>(equidistant, angles(0));
  }



  unsigned int
  PeriodicProfile::n_nodes() const
  {
    return spline ? spline->n_nodes : 0;
  }



  // Of an angle that is not finite the curve would make an exception of
  // Boost's. Such are steps of an integration or of Newton's method that are
  // tried, found to be too long and taken again.
  double
  PeriodicProfile::value(const double angle) const
  {
    if (!spline)
      return the_mean;
    return std::isfinite(angle) ? spline->curve(spline->reduced(angle))
                                : std::nan("");
  }



  PeriodicProfile::Values
  PeriodicProfile::evaluate(const double angle) const
  {
    if (!spline)
      return {the_mean, 0., 0.};
    if (!std::isfinite(angle))
      return {std::nan(""), std::nan(""), std::nan("")};
    const double x = spline->reduced(angle);
    return {spline->curve(x),
            spline->curve.prime(x),
            spline->curve.double_prime(x)};
  }
} // namespace Tribody

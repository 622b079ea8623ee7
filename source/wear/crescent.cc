// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <tribody/wear/crescent.h>

#include <cmath>

namespace Tribody
{
  namespace Wear
  {
    namespace
    {
      double
      half_angle(const double depth, const double clearance)
      {
        return std::acos(clearance / (depth + clearance));
      }
    } // namespace



    double
    Crescent::sliding_distance(const double depth) const
    {
      Assert(clearance > 0., dealii::ExcMessage("no clearance"));

      // With the half-angle t as the variable, dh = c sin t / cos^2 t dt, the
      // integrand is smooth where the depth starts like a power.
      const auto integrand = [this](const double t) {
        return (t + 0.5 * std::sin(2. * t)) * clearance * std::sin(t) /
               (std::cos(t) * std::cos(t));
      };
      const double integral =
        boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
          integrand, 0., half_angle(depth, clearance), 15, 1e-12);
      return radius * axial_length / (wear_coefficient * normal_force) *
             integral;
    }



    double
    Crescent::depth(const double distance) const
    {
      if (!(distance > 0.) || !(normal_force > 0.) || !(wear_coefficient > 0.))
        return 0.;

      // t + sin(2t)/2 is at most pi/2 and at least its value at the depth
      // reached, which bounds the depth from below and lets the upper end grow
      // until it holds.
      double lower = 2. * wear_coefficient * normal_force * distance /
                     (dealii::numbers::PI * radius * axial_length);
      double upper = 2. * lower + clearance;
      while (sliding_distance(upper) < distance)
        upper *= 2.;

      boost::uintmax_t max_iterations = 100;
      const auto       bracket        = boost::math::tools::toms748_solve(
        [&](const double h) { return sliding_distance(h) - distance; },
        lower,
        upper,
        boost::math::tools::eps_tolerance<double>(40),
        max_iterations);
      return 0.5 * (bracket.first + bracket.second);
    }



    double
    Crescent::volume(const double depth) const
    {
      const double t = half_angle(depth, clearance);
      return axial_length * radius *
             (2. * (depth + clearance) * std::sin(t) - 2. * clearance * t);
    }
  } // namespace Wear
} // namespace Tribody

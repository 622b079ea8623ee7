// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <tribody/multibody/joints/wear_spread.h>

#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      constexpr double turn = 2. * dealii::numbers::PI;
    } // namespace



    WearSpread::WearSpread(const double reach)
      : reach(reach)
    {
      // Six angles within the reach to either side.
      const int n = static_cast<int>(std::ceil(6. * turn / reach));
      angles      = Eigen::ArrayXd::LinSpaced(n, 0., turn - turn / n);
      wear        = Eigen::ArrayXd::Zero(n);
    }



    void
    WearSpread::add(const double force,
                    const double angle,
                    const double distance)
    {
      const Eigen::Index n       = angles.size();
      const double       spacing = turn / n;
      const auto         first =
        static_cast<Eigen::Index>(std::ceil((angle - reach) / spacing));
      const auto last =
        static_cast<Eigen::Index>(std::floor((angle + reach) / spacing));
      for (Eigen::Index i = first; i <= last; ++i)
        wear(((i % n) + n) % n) +=
          force * distance *
          std::cos(0.5 * dealii::numbers::PI * (i * spacing - angle) / reach);
    }



    double
    WearSpread::difference(const WearSpread &other) const
    {
      return other.largest() > 0. ? std::abs(largest() / other.largest() - 1.)
                                  : 0.;
    }
  } // namespace Multibody
} // namespace Tribody

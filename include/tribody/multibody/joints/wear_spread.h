// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_joints_wear_spread_h
#define tribody_multibody_joints_wear_spread_h

#include <deal.II/base/numbers.h>

#include <Eigen/Core>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * How forces along sliding distances would wear a bore, for estimates: each
     * wears it around its direction like a cosine, over an angle of reach to
     * either side. In units of force times distance [N m].
     */
    class WearSpread
    {
    public:
      /// That of a bore that is worn in, or nearly so [rad].
      static constexpr double usual_reach = dealii::numbers::PI / 6.;

      /// No wear.
      explicit WearSpread(const double reach = usual_reach);

      /// The normal @p force [N] at the @p angle [rad] in the bushing's frame
      /// over the sliding @p distance [m, or any other unit].
      void
      add(const double force, const double angle, const double distance);

      /// Where it is deepest.
      double
      largest() const
      {
        return wear.maxCoeff();
      }

      /// By how much it is deeper there than @p other, relative to that,
      /// without a sign [-]; zero if that is no wear.
      double
      difference(const WearSpread &other) const;

    private:
      double         reach;
      Eigen::ArrayXd angles;
      Eigen::ArrayXd wear;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

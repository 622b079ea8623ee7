// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_cycle_settling_monitor_h
#define tribody_multibody_cycle_settling_monitor_h

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    /// What repeats from cycle to cycle if a motion has settled.
    struct RepeatingQuantity
    {
      /// One column per instant of the cycle, in any unit.
      Eigen::Matrix2Xd values;
      /// What its changes are compared with, in the same unit; not positive:
      /// the quantity is nothing but roundings.
      double scale;
    };

    /**
     * Says how far a motion still is from the one that repeats. If each cycle
     * multiplies what is left of a free motion by a complex number @f$\mu@f$,
     * the states @f$x_n = x + c\mu^n@f$ have the changes @f$\Delta_n =
     * x_n - x_{n-1}@f$, and with
     * @f[ \lambda = \Delta_n\cdot\Delta_{n-1} / |\Delta_{n-1}|^2 =
     *     \mathrm{Re}\,\mu, \qquad
     *     r = |\Delta_n| / |\Delta_{n-1}| = |\mu|, \qquad
     *     |x_n - x| = \frac{r}{|\mu - 1|}|\Delta_n|, \quad
     *     |\mu - 1|^2 = 1 - 2\lambda + r^2. @f]
     * The factor r is left out, and the distance is not less than the last
     * change: changes that are noise, one as likely as its opposite, have
     * @f$\lambda\approx -1/2@f$.
     */
    class SettlingMonitor
    {
    public:
      /// Take the next cycle: the same quantities at the same instants.
      void
      add(const std::vector<RepeatingQuantity> &cycle);

      /// Largest change of a quantity from the cycle before, relative to its
      /// scale [-]; infinite after the first cycle.
      double
      difference() const
      {
        return the_difference;
      }

      /// Likewise the largest distance from the motion that repeats; infinite
      /// before the third cycle.
      double
      distance() const
      {
        return the_distance;
      }

      /// The lambda of what is farthest from it [-]. Above one half it comes
      /// nearer steadily.
      double
      decay() const
      {
        return the_decay;
      }

    private:
      std::vector<RepeatingQuantity> last;
      std::vector<Eigen::Matrix2Xd>  last_changes;
      double                         the_difference = infinity;
      double                         the_distance   = infinity;
      double                         the_decay      = 0.;

      static constexpr double infinity =
        std::numeric_limits<double>::infinity();
    };
  } // namespace Multibody
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_stepping_combined_loads_h
#define tribody_stepping_combined_loads_h

#include <Eigen/Core>

#include <tribody/multibody/cycle/duty_cycle.h>

#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    /**
     * The loads of a mean cycle of several load cases: all loads of all cases,
     * each with the part of its sliding that the @p shares [-] of the cycles
     * give it. Cases without a share are left out; but of a single case nothing
     * changes.
     * @param wear_factors of the cases [-].
     */
    Multibody::BearingLoads
    combine_loads(const std::vector<Multibody::BearingLoads> &loads_of_cases,
                  const Eigen::VectorXd                      &shares,
                  const std::vector<double>                  &wear_factors);

    /**
     * The loads of a cycle, but only every second, fourth, ... of them, with
     * the sliding of those that are left out divided among their neighbours, as
     * few as the wear needs: where it is deepest it changes by no more than @p
     * tolerance [-], if it spreads over @p reach [rad] to either side of a
     * force (BearingLoads::spread()). Smooth loads need few: the sum over a
     * period converges faster than any power of their number. Last comes the
     * largest load of all with no sliding, for the largest pressure. Unchanged
     * if there is nothing to leave out. Pins that wear, and coefficients that
     * depend on the speed, are not looked at.
     */
    Multibody::BearingLoads
    thin_out(const Multibody::BearingLoads &loads,
             const double                   reach,
             const double                   tolerance);
  } // namespace Coupling
} // namespace Tribody

#endif

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
  } // namespace Coupling
} // namespace Tribody

#endif

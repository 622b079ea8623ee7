// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/stepping/combined_loads.h>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      void
      append(Eigen::VectorXd &target, const Eigen::VectorXd &part)
      {
        const Eigen::Index n = target.size();
        target.conservativeResize(n + part.size());
        target.tail(part.size()) = part;
      }
    } // namespace



    Multibody::BearingLoads
    combine_loads(const std::vector<Multibody::BearingLoads> &loads_of_cases,
                  const Eigen::VectorXd                      &shares,
                  const std::vector<double>                  &wear_factors)
    {
      Multibody::BearingLoads all;
      for (std::size_t i = 0; i < loads_of_cases.size(); ++i)
        if (shares[i] > 0.)
          {
            const Multibody::BearingLoads &loads = loads_of_cases[i];
            append(all.normal_force, loads.normal_force);
            append(all.contact_angle_bushing, loads.contact_angle_bushing);
            append(all.contact_angle_pin, loads.contact_angle_pin);
            append(all.sliding_increment, shares[i] * loads.sliding_increment);
            append(all.sliding_speed, loads.sliding_speed);
            append(all.wear_factor,
                   Eigen::VectorXd::Constant(loads.size(), wear_factors[i]));
          }
      return all;
    }
  } // namespace Coupling
} // namespace Tribody

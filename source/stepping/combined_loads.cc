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



      // The loads at these places.
      Multibody::BearingLoads
      select(const Multibody::BearingLoads   &loads,
             const std::vector<Eigen::Index> &places)
      {
        return {loads.normal_force(places),
                loads.contact_angle_bushing(places),
                loads.contact_angle_pin(places),
                loads.sliding_increment(places),
                loads.sliding_speed(places)};
      }



      Multibody::BearingLoads
      every_second(const Multibody::BearingLoads &loads)
      {
        const Eigen::Index        n = loads.size();
        std::vector<Eigen::Index> kept;
        for (Eigen::Index i = 0; i < n; i += 2)
          kept.push_back(i);
        Multibody::BearingLoads result = select(loads, kept);
        for (Eigen::Index i = 0; i < n; i += 2)
          result.sliding_increment[i / 2] +=
            0.5 * (loads.sliding_increment[(i + n - 1) % n] +
                   loads.sliding_increment[i + 1]);
        return result;
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



    Multibody::BearingLoads
    thin_out(const Multibody::BearingLoads &loads,
             const double                   reach,
             const double                   tolerance)
    {
      constexpr Eigen::Index      fewest = 8;
      const Multibody::WearSpread wanted = loads.spread(reach);
      Multibody::BearingLoads     thin   = loads;
      while (thin.size() % 2 == 0 && thin.size() >= 2 * fewest)
        {
          const Multibody::BearingLoads thinner = every_second(thin);
          if (thinner.spread(reach).difference(wanted) > tolerance)
            break;
          thin = thinner;
        }
      if (thin.size() == loads.size())
        return loads;
      Eigen::Index largest;
      loads.normal_force.maxCoeff(&largest);
      Multibody::BearingLoads peak = select(loads, {largest});
      peak.sliding_increment.setZero();
      append(thin.normal_force, peak.normal_force);
      append(thin.contact_angle_bushing, peak.contact_angle_bushing);
      append(thin.contact_angle_pin, peak.contact_angle_pin);
      append(thin.sliding_increment, peak.sliding_increment);
      append(thin.sliding_speed, peak.sliding_speed);
      return thin;
    }
  } // namespace Coupling
} // namespace Tribody

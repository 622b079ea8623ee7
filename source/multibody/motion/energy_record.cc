// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/motion/energy_record.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    double
    EnergyRecord::work() const
    {
      return driver_work + force_work;
    }



    double
    EnergyRecord::dissipated() const
    {
      return damper_loss + impact_loss + normal_loss.sum() +
             friction_loss.sum();
    }



    double
    EnergyRecord::balance_error() const
    {
      return work() - kinetic - potential - contact_energy.sum() - dissipated();
    }



    double
    EnergyRecord::largest_term() const
    {
      return std::max({std::abs(driver_work),
                       std::abs(force_work),
                       std::abs(kinetic),
                       std::abs(potential),
                       std::abs(contact_energy.sum()),
                       std::abs(dissipated())});
    }



    EnergyRecord
    EnergyRecord::since(const EnergyRecord &earlier) const
    {
      EnergyRecord change = *this;
      change.kinetic -= earlier.kinetic;
      change.potential -= earlier.potential;
      if (!has_work)
        return change;
      change.driver_work -= earlier.driver_work;
      change.force_work -= earlier.force_work;
      change.damper_loss -= earlier.damper_loss;
      change.impact_loss -= earlier.impact_loss;
      change.contact_energy -= earlier.contact_energy;
      change.normal_loss -= earlier.normal_loss;
      change.friction_loss -= earlier.friction_loss;
      return change;
    }



    double
    relative_to_exchange(const double error,
                         const double term,
                         const double kinetic)
    {
      constexpr double roundings = 1e-12;
      const double     scale     = std::max(term, roundings * kinetic);
      return scale > 0. ? error / scale : 0.;
    }



    double
    balance_relative_error(const std::vector<EnergyRecord> &changes,
                           const double                     kinetic)
    {
      double error = 0., term = 0.;
      for (const EnergyRecord &change : changes)
        {
          error = std::max(error, std::abs(change.balance_error()));
          term  = std::max(term, change.largest_term());
        }
      return relative_to_exchange(error, term, kinetic);
    }
  } // namespace Multibody
} // namespace Tribody

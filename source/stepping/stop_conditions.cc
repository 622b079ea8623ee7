// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/units.h>
#include <tribody/stepping/stop_conditions.h>

#include <map>

namespace Tribody
{
  namespace Coupling
  {
    StopConditions::StopConditions(const std::list<WearingBushing> &bushings)
    {
      std::size_t b = 0;
      for (const WearingBushing &bushing : bushings)
        {
          const BushingLimits &limits = bushing.bushing_parameters().limits;
          for (const auto &[quantity, limit] : std::map<Quantity, double>(
                 {{Quantity::max_depth, limits.max_depth},
                  {Quantity::clearance, limits.clearance},
                  {Quantity::volume, limits.volume},
                  {Quantity::mass, limits.mass}}))
            if (limit > 0.)
              conditions.push_back({&bushing, b, quantity, limit});
          ++b;
        }
    }



    Eigen::VectorXd
    StopConditions::evaluate(const std::vector<Eigen::VectorXd> &depths) const
    {
      Eigen::VectorXd values(n_conditions());
      for (unsigned int i = 0; i < n_conditions(); ++i)
        values[i] = value_of(conditions[i], depths[conditions[i].index]) /
                      conditions[i].limit -
                    1.;
      return values;
    }



    double
    StopConditions::value_of(const Condition       &condition,
                             const Eigen::VectorXd &depth)
    {
      const WearingBushing &bushing = *condition.bushing;
      switch (condition.quantity)
        {
          case Quantity::max_depth:
            return depth.maxCoeff();
          case Quantity::clearance:
            return bushing.largest_clearance(depth);
          default:
            break;
        }
      double                    sum     = 0.;
      const std::vector<double> volumes = bushing.volumes_for_depth(depth);
      std::size_t               i       = 0;
      for (const WearingSurface &surface : bushing.surfaces())
        sum += volumes[i++] *
               (condition.quantity == Quantity::mass ? surface.density : 1.);
      return sum;
    }



    std::string
    StopConditions::describe(const unsigned int condition) const
    {
      const Condition  &c    = conditions[condition];
      const std::string name = c.bushing->name() + ": ";
      switch (c.quantity)
        {
          case Quantity::max_depth:
            return name + "maximum depth " +
                   Units::to_string(c.limit, "m", "mm");
          case Quantity::clearance:
            return name + "clearance " + Units::to_string(c.limit, "m", "mm");
          case Quantity::volume:
            return name + "worn volume " +
                   Units::to_string(c.limit, "m^3", "mm^3");
          default: // Quantity::mass
            return name + "worn mass " + Units::to_string(c.limit, "kg", "g");
        }
    }
  } // namespace Coupling
} // namespace Tribody

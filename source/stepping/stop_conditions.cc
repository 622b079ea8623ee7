// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/stepping/stop_conditions.h>

namespace Tribody
{
  namespace Coupling
  {
    StopConditions::StopConditions(const std::deque<WearingBushing> &bushings)
    {
      for (std::size_t j = 0; j < bushings.size(); ++j)
        {
          const std::vector<double> &limits =
            bushings[j].bushing_parameters().limits;
          for (std::size_t i = 0; i < limits.size(); ++i)
            if (limits[i] > 0.)
              conditions.push_back({&bushings[j],
                                    j,
                                    &joint_limits()[i],
                                    limits[i],
                                    joint_limits()[i].describe(limits[i])});
          conditions.push_back({&bushings[j],
                                j,
                                &worn_through(),
                                worn_through_at,
                                "worn through"});
        }
    }



    Eigen::VectorXd
    StopConditions::evaluate(const std::vector<Eigen::VectorXd> &depths) const
    {
      Eigen::VectorXd values(n_conditions());
      for (unsigned int i = 0; i < n_conditions(); ++i)
        {
          const Condition &c = conditions[i];
          values[i] =
            c.quantity->value(*c.bushing, depths[c.joint]) / c.limit - 1.;
        }
      return values;
    }



    std::string
    StopConditions::describe(const unsigned int condition) const
    {
      const Condition &c = conditions[condition];
      return c.bushing->name() + ": " + c.description;
    }
  } // namespace Coupling
} // namespace Tribody

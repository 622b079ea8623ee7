// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_stepping_stop_conditions_h
#define tribody_stepping_stop_conditions_h

#include <Eigen/Core>

#include <tribody/bushing/wearing_bushing.h>

#include <list>
#include <string>
#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    /**
     * When a run ends before its last cycle: the life of a joint is over
     * once its depth, its clearance, or what bushing and pin have lost passes a
     * limit (BushingLimits).
     */
    class StopConditions
    {
    public:
      explicit StopConditions(const std::list<WearingBushing> &bushings);

      unsigned int
      n_conditions() const
      {
        return conditions.size();
      }

      /**
       * One value per condition: the quantity over its limit, minus one; it
       * changes its sign when the limit is passed.
       * @param depths WearingBushing::depth() of each bushing [m].
       */
      Eigen::VectorXd
      evaluate(const std::vector<Eigen::VectorXd> &depths) const;

      /// For the user: "crank_pin: maximum depth 0.3 mm".
      std::string
      describe(const unsigned int condition) const;

    private:
      enum class Quantity
      {
        max_depth,
        clearance,
        volume,
        mass
      };

      struct Condition
      {
        const WearingBushing *bushing;
        std::size_t           index;
        Quantity              quantity;
        double                limit;
      };

      static double
      value_of(const Condition &condition, const Eigen::VectorXd &depth);

      std::vector<Condition> conditions;
    };
  } // namespace Coupling
} // namespace Tribody

#endif

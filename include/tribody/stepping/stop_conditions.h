// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_stepping_stop_conditions_h
#define tribody_stepping_stop_conditions_h

#include <Eigen/Core>

#include <tribody/bushing/joint_limits.h>
#include <tribody/bushing/wearing_bushing.h>

#include <deque>
#include <string>
#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    /**
     * When a run ends before its last cycle: the life of a joint is over
     * once one of its quantities passes a limit (JointLimit), or its bushing is
     * worn through.
     */
    class StopConditions
    {
    public:
      /// @param bushings must outlive this object.
      explicit StopConditions(const std::deque<WearingBushing> &bushings);

      /// One for each limit that is set for a bushing, and one for its wall.
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
      struct Condition
      {
        const WearingBushing *bushing;
        /// Number of the bushing.
        std::size_t       joint;
        const JointLimit *quantity;
        double            limit;
        /// For the user, without the bushing's name.
        std::string description;
      };

      std::vector<Condition> conditions;
    };
  } // namespace Coupling
} // namespace Tribody

#endif

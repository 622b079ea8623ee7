// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/multibody/cycle/integration_accuracy.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // By how much the wear that @p joint makes differs from that of @p other,
      // where it is deepest or in all [-].
      double
      compare_wear(const JointDutyCycle &joint,
                   const JointDutyCycle &other,
                   const double          reach)
      {
        if (joint.sliding_halves.size() == 0)
          return 0.;
        const auto work = [](const JointDutyCycle &of) {
          return of.mean_normal_force() * of.sliding_distance();
        };
        const double in_all = work(joint) != work(other)
                                ? std::abs(work(other) / work(joint) - 1.)
                                : 0.;
        return std::max(in_all,
                        other.finer_spread(reach).difference(
                          joint.finer_spread(reach)));
      }
    } // namespace



    double
    reach_of(const JointDutyCycle &joint, const WearArcs &arcs)
    {
      const auto arc = arcs.find(joint.name);
      return arc != arcs.end() ? arc->second : JointDutyCycle::usual_reach;
    }



    double
    usual_integration_error(const double accuracy)
    {
      return 3. * accuracy;
    }



    DutyCycle
    integrate_as_needed(
      const std::function<DutyCycle(const double, const DutyCycle *)>
                     &integrate,
      const WearArcs &arcs)
    {
      constexpr double allowed = 2e-3;
      constexpr double loosest = 4e-2, finest = 1e-5, ratio = 4.;

      // Where more is left of a difference than this, it is scatter.
      constexpr double least_gain = 0.5, largest_gain = 0.75;

      double                   before = std::numeric_limits<double>::infinity();
      std::optional<DutyCycle> looser;
      for (double accuracy = loosest;; accuracy /= ratio)
        {
          const bool is_finest = accuracy / ratio < finest;
          DutyCycle  cycle;
          try
            {
              cycle = integrate(accuracy, looser ? &*looser : nullptr);
            }
          catch (const ExcRun &)
            {
              // A finer one may take too many steps.
              if (looser)
                return *looser;
              if (is_finest)
                throw;
              continue;
            }
          double largest = 0.;
          for (std::size_t j = 0; j < cycle.joints.size(); ++j)
            {
              JointDutyCycle &joint   = cycle.joints[j];
              joint.integration_error = looser
                                          ? compare_wear(joint,
                                                         looser->joints[j],
                                                         reach_of(joint, arcs))
                                          : usual_integration_error(accuracy);
              largest = std::max(largest, joint.integration_error);
            }
          const bool agrees =
            looser && (largest <= allowed || largest >= least_gain * before);
          const bool may_settle =
            looser && !cycle.settling.converged &&
            cycle.settling.distance < least_gain * looser->settling.distance;
          if (is_finest || (agrees && !may_settle))
            {
              // It may be a slow approach as well: the rest of its series.
              const double gain = std::min(largest / before, largest_gain);
              for (JointDutyCycle &joint : cycle.joints)
                joint.integration_error *= std::max(1., gain / (1. - gain));
              return cycle;
            }
          before = looser ? largest : std::numeric_limits<double>::infinity();
          looser = std::move(cycle);
        }
    }
  } // namespace Multibody
} // namespace Tribody

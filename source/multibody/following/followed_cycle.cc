// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/interruption.h>
#include <tribody/multibody/following/followed_cycle.h>
#include <tribody/multibody/joints/wear_spread.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/mechanism.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // Rates of the pins are differences over such parts of a cycle. What they
      // leave out of the wear is judged by those over half of them, of the
      // forces by those over a quarter.
      constexpr std::size_t parts_of_cycle  = 32;
      constexpr std::size_t parts_for_wear  = 64;
      constexpr std::size_t parts_for_force = 128;

      // Shares of the forces: below the first they may stay out; they are to
      // shrink by the factor from one pass to the next.
      constexpr double       small_share = 1e-3, shrinks = 0.5;
      constexpr unsigned int max_passes = 8;

      // Over instants: what NeglectedInertia says of one joint.
      class InertiaSum
      {
      public:
        // The force of the joint and its change by inertia, in the bushing's
        // frame, with the speed at which pin and bushing turn against each
        // other.
        void
        add(const double           time,
            const Eigen::Vector2d &force,
            const Eigen::Vector2d &change,
            const double           speed)
        {
          const Eigen::Vector2d changed = force + change;
          ++n_instants;
          forces += speed * force.norm();
          changes += speed * change.norm();
          unweighted_forces += force.norm();
          unweighted_changes += change.norm();
          wear.add(force.norm(), std::atan2(force.y(), force.x()), speed);
          changed_wear.add(changed.norm(),
                           std::atan2(changed.y(), changed.x()),
                           speed);
          if (!(changed.dot(force) < 0.))
            return;
          ++n_lifted;
          const double pull = -changed.dot(force) / force.norm();
          if (pull > most_pulled)
            {
              most_pulled = pull;
              lift_time   = time;
            }
        }

        NeglectedInertia
        result() const
        {
          NeglectedInertia inertia;
          // A joint that does not slide may be lifted all the same.
          if (forces > 0.)
            inertia.share = changes / forces;
          else if (unweighted_forces > 0.)
            inertia.share = unweighted_changes / unweighted_forces;
          inertia.of_wear       = changed_wear.difference(wear);
          inertia.lifting_share = n_lifted / std::max(1., n_instants);
          inertia.time          = lift_time;
          return inertia;
        }

      private:
        double     n_instants = 0., n_lifted = 0.;
        double     forces = 0., changes = 0.;
        double     unweighted_forces = 0., unweighted_changes = 0.;
        double     most_pulled = 0., lift_time = 0.;
        WearSpread wear, changed_wear;
      };



      // By differences of the places, around the cycle.
      std::vector<PinRates>
      find_rates(const std::vector<FollowingInstant> &instants,
                 const std::size_t                    parts)
      {
        const std::size_t n      = instants.size() - 1;
        const std::size_t stride = std::max<std::size_t>(1, n / parts);
        const double      step =
          (instants.back().state.time - instants.front().state.time) * stride /
          n;
        std::vector<PinRates> rates;
        for (std::size_t k = 0; k <= n; ++k)
          {
            const auto &before = instants[(k + n - stride) % n].eccentricities;
            const auto &now    = instants[k % n].eccentricities;
            const auto &after  = instants[(k + stride) % n].eccentricities;
            rates.push_back({(after - before) / (2. * step),
                             (before - 2. * now + after) / (step * step)});
          }
        return rates;
      }



      std::vector<NeglectedInertia>
      find_neglected(const FollowingPins         &pins,
                     const FollowedCycle         &cycle,
                     const std::vector<PinRates> &rates)
      {
        const Mechanism &mechanism = pins.equations_of_motion().mechanism();
        std::vector<InertiaSum> sums(pins.joints().size());
        for (std::size_t k = 0; k + 1 < cycle.instants.size(); ++k)
          {
            const FollowingInstant &now     = cycle.instants[k];
            const Eigen::Matrix2Xd  changes = pins.inertia_forces(
              now, rates[k].accelerations - cycle.rates[k].accelerations);
            for (std::size_t p = 0; p < sums.size(); ++p)
              {
                const BodyPair &bodies =
                  mechanism.joints()[pins.joints()[p]].bodies;
                const PairVector q = bodies.gather(now.state.q);
                const PairVector v = bodies.gather(now.state.v);
                sums[p].add(now.state.time,
                            turned(now.reactions.col(p), -q(5)),
                            turned(changes.col(p), -q(5)),
                            std::abs(v(2) - v(5)));
              }
          }
        std::vector<NeglectedInertia> neglected;
        for (const InertiaSum &sum : sums)
          neglected.push_back(sum.result());
        return neglected;
      }



      double
      largest_share(const std::vector<NeglectedInertia> &neglected)
      {
        double largest = 0.;
        for (const NeglectedInertia &inertia : neglected)
          largest = std::max(largest, inertia.share);
        return largest;
      }
    } // namespace



    FollowedCycle
    follow_cycle(const FollowingPins       &pins,
                 const std::vector<double> &times,
                 const Eigen::VectorXd     &q_guess)
    {
      FollowedCycle         best;
      double                least = 0.;
      std::vector<PinRates> rates(times.size(), pins.no_rates());
      for (unsigned int pass = 0; pass < max_passes; ++pass)
        {
          FollowedCycle   cycle;
          Eigen::VectorXd q = q_guess;
          for (std::size_t k = 0; k < times.size(); ++k)
            {
              stop_if_interrupted();
              cycle.instants.push_back(pins.find(times[k], q, rates[k]));
              q = cycle.instants.back().state.q;
            }
          cycle.rates = rates;
          rates       = find_rates(cycle.instants, parts_of_cycle);
          const double share =
            largest_share(find_neglected(pins, cycle, rates));
          const bool gains = pass == 0 || share < shrinks * least;
          if (pass == 0 || share < least)
            {
              best  = cycle;
              least = share;
            }
          if (share < small_share || !gains)
            break;
        }
      best.neglected =
        find_neglected(pins, best, find_rates(best.instants, parts_for_force));
      const std::vector<NeglectedInertia> of_wear =
        find_neglected(pins, best, find_rates(best.instants, parts_for_wear));
      for (std::size_t p = 0; p < of_wear.size(); ++p)
        best.neglected[p].of_wear = of_wear[p].of_wear;
      return best;
    }
  } // namespace Multibody
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <tribody/multibody/joints/bearing_loads.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // A direction of nothing is along x.
      double
      angle_of(const Eigen::Vector2d &direction)
      {
        const double angle = std::atan2(direction.y(), direction.x());
        return angle < 0. ? angle + 2. * dealii::numbers::PI : angle;
      }



      Eigen::Vector2d
      direction_of(const double angle)
      {
        return {std::cos(angle), std::sin(angle)};
      }



      BearingLoads
      make_loads(const Eigen::Index n)
      {
        const Eigen::VectorXd zero = Eigen::VectorXd::Zero(n);
        return {zero, zero, zero, zero, zero};
      }



      // Loads that become one.
      using Group = std::vector<Eigen::Index>;

      // Let load @p to of @p target be those of @p group. Returns the force
      // times sliding that is lost, on the bushing or on the pin, with what the
      // spread of forces and speeds may change. Like the pressure of a narrow
      // contact, wear where it is deepest goes with the root of the force,
      // whose mean is less than the root of the mean by 1/8 of the relative
      // variance; so much is taken for the speed, on which a wear coefficient
      // may depend.
      double
      merge(const BearingLoads &loads,
            const Group        &group,
            BearingLoads       &target,
            const Eigen::Index  to)
      {
        double distance = 0.;
        for (const Eigen::Index j : group)
          distance += loads.sliding_increment(j);
        Eigen::Vector2d force  = Eigen::Vector2d::Zero();
        Eigen::Vector2d on_pin = Eigen::Vector2d::Zero();
        double          speed = 0., work = 0.;
        for (const Eigen::Index j : group)
          {
            // Without sliding there is no wear to preserve.
            const double weight   = distance > 0.
                                      ? loads.sliding_increment(j) / distance
                                      : 1. / group.size();
            const double weighted = weight * loads.normal_force(j);
            force += weighted * direction_of(loads.contact_angle_bushing(j));
            on_pin += weighted * direction_of(loads.contact_angle_pin(j));
            speed += weight * loads.sliding_speed(j);
            work += weighted * distance;
          }
        const auto relative_square = [](const double x, const double mean) {
          return mean > 0. ? std::pow(x / mean - 1., 2) : 0.;
        };
        double variance = 0.;
        for (const Eigen::Index j : group)
          variance += loads.sliding_increment(j) *
                      (relative_square(loads.normal_force(j), force.norm()) +
                       relative_square(loads.sliding_speed(j), speed));
        target.normal_force(to)          = force.norm();
        target.contact_angle_bushing(to) = angle_of(force);
        target.contact_angle_pin(to)     = angle_of(on_pin);
        target.sliding_increment(to)     = distance;
        target.sliding_speed(to)         = speed;
        return work - distance * std::min(force.norm(), on_pin.norm()) +
               force.norm() * variance / 8.;
      }



      double
      lost_by(const BearingLoads &loads, const Group &group)
      {
        BearingLoads merged = make_loads(1);
        return merge(loads, group, merged, 0);
      }



      // Join @p length groups at a time, one after the other in the list, those
      // by which least is lost first, as long as all that is lost is @p
      // allowed, which is lowered by it.
      std::vector<Group>
      join(const BearingLoads       &loads,
           const std::vector<Group> &groups,
           const std::size_t         length,
           double                   &allowed)
      {
        const std::size_t   n = groups.size() / length;
        std::vector<Group>  joined(n);
        std::vector<double> lost(n);
        for (std::size_t i = 0; i < n; ++i)
          {
            for (std::size_t k = i * length; k < (i + 1) * length; ++k)
              {
                joined[i].insert(joined[i].end(),
                                 groups[k].begin(),
                                 groups[k].end());
                lost[i] -= lost_by(loads, groups[k]);
              }
            lost[i] += lost_by(loads, joined[i]);
          }
        std::vector<std::size_t> order(n);
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(),
                         order.end(),
                         [&](const std::size_t a, const std::size_t b) {
                           return lost[a] < lost[b];
                         });
        std::vector<bool> is_joined(n, false);
        for (std::size_t k = 0; k < n && lost[order[k]] <= allowed; ++k)
          {
            allowed -= std::max(0., lost[order[k]]);
            is_joined[order[k]] = true;
          }
        std::vector<Group> result;
        for (std::size_t i = 0; i < n; ++i)
          if (is_joined[i])
            result.push_back(joined[i]);
          else
            result.insert(result.end(),
                          groups.begin() + i * length,
                          groups.begin() + (i + 1) * length);
        result.insert(result.end(), groups.begin() + n * length, groups.end());
        return result;
      }
    } // namespace



    double
    BearingLoads::sliding_distance() const
    {
      return sliding_increment.sum();
    }



    double
    BearingLoads::mean_normal_force() const
    {
      const double distance = sliding_distance();
      return distance > 0 ? normal_force.dot(sliding_increment) / distance
                          : normal_force.mean();
    }



    WearSpread
    BearingLoads::spread(const double reach) const
    {
      WearSpread result(reach);
      for (Eigen::Index j = 0; j < size(); ++j)
        result.add(normal_force(j),
                   contact_angle_bushing(j),
                   sliding_increment(j));
      return result;
    }



    BearingLoads
    merge_cycles(const BearingLoads &loads,
                 const unsigned int  n_cycles,
                 const double        tolerance)
    {
      if (n_cycles == 1)
        return loads;
      Assert(loads.size() % n_cycles == 0, dealii::ExcInternalError());
      // So many samples of a cycle, at most, become one: 4.
      constexpr unsigned int n_halvings = 2;

      std::vector<Group> groups;
      const Eigen::Index n = loads.size() / n_cycles;
      for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = i; j < loads.size(); j += n)
          groups.push_back({j});
      double allowed =
        tolerance * loads.normal_force.dot(loads.sliding_increment);
      groups = join(loads, groups, n_cycles, allowed);
      for (unsigned int k = 0; k < n_halvings; ++k)
        groups = join(loads, groups, 2, allowed);

      Eigen::Index largest;
      loads.normal_force.maxCoeff(&largest);
      BearingLoads result = make_loads(groups.size() + 1);
      for (std::size_t i = 0; i < groups.size(); ++i)
        merge(loads, groups[i], result, i);
      merge(loads, {largest}, result, groups.size());
      result.sliding_increment(groups.size()) = 0.;
      return result;
    }
  } // namespace Multibody
} // namespace Tribody

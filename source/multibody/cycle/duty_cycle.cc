// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>

#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/multibody/joints/wear_spread.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace Multibody
  {
    Eigen::VectorXd
    JointDutyCycle::force() const
    {
      return (force_x.array().square() + force_y.array().square()).sqrt();
    }



    double
    JointDutyCycle::peak_force() const
    {
      return force().maxCoeff();
    }



    Eigen::Index
    JointDutyCycle::peak_sample() const
    {
      Eigen::Index sample = 0;
      force().maxCoeff(&sample);
      return sample;
    }



    double
    JointDutyCycle::mean_force() const
    {
      return durations.size() == 0 ? force().mean()
                                   : force().dot(durations) / durations.sum();
    }



    double
    JointDutyCycle::sampling_error(const double reach) const
    {
      return spread(reach).difference(finer_spread(reach));
    }



    WearSpread
    JointDutyCycle::finer_spread(const double reach) const
    {
      WearSpread by_records(reach);
      for (Eigen::Index s = 0; s < sliding_halves.size() / 2; ++s)
        {
          for (Eigen::Index half = 0; half < 2; ++half)
            {
              const double distance = 0.5 * sliding_halves(2 * s + half);
              by_records.add(normal_force(s),
                             contact_angle_bushing(s),
                             distance);
              by_records.add(force_between(s + half),
                             angle_between(s + half),
                             distance);
            }
        }
      return by_records;
    }



    double
    JointDutyCycle::share_of(const ContactState wanted) const
    {
      return state_shares[static_cast<unsigned int>(wanted)];
    }



    double
    JointDutyCycle::max_approach_speed() const
    {
      double largest = 0.;
      for (const ContactInterval &contact : contacts)
        largest = std::max(largest, contact.approach_speed);
      return largest;
    }



    const JointDutyCycle &
    DutyCycle::joint(const std::string &name) const
    {
      const auto found = std::find_if(joints.begin(),
                                      joints.end(),
                                      [&](const JointDutyCycle &joint) {
                                        return joint.name == name;
                                      });
      AssertThrow(found != joints.end(),
                  dealii::ExcMessage("There is no joint '" + name + "'."));
      return *found;
    }



    Eigen::Index
    DutyCycle::contact_law_number(const std::size_t j) const
    {
      return std::count_if(joints.begin(),
                           joints.begin() + j,
                           [](const JointDutyCycle &joint) {
                             return joint.has_contact_law;
                           });
    }



    double
    scatter_of_mean(const Eigen::VectorXd &values)
    {
      const double n    = values.size();
      const double mean = values.mean();
      if (n < 2 || mean == 0.)
        return 0.;
      const double variance = (values.array() - mean).square().sum() / (n - 1.);
      return 2. * std::sqrt(variance / n) / std::abs(mean);
    }



    void
    DutyCycle::average_over(const unsigned int n)
    {
      settling.n_averaged_cycles = n;
      period /= n;
      const Eigen::Index n_samples = phase.size() / n;
      for (Eigen::Index s = 0; s < phase.size(); ++s)
        phase(s) = 360. * (s % n_samples) / n_samples;
      const auto deviation = [](const Eigen::VectorXd &x) {
        return std::sqrt((x.array() - x.mean()).square().sum() /
                         std::max<Eigen::Index>(1, x.size() - 1));
      };
      for (JointDutyCycle &joint : joints)
        {
          joint.sliding_increment /= n;
          joint.sliding_halves /= n;
          const Eigen::VectorXd force = joint.force();
          Eigen::VectorXd       peaks(n), means(n), wear(n);
          for (unsigned int k = 0; k < n; ++k)
            {
              const auto cycle = force.segment(k * n_samples, n_samples);
              peaks(k)         = cycle.maxCoeff();
              means(k)         = cycle.mean();
              wear(k) = joint.normal_force.segment(k * n_samples, n_samples)
                          .dot(joint.sliding_increment.segment(k * n_samples,
                                                               n_samples));
            }
          joint.wear_scatter = scatter_of_mean(wear);
          if (wear.mean() > 0.)
            joint.wear_trend = std::abs(wear(n - 1) - wear(0)) / wear.mean();
          joint.mean_peak_force      = peaks.mean();
          joint.peak_force_deviation = deviation(peaks);
          joint.mean_force_deviation = deviation(means);
        }
    }
  } // namespace Multibody
} // namespace Tribody

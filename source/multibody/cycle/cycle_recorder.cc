// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/interruption.h>
#include <tribody/base/significant_digits.h>
#include <tribody/base/units.h>
#include <tribody/multibody/cycle/cycle_recorder.h>
#include <tribody/multibody/cycle/settling_monitor.h>
#include <tribody/multibody/motion/energy_account.h>
#include <tribody/multibody/motion/motion_integrator.h>
#include <tribody/multibody/system/equations_of_motion.h>
#include <tribody/multibody/system/kinematics.h>
#include <tribody/multibody/system/mechanism.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // In [0, 2 pi).
      double
      wrapped(const double angle)
      {
        return angle - 2 * dealii::numbers::PI *
                         std::floor(angle / (2 * dealii::numbers::PI));
      }



      // Angle of a body over the records; zero for the ground.
      double
      angle_of(const int body, const Eigen::MatrixXd &q, const unsigned int k)
      {
        return body == ground_body ? 0. : q(3 * body + 2, k);
      }
    } // namespace



    CycleRecorder::CycleRecorder(const EquationsOfMotion &equations,
                                 const unsigned int       n_samples,
                                 const double             period)
      : equations(equations)
      , n_samples(n_samples)
      , period(period)
      , times(2 * n_samples + 1)
      , q(equations.mechanism().n_coordinates(), 2 * n_samples + 1)
      , v(q.rows(), q.cols())
      , a(q.rows(), q.cols())
      , forces(2 * equations.mechanism().joints().size(), 2 * n_samples + 1)
      , reactions(2 * n_samples + 1)
      , energies(2 * n_samples + 1)
      , contacts(equations.mechanism().clearance_joints().size(),
                 std::vector<JointContact>(2 * n_samples + 1))
    {}



    void
    CycleRecorder::set_energy_account(const EnergyAccount *account)
    {
      energy_account = account;
    }



    void
    CycleRecorder::record(const unsigned int       k,
                          const MechanismState    &state,
                          const EquationsOfMotion &present)
    {
      // Not the multipliers of the integrator: those are outside its error
      // test. These are exact for the given q and v.
      record(k,
             state,
             compute_accelerations(present, state),
             find_contacts(state),
             present);
    }



    void
    CycleRecorder::record(const unsigned int    k,
                          const MechanismState &state,
                          const Accelerations  &accelerations)
    {
      record(k, state, accelerations, find_contacts(state), equations);
    }



    std::vector<JointContact>
    CycleRecorder::find_contacts(const MechanismState &state) const
    {
      std::vector<JointContact> result;
      for (unsigned int j = 0; j < contacts.size(); ++j)
        result.push_back(equations.compute_contact(j, state));
      return result;
    }



    void
    CycleRecorder::record(const unsigned int               k,
                          const MechanismState            &state,
                          const Accelerations             &accelerations,
                          const std::vector<JointContact> &joint_contacts,
                          const EquationsOfMotion         &present)
    {
      stop_if_interrupted();
      check_pins(state, joint_contacts);
      times(k) = state.time;
      q.col(k) = state.q;
      v.col(k) = state.v;
      a.col(k) = accelerations.a;
      for (unsigned int j = 0; j < contacts.size(); ++j)
        contacts[j][k] = joint_contacts[j];
      reactions[k] =
        compute_reactions(present, state, accelerations, joint_contacts);
      for (unsigned int j = 0; j < equations.mechanism().joints().size(); ++j)
        forces.col(k).segment<2>(2 * j) = reactions[k].joints.col(j).head<2>();
      if (energy_account != nullptr)
        energies[k] = energy_account->now();
      else
        {
          const Energy energy   = equations.compute_energy(state.q, state.v);
          energies[k].kinetic   = energy.kinetic;
          energies[k].potential = energy.potential;
        }
    }



    void
    CycleRecorder::check_pins(
      const MechanismState            &state,
      const std::vector<JointContact> &joint_contacts) const
    {
      // Of the clearance; what integration leaves of rigid surfaces and links
      // is far below.
      constexpr double tolerance = 1e-2;
      const auto       check     = [&](const std::string &name,
                             const double       distance,
                             const double       allowed,
                             const std::string &reason) {
        AssertThrow(distance <= allowed,
                    ExcRun("Joint " + name + ": at time " +
                           significant_digits(state.time, 6) +
                           " s the pin's centre is " +
                           Units::to_string(distance, "m", "mm") +
                           " from the bushing's, outside the bore: " + reason));
      };
      for (const JointEntry &joint : equations.mechanism().joints())
        if (joint.has_contact_law())
          {
            const JointContact &contact  = joint_contacts[joint.index];
            const double        distance = contact.eccentricity.norm();
            check(joint.name,
                  distance,
                  joint.bushing_radius +
                    std::max(0., distance - contact.penetration),
                  "its contact force law has not held it. Look at "
                  "loads, speed, radii and moduli");
          }
        else if (joint.link != nullptr)
          check(
            joint.name,
            joint.link->eccentricity(joint.bodies.gather(state.q)).norm(),
            (1. + tolerance) * joint.link->length,
            joint.model == JointModel::impact
              ? "nothing but impacts can hold it there, and the clearance is "
                "only " +
                  Units::to_string(joint.link->length, "m", "mm") +
                  ". They need 'Dynamics/Analysis = dynamic'; there a "
                  "smaller 'Dynamics/Accuracy' finds more of them"
              : "its link has a length of only " +
                  Units::to_string(joint.link->length, "m", "mm") +
                  ". Use a smaller 'Dynamics/Accuracy'");
    }



    std::vector<RepeatingQuantity>
    CycleRecorder::repeating_quantities() const
    {
      // Without the first record, which the cycle before has as its last: the
      // very first cycle begins half an interval late and has none.
      const Eigen::Index             n         = 2 * n_samples;
      const Mechanism               &mechanism = equations.mechanism();
      std::vector<RepeatingQuantity> result;
      const auto                     add = [&](const Eigen::Matrix2Xd &values) {
        result.push_back({values, values.colwise().norm().maxCoeff()});
      };
      const auto is_noise_below =
        [&](const std::size_t begin, const double part, const double least) {
          double largest = least;
          for (std::size_t i = begin; i < result.size(); ++i)
            largest = std::max(largest, part * result[i].scale);
          for (std::size_t i = begin; i < result.size(); ++i)
            if (result[i].scale <= largest)
              result[i].scale = 0.;
        };
      // A joint that carries or turns less than a millionth of the others has
      // nothing but roundings; a body that moves less than a thousandth has the
      // vibration of what it stands on.
      constexpr double noise_of_joints = 1e-6, noise_of_bodies = 1e-3;
      for (unsigned int j = 0; j < mechanism.joints().size(); ++j)
        add(force_in_bushing(j).rightCols(n));
      is_noise_below(0, noise_of_joints, 0.);
      std::size_t begin = result.size();
      for (unsigned int j = 0; j < mechanism.joints().size(); ++j)
        if (mechanism.joints()[j].is_revolute)
          add(turning_speed(j).rightCols(n));
      is_noise_below(begin, noise_of_joints, noise_of_joints / period);
      begin = result.size();
      for (int b = 0; b < v.rows() / 3; ++b)
        {
          Eigen::Matrix2Xd turning = Eigen::Matrix2Xd::Zero(2, n);
          turning.row(0) = mechanism.size() * v.row(3 * b + 2).rightCols(n);
          add(turning);
          add(v.middleRows<2>(3 * b).rightCols(n));
        }
      is_noise_below(begin,
                     noise_of_bodies,
                     noise_of_joints * mechanism.size() / period);
      return result;
    }



    Eigen::Matrix2Xd
    CycleRecorder::force_in_bushing(const unsigned int joint) const
    {
      const JointEntry &entry  = equations.mechanism().joints()[joint];
      Eigen::Matrix2Xd  result = forces.middleRows<2>(2 * joint);
      if (entry.is_revolute)
        for (Eigen::Index k = 0; k < result.cols(); ++k)
          result.col(k) = turned(Eigen::Vector2d(result.col(k)),
                                 -angle_of(entry.bodies.second, q, k));
      return result;
    }



    Eigen::Matrix2Xd
    CycleRecorder::turning_speed(const unsigned int joint) const
    {
      const BodyPair  &bodies = equations.mechanism().joints()[joint].bodies;
      Eigen::Matrix2Xd result = Eigen::Matrix2Xd::Zero(2, v.cols());
      if (bodies.first != ground_body)
        result.row(0) += v.row(3 * bodies.first + 2);
      if (bodies.second != ground_body)
        result.row(0) -= v.row(3 * bodies.second + 2);
      return result;
    }



    double
    CycleRecorder::scatter_of_wear(const unsigned int n_cycles,
                                   const unsigned int n) const
    {
      double largest = 0.;
      for (unsigned int j = 0; j < equations.mechanism().joints().size(); ++j)
        {
          if (!equations.mechanism().joints()[j].is_revolute)
            continue;
          Eigen::VectorXd wear = Eigen::VectorXd::Zero(n_cycles);
          for (unsigned int k = 0; k < 2 * n * n_cycles; ++k)
            wear(k / (2 * n)) +=
              load(j, k).force *
              std::abs(relative_angle(j, k + 1) - relative_angle(j, k));
          largest = std::max(largest, scatter_of_mean(wear));
        }
      return largest;
    }



    void
    CycleRecorder::keep(const unsigned int n, const double its_period)
    {
      const Eigen::Index n_records = 2 * n + 1;
      n_samples                    = n;
      period                       = its_period;
      times.conservativeResize(n_records);
      for (Eigen::MatrixXd *records : {&q, &v, &a, &forces})
        records->conservativeResize(Eigen::NoChange, n_records);
      reactions.resize(n_records);
      energies.resize(n_records);
      for (std::vector<JointContact> &of_joint : contacts)
        of_joint.resize(n_records);
    }



    void
    CycleRecorder::fill_contact(const unsigned int joint,
                                JointDutyCycle    &result) const
    {
      const unsigned int index = equations.mechanism().joints()[joint].index;
      for (unsigned int s = 0; s < n_samples; ++s)
        {
          const JointContact &contact     = contacts[index][2 * s + 1];
          result.normal_force(s)          = contact.normal_force;
          result.friction_force(s)        = contact.tangential_force;
          result.contact_angle_bushing(s) = wrapped(contact.angle_in_bushing);
          result.contact_angle_pin(s)     = wrapped(contact.angle_in_pin);
          result.eccentricity(s)          = contact.eccentricity.norm();
          result.penetration(s)           = contact.penetration;
          result.state[s] = contact.penetration > 0 ? ContactState::following
                                                    : ContactState::free;
        }
    }



    void
    CycleRecorder::fill_ideal(const unsigned int joint,
                              JointDutyCycle    &result) const
    {
      const BodyPair &bodies = equations.mechanism().joints()[joint].bodies;
      for (unsigned int s = 0; s < n_samples; ++s)
        {
          const unsigned int k = 2 * s + 1;
          const double angle = std::atan2(result.force_y(s), result.force_x(s));
          result.normal_force(s) =
            std::hypot(result.force_x(s), result.force_y(s));
          result.contact_angle_bushing(s) =
            wrapped(angle - angle_of(bodies.second, q, k));
          result.contact_angle_pin(s) =
            wrapped(angle - angle_of(bodies.first, q, k));
        }
    }



    void
    CycleRecorder::fill_rigid_clearance(const unsigned int joint,
                                        JointDutyCycle    &result) const
    {
      const JointEntry &entry = equations.mechanism().joints()[joint];
      // Where the force points; for a pin that flies, where e does.
      fill_ideal(joint, result);
      for (unsigned int s = 0; s < n_samples; ++s)
        {
          const unsigned int    k = 2 * s + 1;
          const Eigen::Vector2d e =
            entry.link->eccentricity(entry.bodies.gather(q.col(k)));
          result.eccentricity(s) = e.norm();
          result.penetration(s)  = e.norm() - entry.link->length;
          if (result.normal_force(s) > 0)
            continue;
          const double angle = std::atan2(e.y(), e.x());
          result.contact_angle_bushing(s) =
            wrapped(angle - angle_of(entry.bodies.second, q, k));
          result.contact_angle_pin(s) =
            wrapped(angle - angle_of(entry.bodies.first, q, k));
          if (entry.model == JointModel::impact)
            result.state[s] = ContactState::free;
        }
    }



    unsigned int
    CycleRecorder::event_index(const unsigned int joint) const
    {
      const Mechanism  &mechanism = equations.mechanism();
      const JointEntry &entry     = mechanism.joints()[joint];
      if (entry.has_contact_law())
        return entry.index;
      unsigned int k = 0;
      while (mechanism.impact_joints()[k].joint != joint)
        ++k;
      return mechanism.clearance_joints().size() + k;
    }



    double
    CycleRecorder::relative_angle(const unsigned int joint,
                                  const unsigned int k) const
    {
      const BodyPair &bodies = equations.mechanism().joints()[joint].bodies;
      return angle_of(bodies.first, q, k) - angle_of(bodies.second, q, k);
    }



    CycleRecorder::Load
    CycleRecorder::load(const unsigned int joint, const unsigned int k) const
    {
      const JointEntry &entry = equations.mechanism().joints()[joint];
      if (entry.has_contact_law())
        {
          const JointContact &contact = contacts[entry.index][k];
          return {contact.normal_force, contact.angle_in_bushing};
        }
      const Eigen::Vector2d force = forces.col(k).segment<2>(2 * joint);
      return {force.norm(),
              std::atan2(force.y(), force.x()) -
                angle_of(entry.bodies.second, q, k)};
    }



    void
    CycleRecorder::fill_sliding(const unsigned int joint,
                                JointDutyCycle    &result) const
    {
      const JointEntry &entry = equations.mechanism().joints()[joint];
      const auto        alpha = [&](const unsigned int k) {
        return relative_angle(joint, k);
      };
      // In two halves: where the sliding reverses at a sample, both count.
      result.sliding_halves.resize(2 * n_samples);
      for (unsigned int k = 0; k < 2 * n_samples; ++k)
        result.sliding_halves(k) =
          entry.bushing_radius * std::abs(alpha(k + 1) - alpha(k));
      // A motion that begins at the first sample has nothing before it, but
      // the cycles that repeat it have.
      if (times(0) == times(1))
        result.sliding_halves(0) = result.sliding_halves(1);
      for (unsigned int s = 0; s < n_samples; ++s)
        result.sliding_increment(s) =
          result.sliding_halves(2 * s) + result.sliding_halves(2 * s + 1);
      result.force_between.resize(n_samples + 1);
      result.angle_between.resize(n_samples + 1);
      for (unsigned int s = 0; s <= n_samples; ++s)
        {
          const Load at           = load(joint, 2 * s);
          result.force_between(s) = at.force;
          result.angle_between(s) = at.angle;
        }
      result.sliding_speed = result.sliding_increment * (n_samples / period);
    }



    void
    CycleRecorder::fill_events(const unsigned int               joint,
                               const std::vector<ContactEvent> &events,
                               const double                     motion_begin,
                               JointDutyCycle                  &result) const
    {
      const unsigned int index = event_index(joint);
      const bool         is_in_contact_at_end =
        equations.mechanism().joints()[joint].has_contact_law()
                  ? contacts[index][2 * n_samples].penetration > 0
                  : forces.col(2 * n_samples).segment<2>(2 * joint).norm() > 0;
      const double interval = period / n_samples;
      const double begin    = times(0);
      const double end      = times(2 * n_samples);
      result.contacts       = list_contacts(
        events,
        index,
        {begin, end, motion_begin, interval, is_in_contact_at_end});
      result.state_shares = {{1., 0., 0.}};
      for (ContactInterval &contact : result.contacts)
        {
          const double share =
            (std::min(contact.loss, end) - std::max(contact.onset, begin)) /
            (end - begin);
          result.state_shares[0] -= share;
          result.state_shares[static_cast<unsigned int>(contact.state)] +=
            share;
          result.n_onsets += contact.has_onset && contact.onset >= begin;
          result.n_losses += contact.has_loss && contact.loss < end;
          for (unsigned int k = 0; k < times.size() && !contact.has_loss; ++k)
            if (times(k) >= contact.onset)
              contact.peak_force =
                std::max(contact.peak_force,
                         forces.col(k).segment<2>(2 * joint).norm());
          if (contact.state != ContactState::impact)
            continue;
          // At most one sample lies in such a short contact. One without
          // duration counts for the sample whose interval it is in.
          const bool   is_instant = (contact.loss == contact.onset);
          const double place      = (contact.onset - times(1)) / interval;
          const double s = is_instant ? std::round(place) : std::ceil(place);
          if (s >= 0 && s < n_samples &&
              (is_instant || times(1) + s * interval <= contact.loss))
            result.state[static_cast<unsigned int>(s)] = ContactState::impact;
        }
    }



    double
    CycleRecorder::compute_ringing(const unsigned int joint) const
    {
      const auto   f       = forces.middleRows(2 * joint, 2);
      const double peak    = f.colwise().norm().maxCoeff();
      double       ringing = 0.;
      for (unsigned int k = 2; k + 2 < f.cols(); ++k)
        ringing = std::max(ringing,
                           (f.col(k - 2) - 4 * f.col(k - 1) + 6 * f.col(k) -
                            4 * f.col(k + 1) + f.col(k + 2))
                               .norm() /
                             16);
      return peak > 0 ? ringing / peak : 0.;
    }



    JointDutyCycle
    CycleRecorder::make_joint(const unsigned int               j,
                              const std::vector<ContactEvent> &events,
                              const double motion_begin) const
    {
      const JointEntry     &entry = equations.mechanism().joints()[j];
      const Eigen::VectorXd zero  = Eigen::VectorXd::Zero(n_samples);
      JointDutyCycle        joint;
      joint.name             = entry.name;
      joint.is_revolute      = entry.is_revolute;
      joint.has_gap          = entry.has_gap();
      joint.has_contact_law  = entry.has_contact_law();
      joint.residual_ringing = compute_ringing(j);
      for (Eigen::VectorXd *values : {&joint.force_x,
                                      &joint.force_y,
                                      &joint.moment,
                                      &joint.point_x,
                                      &joint.point_y,
                                      &joint.normal_force,
                                      &joint.friction_force,
                                      &joint.contact_angle_bushing,
                                      &joint.contact_angle_pin,
                                      &joint.sliding_increment,
                                      &joint.sliding_speed,
                                      &joint.eccentricity,
                                      &joint.penetration})
        *values = zero;
      for (unsigned int s = 0; s < n_samples; ++s)
        {
          const Reactions &r = reactions[2 * s + 1];
          joint.force_x(s)   = r.joints(0, j);
          joint.force_y(s)   = r.joints(1, j);
          joint.moment(s)    = r.joints(2, j);
          joint.point_x(s)   = r.joint_points(0, j);
          joint.point_y(s)   = r.joint_points(1, j);
        }
      joint.state.assign(n_samples, ContactState::following);
      if (entry.is_revolute)
        fill_sliding(j, joint);
      if (entry.has_contact_law())
        {
          fill_contact(j, joint);
          fill_events(j, events, motion_begin, joint);
        }
      else if (entry.link != nullptr)
        {
          fill_rigid_clearance(j, joint);
          if (entry.model == JointModel::impact)
            fill_events(j, events, motion_begin, joint);
        }
      else if (entry.is_revolute)
        fill_ideal(j, joint);
      return joint;
    }



    std::vector<DriverDutyCycle>
    CycleRecorder::make_drivers() const
    {
      std::vector<DriverDutyCycle> drivers;
      for (const auto &parameters : equations.mechanism().parameters().drivers)
        {
          const unsigned int d = drivers.size();
          DriverDutyCycle    driver;
          driver.name = parameters.name;
          for (Eigen::VectorXd *values : {&driver.force_x,
                                          &driver.force_y,
                                          &driver.moment,
                                          &driver.power})
            values->resize(n_samples);
          for (unsigned int s = 0; s < n_samples; ++s)
            {
              const Reactions &r = reactions[2 * s + 1];
              driver.force_x(s)  = r.drivers(0, d);
              driver.force_y(s)  = r.drivers(1, d);
              driver.moment(s)   = r.drivers(2, d);
              driver.power(s)    = r.driver_powers(d);
            }
          drivers.push_back(driver);
        }
      return drivers;
    }



    EnergyHistory
    CycleRecorder::make_energy() const
    {
      EnergyHistory             history;
      std::vector<EnergyRecord> changes;
      for (const EnergyRecord &record : energies)
        changes.push_back(record.since(energies.front()));
      history.kinetic.resize(n_samples);
      history.potential.resize(n_samples);
      for (unsigned int s = 0; s < n_samples; ++s)
        {
          history.kinetic(s)   = energies[2 * s + 1].kinetic;
          history.potential(s) = energies[2 * s + 1].potential;
          history.samples.push_back(changes[2 * s + 1]);
        }
      history.cycle = changes.back();
      if (energy_account != nullptr)
        {
          history.relative_error =
            balance_relative_error(changes, history.kinetic.maxCoeff());
          history.relative_error_since_start = energy_account->relative_error();
        }
      return history;
    }



    DutyCycle
    CycleRecorder::make_duty_cycle(const std::vector<ContactEvent> &events,
                                   const double                     begin) const
    {
      const auto at_samples = [this](const Eigen::MatrixXd &records) {
        Eigen::MatrixXd samples(records.rows(), n_samples);
        for (unsigned int s = 0; s < n_samples; ++s)
          samples.col(s) = records.col(2 * s + 1);
        return samples;
      };
      DutyCycle cycle;
      cycle.period = period;
      cycle.time   = at_samples(times.transpose()).transpose();
      cycle.phase =
        Eigen::VectorXd::LinSpaced(n_samples, 0., 360. - 360. / n_samples);
      cycle.coordinates   = at_samples(q);
      cycle.velocities    = at_samples(v);
      cycle.accelerations = at_samples(a);
      for (unsigned int j = 0; j < equations.mechanism().joints().size(); ++j)
        cycle.joints.push_back(make_joint(j, events, begin));
      cycle.drivers = make_drivers();
      cycle.energy  = make_energy();
      return cycle;
    }
  } // namespace Multibody
} // namespace Tribody

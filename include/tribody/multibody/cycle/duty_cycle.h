// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_cycle_duty_cycle_h
#define tribody_multibody_cycle_duty_cycle_h

#include <Eigen/Core>

#include <tribody/multibody/cycle/contact_interval.h>
#include <tribody/multibody/following/continued_motion.h>
#include <tribody/multibody/joints/bearing_loads.h>
#include <tribody/multibody/joints/wear_spread.h>
#include <tribody/multibody/motion/energy_record.h>
#include <tribody/multibody/play/watched_path.h>
#include <tribody/sundials/ida_integrator.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    /**
     * One joint over a cycle; one entry per sample. The loads on its surfaces,
     * and what else there is to know. Forces are those of the
     * pin (first body) on the bushing (second body), in global axes.
     *
     * For an ideal revolute joint, the normal force is the whole reaction and
     * the contact where it points; friction, eccentricity and penetration are
     * zero. Other joints have forces only. A kinematic analysis knows no
     * forces: they are zero.
     */
    struct JointDutyCycle : BearingLoads
    {
      /// As in the parameters.
      std::string name;
      /// Whether pin and bushing turn against each other: only then is there
      /// sliding.
      bool is_revolute = true;
      /// As JointParameters::has_gap().
      bool has_gap = false;
      /// As JointParameters::has_contact_law(); EnergyRecord has entries for
      /// these joints.
      bool has_contact_law = false;

      /// Time that each sample stands for [s]; empty: the same for all.
      Eigen::VectorXd durations;
      /// Total force, x component [N].
      Eigen::VectorXd force_x;
      /// Total force, y component [N].
      Eigen::VectorXd force_y;
      /// On the bushing along k x n [N], where n points from the bushing's
      /// centre to the contact: the sign of the sliding speed of the pin.
      Eigen::VectorXd friction_force;
      /// |e|, of the pin's centre from the bushing's [m].
      Eigen::VectorXd eccentricity;
      /// delta [m]; negative: gap.
      Eigen::VectorXd penetration;
      /// Following for an ideal joint.
      std::vector<ContactState> state;

      /// Moment on the second body about its marker, the centre of the bushing
      /// [N m].
      Eigen::VectorXd moment;
      /// Where that marker is, x in global axes [m].
      Eigen::VectorXd point_x;
      /// Where that marker is, y in global axes [m].
      Eigen::VectorXd point_y;

      /// Contacts that began in this cycle.
      unsigned int n_onsets = 0;
      /// Contacts that ended in this cycle.
      unsigned int n_losses = 0;
      /// All contacts that fall into this cycle, also in part.
      std::vector<ContactInterval> contacts;
      /// Parts of the cycle's time in each ContactState [-].
      std::array<double, 3> state_shares = {{0., 0., 1.}};
      /// Largest force [N] at any integration step since the start of the
      /// motion, its impacts included.
      double peak_force_since_start = 0.;
      /// Vibration left in the force, relative to its peak: the largest fourth
      /// difference of the force over half intervals, divided by 16, which
      /// leaves what alternates and cancels what is smooth [-]. A reversal of
      /// friction counts too.
      double residual_ringing = 0.;

      /// If the pin follows its bore: change of the force by the inertia that
      /// this leaves out, relative to the force, both averaged over the sliding
      /// [-]. See NeglectedInertia.
      double neglected_inertia = 0.;
      /// Likewise that of the wear where it is deepest, WearSpread [-].
      double wear_of_neglected_inertia = 0.;
      /// What the integration of the motion may leave in the wear [-]; zero
      /// without one.
      double integration_error = 0.;

      /// Between the samples, from half an interval before the first on: normal
      /// force [N]; one more than samples. Empty if not revolute.
      Eigen::VectorXd force_between;
      /// Likewise its direction in the frame of the bushing [rad].
      Eigen::VectorXd angle_between;
      /// Sliding [m] in the two halves of the intervals, in order; twice as
      /// many as samples.
      Eigen::VectorXd sliding_halves;

      /// If friction holds the joint: what it has crept instead [m], which is
      /// not in the sliding. See judge_creep().
      double creep_distance = 0.;
      /// Otherwise the part of the sliding that is creep [-].
      double creep_share = 0.;

      /// If several cycles were recorded: twice the standard error of the mean
      /// of normal force times sliding, relative to it [-].
      double wear_scatter = 0.;
      /// Likewise how much that product differs in the last cycle from the
      /// first [-].
      double wear_trend = 0.;
      /// Likewise the mean of their peak forces [N].
      double mean_peak_force = 0.;
      /// Likewise the standard deviation of the peak force from cycle to cycle
      /// [N].
      double peak_force_deviation = 0.;
      /// Likewise the standard deviation of the mean force from cycle to cycle
      /// [N].
      double mean_force_deviation = 0.;

      /// Magnitude of the total force [N].
      Eigen::VectorXd
      force() const;

      /// Largest total force among the samples [N].
      double
      peak_force() const;

      /// Mean of the total force over time [N].
      double
      mean_force() const;

      /// Of sampling_error() for a bore that is worn in [rad].
      static constexpr double usual_reach = WearSpread::usual_reach;

      /// Error that the samples leave in the wear where it is deepest [-],
      /// estimated from twice as many, for a wear that spreads over the angle
      /// @p reach [rad] to either side of the force: WearSpread.
      double
      sampling_error(const double reach) const;

      /// The wear by the forces at and between the samples, as of twice as
      /// many, spread over @p reach [rad].
      WearSpread
      finer_spread(const double reach) const;

      /// Sample at which the force is largest.
      Eigen::Index
      peak_sample() const;

      /// Largest approach speed of the contacts in this cycle [m/s].
      double
      max_approach_speed() const;

      /// Part of the cycle's time in @p wanted [-].
      double
      share_of(const ContactState wanted) const;
    };

    /// What a driver transmits over a cycle; one entry per sample. Forces in
    /// global axes on the driven body.
    struct DriverDutyCycle
    {
      /// As in the parameters.
      std::string name;
      /// x component [N].
      Eigen::VectorXd force_x;
      /// y component [N].
      Eigen::VectorXd force_y;
      /// About the centre of mass of the driven body [N m].
      Eigen::VectorXd moment;
      /// Into the mechanism [W].
      Eigen::VectorXd power;
    };

    /// Energies over a cycle and how well they are in balance.
    struct EnergyHistory
    {
      /// Kinetic energy at each sample [J].
      Eigen::VectorXd kinetic;
      /// Potential energy of gravity and springs at each sample [J].
      Eigen::VectorXd potential;
      /// Changes since the cycle began, at each sample.
      std::vector<EnergyRecord> samples;
      /// Changes over the whole cycle.
      EnergyRecord cycle;
      /// Largest error of the balance in this cycle, relative to the largest of
      /// its terms in this cycle [-].
      double relative_error = 0.;
      /// The same for the whole motion.
      double relative_error_since_start = 0.;
    };

    /// Twice the standard error of the mean of independent @p values, relative
    /// to the mean [-]: about 95 of 100 such means are nearer to the true one.
    double
    scatter_of_mean(const Eigen::VectorXd &values);

    /// How the motion came to repeat itself.
    struct SettlingReport
    {
      /// Cycles that were run, the recorded one included.
      unsigned int n_cycles = 0;
      /// Largest change of what is to repeat from the cycle before, relative
      /// [-]: SettlingMonitor::difference().
      double repeat_difference = 0.;
      /// How far the motion still is from one that repeats, relative [-]:
      /// SettlingMonitor::distance(). Infinite if nothing decays.
      double distance = 0.;
      /// SettlingMonitor::decay() [-].
      double decay = 0.;
      /// Whether that is within DynamicsParameters::settling_tolerance, or
      /// nothing had to settle.
      bool converged = false;
      /// Cycles that the recorded samples belong to: more than one if the
      /// motion does not repeat.
      unsigned int n_averaged_cycles = 1;
      /// What did not go as wished; empty if everything did.
      std::string message;
    };

    /**
     * What the dynamics hands on: one cycle of all joints, sampled at equal
     * times. Sample j stands for the interval of half a spacing before and
     * after it.
     */
    struct DutyCycle
    {
      /// Time of one cycle [s].
      double period = 0.;
      /// Time since the start of the motion [s].
      Eigen::VectorXd time;
      /// 360 j / n [deg].
      Eigen::VectorXd phase;
      /// All joints, in the order of the parameters.
      std::vector<JointDutyCycle> joints;
      /// One column per sample: (x, y, phi) of each body [m, rad].
      Eigen::MatrixXd coordinates;
      /// Their rates [m/s, rad/s].
      Eigen::MatrixXd velocities;
      /// Their second derivatives [m/s^2, rad/s^2].
      Eigen::MatrixXd accelerations;

      /// All drivers, in the order of the parameters.
      std::vector<DriverDutyCycle> drivers;
      /// Without an energy account, kinetic and potential energy only.
      EnergyHistory energy;
      /// One per watched marker, in the order of the parameters.
      std::vector<WatchedPath> watched_paths;

      /// How many cycles it took to get here.
      SettlingReport settling;
      /// DynamicsParameters::accuracy that it was integrated with [-]; zero if
      /// it was not.
      double accuracy = 0.;
      /// Whether pins follow their bores instead of being integrated.
      bool is_quasi_static = false;
      /// Largest entry of Phi at any integration step since the start of the
      /// motion [m, rad].
      double constraint_drift = 0.;
      /// Where an integrated motion ended, for the next one to go on from.
      std::optional<MotionEnd> end;
      /// Costs of the whole motion, all cycles included; zero without
      /// integration.
      Sundials::IntegratorStatistics statistics;
      /// Integration steps of the recorded cycle alone; a mean if several were
      /// averaged.
      unsigned long n_steps_in_cycle = 0;

      /// Samples of one cycle.
      unsigned int
      n_samples() const
      {
        return phase.size() / settling.n_averaged_cycles;
      }

      /// Make a record of @p n cycles one of an average cycle: every sample
      /// gets an n-th of its sliding, and the scatter is computed.
      void
      average_over(const unsigned int n);

      /// @throws ExcMessage if there is no joint @p name.
      const JointDutyCycle &
      joint(const std::string &name) const;

      /// Place of joint @p j among those with a contact law, as in
      /// EnergyRecord::normal_loss.
      Eigen::Index
      contact_law_number(const std::size_t j) const;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

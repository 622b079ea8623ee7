// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_cycle_cycle_recorder_h
#define tribody_multibody_cycle_cycle_recorder_h

#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/multibody/joints/clearance_joint.h>
#include <tribody/multibody/system/mechanism_state.h>
#include <tribody/multibody/system/reactions.h>

#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    class EnergyAccount;
    class EquationsOfMotion;
    struct Accelerations;
    struct ContactEvent;
    struct RepeatingQuantity;

    /**
     * Turns the states of one cycle into a DutyCycle. It wants them at 2 n + 1
     * equal times, from half an interval before the first of n samples to half
     * an interval after the last.
     */
    class CycleRecorder
    {
    public:
      /// For @p n_samples samples in a cycle of @p period [s]. Keeps a
      /// reference to @p equations.
      CycleRecorder(const EquationsOfMotion &equations,
                    const unsigned int       n_samples,
                    const double             period);

      /// Take the exchanged energies from @p account, which must stay alive;
      /// without, only kinetic and potential energy are recorded.
      void
      set_energy_account(const EnergyAccount *account);

      /// Record number @p k, from 0 to 2 n, of a motion: the accelerations and
      /// reactions are those that the equations of motion give for it. @p
      /// present are these equations: they know the pins that follow their
      /// bores.
      void
      record(const unsigned int       k,
             const MechanismState    &state,
             const EquationsOfMotion &present);

      /// Record number @p k with the given accelerations and multipliers.
      void
      record(const unsigned int    k,
             const MechanismState &state,
             const Accelerations  &accelerations);

      /// Record number @p k with these and with the given contacts, one per
      /// clearance joint.
      void
      record(const unsigned int               k,
             const MechanismState            &state,
             const Accelerations             &accelerations,
             const std::vector<JointContact> &joint_contacts)
      {
        record(k, state, accelerations, joint_contacts, equations);
      }

      /// What is to repeat if the motion has settled: forces of joints in the
      /// frames of their bushings, speeds at which pins turn in them,
      /// velocities of bodies.
      std::vector<RepeatingQuantity>
      repeating_quantities() const;

      /// scatter_of_mean() of normal force times sliding, the largest of all
      /// joints, over the first @p n_cycles of @p n samples each.
      double
      scatter_of_wear(const unsigned int n_cycles, const unsigned int n) const;

      /// Forget all but the first @p n samples, a cycle of @p its_period [s].
      void
      keep(const unsigned int n, const double its_period);

      /// @p events: contact events of the whole motion, which began at time
      /// @p begin [s].
      DutyCycle
      make_duty_cycle(const std::vector<ContactEvent> &events,
                      const double                     begin = 0.) const;

    private:
      void
      record(const unsigned int               k,
             const MechanismState            &state,
             const Accelerations             &accelerations,
             const std::vector<JointContact> &joint_contacts,
             const EquationsOfMotion         &present);

      // A column per record [N].
      Eigen::Matrix2Xd
      force_in_bushing(const unsigned int joint) const;

      // Of the pin in its bushing, a column per record, in the first row
      // [rad/s].
      Eigen::Matrix2Xd
      turning_speed(const unsigned int joint) const;

      // Throws ExcRun if the centre of a pin is outside its bore.
      void
      check_pins(const MechanismState            &state,
                 const std::vector<JointContact> &joint_contacts) const;

      std::vector<JointContact>
      find_contacts(const MechanismState &state) const;

      void
      fill_contact(const unsigned int joint, JointDutyCycle &result) const;

      void
      fill_ideal(const unsigned int joint, JointDutyCycle &result) const;

      // With a massless link, or with impacts.
      void
      fill_rigid_clearance(const unsigned int joint,
                           JointDutyCycle    &result) const;

      // The number of @p joint in contact events.
      unsigned int
      event_index(const unsigned int joint) const;

      void
      fill_sliding(const unsigned int joint, JointDutyCycle &result) const;

      void
      fill_events(const unsigned int               joint,
                  const std::vector<ContactEvent> &events,
                  const double                     motion_begin,
                  JointDutyCycle                  &result) const;

      JointDutyCycle
      make_joint(const unsigned int               joint,
                 const std::vector<ContactEvent> &events,
                 const double                     motion_begin) const;

      std::vector<DriverDutyCycle>
      make_drivers() const;

      EnergyHistory
      make_energy() const;

      double
      compute_ringing(const unsigned int joint) const;

      // Normal force of a revolute joint and its direction in the bushing's
      // frame, at record k.
      struct Load
      {
        double force;
        double angle;
      };
      Load
      load(const unsigned int joint, const unsigned int k) const;

      // Angle between the pin and the bushing of a revolute joint.
      double
      relative_angle(const unsigned int joint, const unsigned int k) const;

      const EquationsOfMotion &equations;
      unsigned int             n_samples;
      double                   period;
      const EnergyAccount     *energy_account = nullptr;

      // One column per record.
      Eigen::VectorXd times;
      Eigen::MatrixXd q;
      Eigen::MatrixXd v;
      Eigen::MatrixXd a;
      // Two rows per joint, x and y.
      Eigen::MatrixXd forces;
      // One entry per record.
      std::vector<Reactions>    reactions;
      std::vector<EnergyRecord> energies;
      // [clearance joint][record]
      std::vector<std::vector<JointContact>> contacts;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

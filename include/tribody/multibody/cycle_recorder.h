#ifndef tribody_multibody_cycle_recorder_h
#define tribody_multibody_cycle_recorder_h

#include <tribody/multibody/clearance_joint.h>
#include <tribody/multibody/duty_cycle.h>
#include <tribody/multibody/mechanism_state.h>

#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    class EquationsOfMotion;
    struct ContactEvent;

    /**
     * Turns the states of one cycle into a DutyCycle. It wants them at 2 n + 1
     * equal times, from half an interval before the first of n samples to half
     * an interval after the last.
     */
    class CycleRecorder
    {
    public:
      CycleRecorder(const EquationsOfMotion &equations,
                    const unsigned int       n_samples,
                    const double             period);

      /// Record number @p k, from 0 to 2 n. @p present are the equations in
      /// that state, which know the pins that follow their bores.
      void
      record(const unsigned int       k,
             const MechanismState    &state,
             const EquationsOfMotion &present);

      /// Exchange what has been recorded with @p other, of the same mechanism
      /// and the same times.
      void
      swap_records(CycleRecorder &other);

      /// Largest difference of a joint force to the one that @p other has
      /// recorded, relative to the joint's largest force.
      double
      difference(const CycleRecorder &other) const;

      /// @p events: contact events of the whole run.
      DutyCycle
      make_duty_cycle(const std::vector<ContactEvent> &events) const;

    private:
      void
      record_forces(const unsigned int       k,
                    const MechanismState    &state,
                    const EquationsOfMotion &present);

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
                  JointDutyCycle                  &result) const;

      double
      compute_ringing(const unsigned int joint) const;

      const EquationsOfMotion &equations;
      const unsigned int       n_samples;
      const double             period;

      // One column per record.
      Eigen::VectorXd times;
      Eigen::MatrixXd q;
      Eigen::MatrixXd v;
      // Two rows per joint, x and y.
      Eigen::MatrixXd forces;
      // [clearance joint][record]
      std::vector<std::vector<JointContact>> contacts;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

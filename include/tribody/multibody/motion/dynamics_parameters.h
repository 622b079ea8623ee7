// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_motion_dynamics_parameters_h
#define tribody_multibody_motion_dynamics_parameters_h

#include <tribody/base/choice.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  namespace Multibody
  {
    /// What is computed of a mechanism. Automatic: inverse dynamics if joints
    /// and drivers leave no freedom, dynamic otherwise.
    enum class Analysis
    {
      automatic,
      kinematic,
      inverse_dynamics,
      dynamic,
      static_equilibrium
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<Analysis>
    choice_names(const Analysis)
    {
      return {{Analysis::automatic, "automatic"},
              {Analysis::kinematic, "kinematic"},
              {Analysis::inverse_dynamics, "inverse dynamics"},
              {Analysis::dynamic, "dynamic"},
              {Analysis::static_equilibrium, "static equilibrium"}};
    }

    /// How pins move in their bores. Automatic: quasi-static where they follow,
    /// dynamic otherwise. What it is in a run without wear is up to the caller.
    enum class JointMotion
    {
      automatic,
      quasi_static,
      dynamic
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<JointMotion>
    choice_names(const JointMotion)
    {
      return {{JointMotion::automatic, "automatic"},
              {JointMotion::quasi_static, "quasi-static"},
              {JointMotion::dynamic, "dynamic"}};
    }

    /// How a mechanism with clearance joints starts.
    enum class MotionStart
    {
      slow_motion,
      centred,
      static_equilibrium
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<MotionStart>
    choice_names(const MotionStart)
    {
      return {{MotionStart::slow_motion, "slow motion"},
              {MotionStart::centred, "centred"},
              {MotionStart::static_equilibrium, "static equilibrium"}};
    }

    /// When energies are added up. What a run without wear means is up to the
    /// caller; here it is the same as never.
    enum class EnergyBalance
    {
      without_wear,
      always,
      never
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<EnergyBalance>
    choice_names(const EnergyBalance)
    {
      return {{EnergyBalance::without_wear, "without wear"},
              {EnergyBalance::always, "always"},
              {EnergyBalance::never, "never"}};
    }

    /// How the motion of a mechanism is integrated and recorded.
    struct DynamicsParameters
    {
      /// What is computed.
      Analysis analysis = Analysis::automatic;
      /// Whether the vibration of pins in their bores is integrated.
      JointMotion joint_motion = JointMotion::dynamic;
      /// Time of one recorded cycle [s]; 0: one turn of the first driver.
      double cycle_duration = 0.;
      /// Local error allowed in a penetration, relative to its size [-].
      double accuracy = 3e-4;
      /// Highest order of BDF; 0: 2 with clearance joints, 5 without.
      unsigned int maximum_order = 0;
      /// Samples of a duty cycle, at equal times; at least.
      unsigned int samples_per_cycle = 72;
      /// Error that they may leave in the wear before twice as many are taken
      /// [-]; 0: they are as many as asked for.
      double sampling_tolerance = 0.;
      /// Distance from a motion that repeats that counts as none [-]:
      /// SettlingReport::distance.
      double settling_tolerance = 5e-3;
      /// Cycles that are run at most before one is taken as it is; 0: the
      /// first one is.
      unsigned int maximum_settling_cycles = 20;
      /// Cycles that are averaged if the motion does not repeat, at most.
      unsigned int averaged_cycles = 10;
      /// Integration steps in one cycle after which the run is given up.
      unsigned int maximum_steps_per_cycle = 1000000;
      /// Position and velocities at time 0, where joints have clearance.
      MotionStart start = MotionStart::slow_motion;
      /// When energies are added up; costs time, and has no effect on the
      /// motion.
      EnergyBalance energy_balance = EnergyBalance::without_wear;

      /// Declares in the current subsection, "Dynamics".
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// @throws ExcParameter with paths that start with "Dynamics".
      void
      check() const;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

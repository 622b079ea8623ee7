// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_stepping_cycle_jump_h
#define tribody_stepping_cycle_jump_h

#include <Eigen/Core>

#include <tribody/stepping/run_state.h>
#include <tribody/stepping/stop_conditions.h>

#include <array>
#include <deque>
#include <optional>
#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    /// What a wear step does to the joints, one entry per bushing.
    struct WearStep
    {
      /// Where it ends [cycles].
      double cycles;
      /// The depths there [m], one value per wearing node.
      std::vector<Eigen::VectorXd> depths;
      /// The cross-section areas that the wearing nodes have lost in the step
      /// [m^2].
      std::vector<Eigen::VectorXd> removed_areas;
      /// Number of the stop condition that it ends at.
      std::optional<unsigned int> reached;
      /// How often the wear of a cycle was computed. An iteration of a stage
      /// counts as one: it solves twice with the nodes in contact given, where
      /// a contact problem takes at least as many iterations.
      unsigned int n_rate_evaluations = 0;
    };

    /// Estimated error that a wear step leaves in a bushing and its pin.
    struct StepError
    {
      Eigen::VectorXd depth; ///< [m], one value per wearing node
      /// Of each of the surfaces [m^3].
      std::array<double, 2> volumes = {{0., 0.}};
    };

    /**
     * Carries the wear of one cycle over many: one step of @f$ dh/dN = W(h)
     * @f$ for all bushings together, under the duty cycle that RunState holds.
     * What lasts from step to step is in RunState::stepper; what the estimate
     * of an error needs of the step before it is kept here.
     */
    class CycleJump
    {
    public:
      /// Both must outlive this object.
      CycleJump(const std::deque<WearingBushing> &bushings,
                const StopConditions             &stop_conditions);

      virtual ~CycleJump() = default;

      /**
       * One step from @p state, at most to @p end [cycles]. The contacts of the
       * joints belong to their depths; the bushings have these shapes.
       * @param state is left as it is, but for its stepper.
       */
      virtual WearStep
      advance(RunState &state, const double end) = 0;

      /**
       * Estimate of the error of the last step, one value per bushing.
       * @param state after it, with the contacts under the duty cycle and with
       *   the compliance that belong to the new shape. Its stepper is made
       *   ready for the next step.
       * @param cycles_kept since the duty cycle was renewed last, at least the
       *   last step; if the contacts are still under the old one, the last
       *   step.
       */
      virtual std::vector<StepError>
      estimate_error(RunState &state, const double cycles_kept) = 0;

    protected:
      /// Those that wear, in the shape of the state; they serve to compute
      /// rates.
      const std::deque<WearingBushing> &bushings;
      /// At which a step ends early.
      const StopConditions &stop_conditions;
    };
  } // namespace Coupling
} // namespace Tribody

#endif

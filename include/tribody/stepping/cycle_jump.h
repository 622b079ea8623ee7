// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_stepping_cycle_jump_h
#define tribody_stepping_cycle_jump_h

#include <Eigen/Core>

#include <tribody/stepping/run_state.h>
#include <tribody/stepping/stop_conditions.h>

#include <array>
#include <list>
#include <vector>

namespace Tribody
{
  namespace Coupling
  {
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
     */
    class CycleJump
    {
    public:
      CycleJump(std::list<WearingBushing> &bushings,
                const StopConditions      &stop_conditions);

      virtual ~CycleJump() = default;

      /**
       * Let the bushings wear, at most up to @p end [cycles].
       * @param state duty cycle and contacts at its number of cycles; cycles
       *   and totals are moved on.
       * @return index of the stop condition that was reached, or -1.
       */
      virtual int
      advance(RunState &state, const double end) = 0;

      /**
       * Estimate of the error of the last step, one value per bushing, now that
       * @p contacts_after are known: those at its end, under the duty cycle and
       * with the compliance that belong to the new shape.
       *
       * @param cycles_kept since the duty cycle was renewed last, at least the
       *   last step; if contacts_after are still under the old one, the last
       *   step.
       */
      virtual std::vector<StepError>
      estimate_error(const std::vector<CycleContact> &contacts_after,
                     const double                     cycles_kept) = 0;

      /// How often the wear of a cycle was computed. An iteration of a stage
      /// counts as one: it solves twice with the nodes in contact given, where
      /// a contact problem takes at least as many iterations.
      virtual unsigned int
      n_rate_evaluations() const = 0;

    protected:
      /// Let @p bushing be worn by @p depth, and count the cross-section
      /// areas that its wearing nodes have lost, @p removed_area [m^2].
      static void
      wear(WearingBushing        &bushing,
           BushingTotals         &totals,
           const Eigen::VectorXd &depth,
           const Eigen::VectorXd &removed_area);

      std::list<WearingBushing> &bushings;
      const StopConditions      &stop_conditions;
    };
  } // namespace Coupling
} // namespace Tribody

#endif

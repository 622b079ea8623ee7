// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_stepping_constant_jump_h
#define tribody_stepping_constant_jump_h

#include <tribody/stepping/cycle_jump.h>

#include <list>
#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    /**
     * The paper's constant extrapolation: Wear::ConstantExtrapolation with the
     * rates that RunState holds; or with the first of them for ever, the
     * one-shot extrapolation that the paper warns of.
     */
    class ConstantJump : public CycleJump
    {
    public:
      /// @param cycles_per_step A_E; 0: a safe part of the stable length.
      ConstantJump(std::list<WearingBushing> &bushings,
                   const StopConditions      &stop_conditions,
                   const double               cycles_per_step,
                   const bool                 keep_first_rate = false);

      int
      advance(RunState &state, const double end) override;

      std::vector<StepError>
      estimate_error(const std::vector<CycleContact> &contacts_after,
                     const double                     cycles_kept) override;

      unsigned int
      n_rate_evaluations() const override
      {
        return 0;
      }

    private:
      void
      update_stable_step(RunState &state);

      double cycles_per_step;
      bool   keep_first_rate;
      /// Compliance builds that the stable length belongs to.
      unsigned int stable_step_builds = 0;
      /// At the start of the last step, and those whose rates it took.
      std::vector<CycleContact> contacts_before;
      std::vector<CycleContact> used_contacts;
    };
  } // namespace Coupling
} // namespace Tribody

#endif

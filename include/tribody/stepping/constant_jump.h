// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_stepping_constant_jump_h
#define tribody_stepping_constant_jump_h

#include <tribody/stepping/cycle_jump.h>

#include <deque>
#include <optional>
#include <utility>
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
      ConstantJump(const std::deque<WearingBushing> &bushings,
                   const StopConditions             &stop_conditions,
                   const double                      cycles_per_step,
                   const bool                        keep_first_rate = false);

      WearStep
      advance(RunState &state, const double end) override;

      std::vector<StepError>
      estimate_error(RunState &state, const double cycles_kept) override;

    private:
      void
      update_stable_step(RunState &state) const;

      std::vector<Eigen::VectorXd>
      depths_after(const std::vector<WearRates> &rates,
                   const double                  n_cycles) const;

      /// When a limit is passed within @p n_cycles: the first to be passed, and
      /// after how many cycles.
      std::optional<std::pair<unsigned int, double>>
      find_passed_limit(const std::vector<WearRates> &rates,
                        const double                  n_cycles) const;

      double cycles_per_step;
      bool   keep_first_rate;
    };
  } // namespace Coupling
} // namespace Tribody

#endif

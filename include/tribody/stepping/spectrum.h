// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_stepping_spectrum_h
#define tribody_stepping_spectrum_h

#include <Eigen/Core>

#include <tribody/base/choice.h>

#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    /// How the cycles of several load cases follow each other.
    enum class LoadCaseOrder
    {
      repeated,
      in_sequence
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<LoadCaseOrder>
    choice_names(const LoadCaseOrder)
    {
      return {{LoadCaseOrder::repeated, "repeated"},
              {LoadCaseOrder::in_sequence, "in sequence"}};
    }

    /**
     * The duty of a joint: load cases and how the cycles of a run are shared
     * among them. Cycles of all cases count alike.
     *
     * Repeated, a block of some cycles of each case comes again and again, so
     * often that they wear together,
     * @f[ \frac{dh}{dN} = \sum_i \frac{n_i}{\sum_k n_k} W_i(h), @f]
     * with the wear @f$W_i@f$ of one cycle of case i. In sequence, all cycles
     * of the first case come first, then those of the second.
     */
    struct Spectrum
    {
      /// How the cases follow each other.
      LoadCaseOrder order = LoadCaseOrder::repeated;
      /// n_i > 0, of each case: in a block, or, in sequence, in the whole run.
      /// Only their ratios matter where has_blocks is false.
      std::vector<double> cycles = {1.};
      /// Of one cycle of each case [s].
      std::vector<double> periods = {0.};
      /// Whether cycles are those of a block that somebody counts.
      bool has_blocks = false;

      /// How many cases there are.
      std::size_t
      n_cases() const
      {
        return cycles.size();
      }

      /// The sum of the n_i.
      double
      n_cycles() const;

      /// Where the load cases change next after @p at [cycles]: infinite if
      /// they do not.
      double
      next_change(const double at) const;

      /// The part of each case in the cycles that follow @p at [cycles]; the
      /// sum is one.
      Eigen::VectorXd
      shares(const double at) const;

      /// How many cycles last @p time [s].
      double
      cycles_in(const double time) const;
    };
  } // namespace Coupling
} // namespace Tribody

#endif

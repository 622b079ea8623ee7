// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_run_deviation_limits_h
#define tribody_run_deviation_limits_h

#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/multibody/elements/watched_marker_parameters.h>

#include <string>
#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    /**
     * How far watched markers may deviate from the paths that they have with
     * ideal joints before a run ends. A deviation is known with the motion
     * only, where StopConditions follow from the wear.
     */
    class DeviationLimits
    {
    public:
      explicit DeviationLimits(
        const std::vector<Multibody::WatchedMarkerParameters> &markers);

      /// Whether there are any.
      bool
      are_set() const;

      /// Largest deviation over its limit, minus one; the largest of all
      /// markers that have a limit, and of the @p cycles of all load cases.
      double
      excess(const std::vector<Multibody::DutyCycle> &cycles) const;

      /// The limit of the marker that has it, for the user: "slider.B:
      /// deviation 0.3 mm".
      std::string
      describe(const std::vector<Multibody::DutyCycle> &cycles) const;

      /// Make sure that the @p cycles, before any wear, have not reached a
      /// limit.
      /// @throws ExcRun with the deviation.
      void
      check_start(const std::vector<Multibody::DutyCycle> &cycles) const;

    private:
      struct Worst
      {
        std::size_t marker;
        double      deviation;
        double      excess;
      };

      Worst
      find_worst(const std::vector<Multibody::DutyCycle> &cycles) const;

      // In the order of the duty cycle's paths.
      std::vector<Multibody::WatchedMarkerParameters> markers;
    };
  } // namespace Coupling
} // namespace Tribody

#endif

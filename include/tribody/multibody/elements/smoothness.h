// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_smoothness_h
#define tribody_multibody_elements_smoothness_h

#include <functional>
#include <optional>

namespace Tribody
{
  namespace Multibody
  {
    /// Where a function of time is not smooth.
    struct Roughness
    {
      /// When [s].
      double time;
      /// Whether the value itself jumps; otherwise its first derivative does.
      bool is_jump;
    };

    /**
     * The worst jump of @p function or of its first derivative between @p begin
     * and @p end [s]: the largest second differences on a grid are followed to
     * ever smaller steps. Those of a smooth function fall with the square of
     * the step, across a kink like the step, across a jump not at all. Empty if
     * there is none beyond 1e-4 of the function's largest slope.
     */
    std::optional<Roughness>
    find_roughness(const std::function<double(const double)> &function,
                   const double                               begin,
                   const double                               end);
  } // namespace Multibody
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/multibody/elements/watched_marker_parameters.h>

namespace Tribody
{
  namespace Multibody
  {
    void
    WatchedMarkerParameters::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_quantity(
        prm,
        "Stop at deviation",
        deviation_limit,
        "m",
        "The run ends when the largest distance in a cycle of the marker from "
        "where it would be with ideal joints has this value; 0: never. The "
        "motion is then computed anew after every wear step, and in the last "
        "one until the deviation is met to 1e-4, or the cycles are known to "
        "1e-4.",
        "mm");
    }



    void
    WatchedMarkerParameters::check() const
    {
      AssertThrow(deviation_limit >= 0.,
                  ExcParameter("Watched marker " + name + "/Stop at deviation",
                               "must not be negative; 0 means no limit"));
    }
  } // namespace Multibody
} // namespace Tribody

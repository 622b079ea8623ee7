// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_watched_marker_parameters_h
#define tribody_multibody_elements_watched_marker_parameters_h

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  namespace Multibody
  {
    /// A marker whose path is compared with the one that it has with ideal
    /// joints.
    struct WatchedMarkerParameters
    {
      /// From the title of the subsection, "<body>.<marker>"; unique among
      /// them.
      std::string name;
      /// Largest deviation at which a run ends [m]; 0: none.
      double deviation_limit = 0.;

      /// Declares in the current subsection, "Watched marker <name>".
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// @throws ExcParameter with paths that start with "Watched marker
      ///   <name>".
      void
      check() const;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_elements_find_marker_h
#define tribody_multibody_elements_find_marker_h

#include <tribody/multibody/elements/body_pair.h>
#include <tribody/multibody/elements/body_parameters.h>

#include <string>
#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    /// Number of the body @p name among @p bodies, ground_body for "ground".
    /// @throws ExcParameter for the parameter @p path, with the names of all.
    int
    find_body(const std::string                 &path,
              const std::string                 &name,
              const std::vector<BodyParameters> &bodies);

    /// The marker @p name, "<body>.<marker>", of @p ground or one of @p bodies.
    /// @throws ExcParameter for the parameter @p path, with the markers that
    ///   there are.
    Marker
    find_marker(const std::string                 &path,
                const std::string                 &name,
                const GroundParameters            &ground,
                const std::vector<BodyParameters> &bodies);
  } // namespace Multibody
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/multibody/elements/find_marker.h>

#include <algorithm>

namespace Tribody
{
  namespace Multibody
  {
    int
    find_body(const std::string                 &path,
              const std::string                 &name,
              const std::vector<BodyParameters> &bodies)
    {
      if (name == "ground")
        return ground_body;
      const auto found =
        std::find_if(bodies.begin(), bodies.end(), [&name](const auto &body) {
          return body.name == name;
        });
      if (found != bodies.end())
        return static_cast<int>(found - bodies.begin());

      std::string valid = "ground";
      for (const BodyParameters &body : bodies)
        valid += ", " + body.name;
      AssertThrow(false,
                  ExcParameter(path,
                               "there is no body '" + name +
                                 "'; the bodies are " + valid));
      return ground_body;
    }



    Marker
    find_marker(const std::string                 &path,
                const std::string                 &name,
                const GroundParameters            &ground,
                const std::vector<BodyParameters> &bodies)
    {
      const std::string::size_type dot = name.find('.');
      AssertThrow(dot != std::string::npos,
                  ExcParameter(path,
                               "'" + name +
                                 "' is not a marker; write <body>.<marker>"));
      const std::string body_name = name.substr(0, dot);
      const int         body      = find_body(path, body_name, bodies);
      const std::map<std::string, dealii::Point<2>> &markers =
        (body == ground_body) ? ground.markers : bodies[body].markers;

      std::string valid;
      for (const auto &[marker, position] : markers)
        valid += (valid.empty() ? "" : ", ") + body_name + "." + marker;
      const auto found = markers.find(name.substr(dot + 1));
      AssertThrow(found != markers.end(),
                  ExcParameter(path,
                               "there is no marker '" + name +
                                 "'; the markers are " + valid));
      return {body, {found->second[0], found->second[1]}};
    }
  } // namespace Multibody
} // namespace Tribody

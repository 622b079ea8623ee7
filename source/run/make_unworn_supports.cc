// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/bushing/elastic_joint.h>
#include <tribody/bushing/elastic_support.h>
#include <tribody/run/make_unworn_supports.h>

namespace Tribody
{
  namespace Coupling
  {
    std::map<std::string, std::shared_ptr<const Multibody::PinSupport>>
    make_unworn_supports(const CaseParameters &parameters)
    {
      std::map<std::string, std::shared_ptr<const Multibody::PinSupport>>
        result;
      for (const BushingParameters &bushing : parameters.bushings)
        {
          const Multibody::JointParameters &joint =
            parameters.joint(bushing.name);
          if (joint.needs_support())
            result[bushing.name] = std::make_shared<const ElasticSupport>(
              ElasticJoint(bushing, joint, parameters.wear.compliance_update),
              bushing,
              joint.pin_radius);
        }
      return result;
    }
  } // namespace Coupling
} // namespace Tribody

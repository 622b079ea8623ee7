// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/units.h>
#include <tribody/bushing/joint_limits.h>
#include <tribody/bushing/wearing_bushing.h>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      double
      max_depth(const WearingBushing &, const Eigen::VectorXd &depth)
      {
        return depth.maxCoeff();
      }



      double
      largest_clearance(const WearingBushing  &bushing,
                        const Eigen::VectorXd &depth)
      {
        return bushing.largest_clearance(depth);
      }



      double
      lost_volume(const WearingBushing &bushing, const Eigen::VectorXd &depth)
      {
        double volume = 0.;
        for (const double of_surface : bushing.volumes_for_depth(depth))
          volume += of_surface;
        return volume;
      }



      double
      lost_mass(const WearingBushing &bushing, const Eigen::VectorXd &depth)
      {
        const std::vector<double> volumes = bushing.volumes_for_depth(depth);
        const std::vector<WearingSurface> surfaces = bushing.surfaces();
        double                            mass     = 0.;
        for (std::size_t i = 0; i < surfaces.size(); ++i)
          mass += volumes[i] * surfaces[i].density;
        return mass;
      }



      double
      lost_wall(const WearingBushing &bushing, const Eigen::VectorXd &depth)
      {
        return bushing.lost_wall(depth);
      }



      double
      nothing(const Multibody::JointParameters &)
      {
        return 0.;
      }
    } // namespace



    const std::vector<JointLimit> &
    joint_limits()
    {
      static const std::vector<JointLimit> limits = {
        {"maximum depth",
         "m",
         "mm",
         "The run ends when the wear of bushing or pin is this deep somewhere; "
         "0: never. Without any limit it ends, as stopped, when a bushing is "
         "worn through: when 99.9 % of its wall are gone somewhere.",
         max_depth,
         nothing},
        {"clearance",
         "m",
         "mm",
         "The run ends when the clearance between pin and bore has this value "
         "somewhere, both worn and where both are deepest; 0: never.",
         largest_clearance,
         [](const Multibody::JointParameters &joint) {
           return joint.clearance();
         }},
        {"worn volume",
         "m^3",
         "mm^3",
         "The run ends when this volume is worn away from bushing and pin "
         "together; 0: never.",
         lost_volume,
         nothing},
        {"worn mass",
         "kg",
         "g",
         "The run ends when this mass is worn away from bushing and pin "
         "together; 0: never.",
         lost_mass,
         nothing}};
      return limits;
    }



    const JointLimit &
    worn_through()
    {
      static const JointLimit limit = {
        "worn part of the wall", "", "%", "", lost_wall, nothing};
      return limit;
    }



    std::string
    JointLimit::parameter() const
    {
      return "Stop at " + quantity;
    }



    std::string
    JointLimit::describe(const double limit) const
    {
      return quantity + " " + Units::to_string(limit, si_unit, shown_unit);
    }
  } // namespace Coupling
} // namespace Tribody

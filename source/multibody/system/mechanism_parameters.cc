// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/multibody/system/mechanism_parameters.h>

#include <set>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      template <typename Entry>
      void
      check_entries(const std::vector<Entry> &entries, const std::string &list)
      {
        std::set<std::string> names;
        for (const Entry &entry : entries)
          {
            AssertThrow(names.insert(entry.name).second,
                        ExcParameter(list,
                                     "the name '" + entry.name +
                                       "' is used twice"));
            entry.check();
          }
      }
    } // namespace



    void
    MechanismParameters::check() const
    {
      AssertThrow(!bodies.empty(),
                  ExcParameter("Bodies",
                               "is empty; a mechanism has at least one body"));
      check_entries(bodies, "Bodies");
      check_entries(joints, "Joints");
      check_entries(springs, "Springs");
      check_entries(rotational_springs, "Rotational springs");
      check_entries(drivers, "Drivers");
      check_entries(forces, "Forces");
      check_entries(torques, "Torques");
      check_entries(watched_markers, "Watched markers");
    }



    MechanismParameters
    with_ideal_joints(const MechanismParameters &parameters)
    {
      MechanismParameters ideal = parameters;
      for (JointParameters &joint : ideal.joints)
        joint.model = JointModel::ideal;
      return ideal;
    }
  } // namespace Multibody
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/algorithm/string/case_conv.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/base/in_quotes.h>
#include <tribody/base/units.h>
#include <tribody/case/case_checks.h>
#include <tribody/case/memory_estimate.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // Files and directories of results have these names, and some file
      // systems do not tell small letters from capitals.
      template <typename Entry>
      void
      check_file_names(const std::string              &list,
                       const std::vector<Entry>       &entries,
                       const std::vector<std::string> &taken = {})
      {
        std::map<std::string, std::string> names;
        for (const std::string &name : taken)
          names.emplace(name,
                        "the directory " + in_quotes(name) + " of the results");
        for (const Entry &entry : entries)
          {
            const auto [other, is_new] =
              names.emplace(boost::algorithm::to_lower_copy(entry.name),
                            in_quotes(entry.name));
            AssertThrow(is_new,
                        ExcParameter(list,
                                     "the results of " + in_quotes(entry.name) +
                                       " would be written over those of " +
                                       other->second +
                                       " (small letters and capitals are "
                                       "alike to some file systems); choose "
                                       "another name"));
          }
      }



      // A driver has a speed, or a time function with its amplitude, or both,
      // or a table.
      template <typename Require>
      void
      check_required_of_driver(const Require                     &require,
                               const ParameterFile               &file,
                               const Multibody::DriverParameters &driver)
      {
        const std::string subsection = "Driver " + driver.name;
        if (driver.is_angle())
          require(subsection, {"Body"});
        else
          require(subsection, {"First marker", "Second marker"});
        if (driver.table.is_given())
          return;
        if (!driver.is_angle())
          require(subsection, {"Initial distance"});
        if (file.is_set(subsection + "/Time function"))
          require(subsection,
                  {driver.is_angle() ? "Angle amplitude"
                                     : "Distance amplitude"});
        else
          require(subsection, {driver.is_angle() ? "Speed" : "Distance speed"});
      }



      // Of the duty cycles of all load cases: coordinates of bodies with two
      // derivatives, and what joints have, each kept two or three times.
      double
      estimate_memory_of_samples(const CaseParameters &parameters)
      {
        const double of_body  = 3. * 9. * sizeof(double),
                     of_joint = 3. * 20. * sizeof(double);
        return std::max<double>(1., parameters.load_cases.size()) *
               parameters.dynamics.samples_per_cycle *
               (of_body * parameters.mechanism.bodies.size() +
                of_joint * parameters.mechanism.joints.size());
      }



      /// @throws ExcParameter if this machine cannot hold the case.
      void
      check_memory_of_case(const CaseParameters &parameters)
      {
        double others = estimate_memory_of_samples(parameters);
        AssertThrow(others <= available_memory(),
                    ExcParameter("Dynamics/Samples per cycle",
                                 std::to_string(
                                   parameters.dynamics.samples_per_cycle) +
                                   " samples of all bodies and joints need "
                                   "about " +
                                   describe_memory(others) +
                                   " of memory; this machine or a limit of the "
                                   "system allows " +
                                   describe_memory(available_memory())));
        if (parameters.cycles > 0)
          for (const BushingParameters &bushing : parameters.bushings)
            {
              const auto &joint = parameters.joint(bushing.name);
              check_memory(bushing, joint, others);
              others += estimate_memory(bushing, joint);
            }
      }
    } // namespace



    void
    check_names(const CaseParameters &parameters)
    {
      check_file_names("Bodies", parameters.mechanism.bodies);
      check_file_names("Drivers", parameters.mechanism.drivers);
      check_file_names("Joints",
                       parameters.mechanism.joints,
                       {"bodies", "drivers", "mechanism", "watched_markers"});
      check_file_names("Watched markers", parameters.mechanism.watched_markers);
      check_file_names("Load cases", parameters.load_cases);
    }



    void
    check_bushing_joints(const CaseParameters &parameters)
    {
      for (const BushingParameters &bushing : parameters.bushings)
        {
          const auto &joints = parameters.mechanism.joints;
          const auto  joint =
            std::find_if(joints.begin(),
                         joints.end(),
                         [&bushing](const auto &j) {
                           return j.name == bushing.name && j.is_revolute();
                         });
          AssertThrow(joint != joints.end(),
                      ExcParameter("Bushings",
                                   "'" + bushing.name +
                                     "' is not the name of a revolute "
                                     "joint"));
          AssertThrow(
            parameters.cycles == 0 || joint->has_contact_law(),
            ExcParameter("Joint " + joint->name + "/Model",
                         "'" + name_of(joint->model) +
                           "' knows no contact pressure, so the bushing "
                           "cannot wear; write 'clearance', or "
                           "'set Cycles = 0' for the dynamics "
                           "alone"));
        }
    }



    void
    check_required(const ParameterFile &file, const CaseParameters &parameters)
    {
      const auto require = [&file](const std::string              &subsection,
                                   const std::vector<std::string> &names) {
        for (const std::string &name : names)
          AssertThrow(file.is_set(subsection + "/" + name),
                      ExcParameter(subsection + "/" + name,
                                   "is not set and has no usual value; write "
                                   "'set " +
                                     name + " = ...'"));
      };

      // A kinematic analysis does not use masses.
      for (const auto &body : parameters.mechanism.bodies)
        if (parameters.dynamics.analysis == Multibody::Analysis::kinematic)
          require("Body " + body.name, {"Markers"});
        else
          require("Body " + body.name,
                  {"Mass", "Moment of inertia", "Markers"});
      for (const auto &joint : parameters.mechanism.joints)
        {
          const std::string              subsection = "Joint " + joint.name;
          const std::vector<std::string> of_pin     = {"Pin marker",
                                                       "Bushing marker"},
                                         of_others  = {"First marker",
                                                       "Second marker"};
          if (!parameters.has_given_loads())
            require(subsection, joint.is_revolute() ? of_pin : of_others);
          if (joint.has_gap())
            require(subsection, {"Pin radius", "Bushing radius"});
          if (joint.has_contact_law())
            require(subsection, {"Pin material", "Bushing material"});
        }
      for (const auto &spring : parameters.mechanism.springs)
        require(
          "Spring " + spring.name,
          {"First marker", "Second marker", "Stiffness", "Reference length"});
      for (const auto &spring : parameters.mechanism.rotational_springs)
        require("Rotational spring " + spring.name,
                {"Body", "Stiffness", "Reference angle"});
      for (const auto &driver : parameters.mechanism.drivers)
        check_required_of_driver(require, file, driver);
      for (const auto &force : parameters.mechanism.forces)
        {
          require("Force " + force.name, {"Marker"});
          if (!force.table.is_given())
            require("Force " + force.name, {"Vector"});
        }
      for (const auto &torque : parameters.mechanism.torques)
        {
          require("Torque " + torque.name, {"Body"});
          if (!torque.table.is_given())
            require("Torque " + torque.name, {"Torque"});
        }
      for (const Material &material : parameters.materials)
        require("Material " + material.name,
                {"Young's modulus", "Poisson's ratio", "Density"});
      for (const BushingParameters &bushing : parameters.bushings)
        {
          require("Bushing " + bushing.name, {"Axial length"});
          if (bushing.wear_coefficient_table.empty())
            require("Bushing " + bushing.name, {"Wear coefficient"});
          if (!bushing.mesh_file.is_given())
            require("Bushing " + bushing.name, {"Outer radius"});
          if (bushing.heat.is_on() && parameters.has_given_loads())
            require("Joint " + bushing.name, {"Friction coefficient"});
          // Whoever says how a joint is cooled says whether it gets warm.
          const std::string heat = "Bushing " + bushing.name + "/Heat";
          if (!file.paths_in(heat).empty())
            AssertThrow(file.is_set(heat + "/Temperature"),
                        ExcParameter(heat + "/Temperature",
                                     "is not set, though other entries of the "
                                     "subsection are; write 'set Temperature = "
                                     "steady', or 'none' for a cold joint"));
        }
    }



    void
    check_cycles_per_step(const CaseParameters &parameters)
    {
      constexpr double most_steps = 1e9;
      const double     step       = parameters.wear.cycles_per_step;
      AssertThrow(step == 0. || parameters.cycles / step <= most_steps,
                  ExcParameter("Wear/Cycles per step",
                               Units::to_string(step, "", "") +
                                 " is too short a step for " +
                                 std::to_string(parameters.cycles) +
                                 " cycles: there may be at most 1e9 steps"));
    }



    void
    check_values(const CaseParameters &parameters)
    {
      for (const Material &material : parameters.materials)
        material.check();
      AssertThrow(parameters.ambient_temperature > 0.,
                  ExcParameter("Ambient temperature",
                               Units::to_string(parameters.ambient_temperature,
                                                "K",
                                                "degC") +
                                 " is below absolute zero"));
      parameters.dynamics.check();
      parameters.wear.check();
      check_cycles_per_step(parameters);
      if (!parameters.has_given_loads())
        parameters.mechanism.check();
      for (const Multibody::JointParameters &joint :
           parameters.mechanism.joints)
        joint.check();
      for (const BushingParameters &bushing : parameters.bushings)
        {
          bushing.check(parameters.joint(bushing.name));
          AssertThrow(
            parameters.cycles > 0 || !bushing.heat.is_on(),
            ExcParameter("Bushing " + bushing.name + "/Heat/Temperature",
                         "'steady' needs the contacts of a run with "
                         "wear, but 'Cycles' is 0; set cycles (those of "
                         "load cases in sequence are in these), or "
                         "'none' for the motion of the cold joint"));
        }

      AssertThrow(parameters.cycles == 0 || !parameters.bushings.empty(),
                  ExcParameter("Cycles",
                               std::to_string(parameters.cycles) +
                                 " cycles of wear need at least one entry "
                                 "in 'Bushings'; 0 cycles need none"));

      check_memory_of_case(parameters);
    }



    double
    estimate_memory(const CaseParameters &parameters)
    {
      double bytes = estimate_memory_of_samples(parameters);
      if (parameters.cycles > 0)
        for (const BushingParameters &bushing : parameters.bushings)
          bytes += estimate_memory(bushing, parameters.joint(bushing.name));
      return bytes;
    }
  } // namespace Coupling
} // namespace Tribody

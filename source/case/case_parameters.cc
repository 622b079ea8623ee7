// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/parameter_handler.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/join.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/base/in_quotes.h>
#include <tribody/base/parameter_file.h>
#include <tribody/base/parameters.h>
#include <tribody/base/significant_digits.h>
#include <tribody/base/units.h>
#include <tribody/bushing/memory_estimate.h>
#include <tribody/case/case_parameters.h>
#include <tribody/case/given_duty_cycle.h>
#include <tribody/case/given_tables.h>
#include <tribody/case/repetition.h>
#include <tribody/multibody/assembly/redundancy.h>
#include <tribody/multibody/cycle/cycle_simulation.h>
#include <tribody/multibody/system/mechanism.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <system_error>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      constexpr unsigned int max_n_cycles = 999999999;



      // A list whose names have a subsection each, "Body crank".
      struct NameList
      {
        std::string              list;
        std::string              kind;
        std::string              documentation;
        std::vector<std::string> names;
        NameKind                 name_kind = NameKind::thing;
      };

      // The lists that decide which subsections exist, with the names that
      // --print-parameters shows.
      std::vector<NameList>
      make_name_lists()
      {
        return {
          {"Bodies",
           "Body",
           "Names of the moving bodies; each has a subsection 'Body <name>'. "
           "The body that does not move is 'ground'.",
           {"body"}},
          {"Joints",
           "Joint",
           "Names of the joints; each has a subsection 'Joint <name>'.",
           {"joint"}},
          {"Springs",
           "Spring",
           "Names of the springs; each has a subsection 'Spring <name>'.",
           {"spring"}},
          {"Rotational springs",
           "Rotational spring",
           "Names of the rotational springs; each has a subsection 'Rotational "
           "spring <name>'.",
           {"rotational_spring"}},
          {"Drivers",
           "Driver",
           "Names of the drivers; each has a subsection 'Driver <name>'. One "
           "turn of the first driver is a cycle, unless 'Dynamics/Cycle "
           "duration' is set.",
           {"driver"}},
          {"Forces",
           "Force",
           "Names of the given forces; each has a subsection 'Force <name>'.",
           {"force"}},
          {"Torques",
           "Torque",
           "Names of the given torques; each has a subsection 'Torque <name>'.",
           {"torque"}},
          {"Materials",
           "Material",
           "Names of the materials; each has a subsection 'Material <name>'.",
           {"steel"}},
          {"Bushings",
           "Bushing",
           "Names of the joints with clearance whose bushing deforms and "
           "wears; "
           "each has a subsection 'Bushing <name of the joint>'.",
           {"joint"}},
          {"Load cases",
           "Load case",
           "Names of the conditions that the machine works under; each has a "
           "subsection 'Load case <name>' that says how often, and repeats "
           "other subsections with the entries that differ. None: one "
           "condition all the time.",
           {"load_case"}},
          {"Watched markers",
           "Watched marker",
           "Markers, '<body>.<marker>', whose paths over the cycle are "
           "compared "
           "with those of the mechanism with ideal joints: what backlash means "
           "at the tool. The ideal motion is the one that drivers prescribe at "
           "the same times, or static equilibrium; other degrees of freedom "
           "must not be left. Each marker has a subsection 'Watched marker "
           "<body>.<marker>'.",
           {"body.O"},
           NameKind::marker}};
      }



      const std::vector<std::string> &
      names_of_kind(const std::vector<NameList> &lists, const std::string &kind)
      {
        const auto list =
          std::find_if(lists.begin(), lists.end(), [&kind](const auto &l) {
            return l.kind == kind;
          });
        Assert(list != lists.end(), dealii::ExcInternalError());
        return list->names;
      }



      // Before everything is declared for them: a bushing has many parameters.
      void
      check_bushing_names(const ParameterFile         &file,
                          const std::vector<NameList> &lists)
      {
        const auto                 &names = names_of_kind(lists, "Joint");
        const std::set<std::string> joints(names.begin(), names.end());
        for (const std::string &name : names_of_kind(lists, "Bushing"))
          AssertThrow(joints.count(name) == 1,
                      ExcInput(file.location("Bushings") +
                               ": Bushings: " + in_quotes(name) +
                               " is not the name of a revolute joint"));
      }



      // With the names that the file has.
      std::vector<NameList>
      read_name_lists(const ParameterFile &file)
      {
        std::vector<NameList> lists = make_name_lists();
        for (NameList &list : lists)
          try
            {
              list.names =
                split_names(file.value(list.list, ""), list.name_kind);
            }
          catch (const ExcInput &exception)
            {
              throw ExcInput(file.location(list.list) + ": " + list.list +
                             ": " + message_of(exception));
            }
        check_bushing_names(file, lists);
        return lists;
      }



      // For messages.
      ParameterFile::NamedLists
      lists_of_kinds(const std::vector<NameList> &lists)
      {
        ParameterFile::NamedLists result;
        for (const NameList &list : lists)
          result.emplace(list.kind, list.list);
        return result;
      }



      // One entry for each name in the list of @p kind.
      template <typename Entry>
      void
      declare_each(dealii::ParameterHandler    &prm,
                   const std::vector<NameList> &lists,
                   const std::string           &kind,
                   std::vector<Entry>          &entries)
      {
        const std::vector<std::string> &names = names_of_kind(lists, kind);
        entries.resize(names.size());
        for (std::size_t i = 0; i < entries.size(); ++i)
          {
            entries[i].name = names[i];
            prm.enter_subsection(kind + " " + entries[i].name);
            entries[i].add_parameters(prm);
            prm.leave_subsection();
          }
      }



      // How long a run is.
      void
      declare_duty(dealii::ParameterHandler &prm, CaseParameters &parameters)
      {
        Parameters::add_integer(prm,
                                "Cycles",
                                parameters.cycles,
                                "Cycles to run, those of all load cases "
                                "together; 0 runs one settled cycle of "
                                "the dynamics without any wear. Not for load "
                                "cases in sequence, which have their own.",
                                0,
                                max_n_cycles);
        Parameters::add_quantity(prm,
                                 "Stop at time",
                                 parameters.stop_at_time,
                                 "s",
                                 "The run ends after this time, if not before; "
                                 "0: never. Without 'Cycles' it is their "
                                 "number, rounded to whole cycles.",
                                 "h");
        Parameters::add_quantity(prm,
                                 "Operating share",
                                 parameters.operating_share,
                                 "",
                                 "The part of the time in which the machine "
                                 "works: 0.667 for 16 of 24 hours.");
        Parameters::add_choice(prm,
                               "Order of load cases",
                               parameters.load_case_order,
                               "'repeated': a block of some cycles of each "
                               "load case comes again and again, so that they "
                               "wear together; 'in sequence': all cycles of "
                               "one, then those of the next.");
      }



      // The handler keeps references into @p parameters and @p lists.
      void
      declare(dealii::ParameterHandler &prm,
              CaseParameters           &parameters,
              std::vector<NameList>    &lists)
      {
        Parameters::add_text(prm,
                             "Title",
                             parameters.title,
                             "One line that says what the case is.");
        declare_duty(prm, parameters);
        for (NameList &list : lists)
          Parameters::add_names(
            prm, list.list, list.names, list.documentation, list.name_kind);
        Parameters::add_point(prm,
                              "Gravity",
                              parameters.mechanism.gravity,
                              "m/s^2",
                              "Acceleration of gravity in global axes.");

        prm.enter_subsection("Ground");
        parameters.mechanism.ground.add_parameters(prm);
        prm.leave_subsection();
        declare_each(prm, lists, "Body", parameters.mechanism.bodies);
        declare_each(prm, lists, "Joint", parameters.mechanism.joints);
        declare_each(prm, lists, "Spring", parameters.mechanism.springs);
        declare_each(prm,
                     lists,
                     "Rotational spring",
                     parameters.mechanism.rotational_springs);
        declare_each(prm, lists, "Driver", parameters.mechanism.drivers);
        declare_each(prm, lists, "Force", parameters.mechanism.forces);
        declare_each(prm, lists, "Torque", parameters.mechanism.torques);
        declare_each(prm, lists, "Material", parameters.materials);
        declare_each(prm, lists, "Bushing", parameters.bushings);
        declare_each(prm, lists, "Load case", parameters.load_cases);
        declare_each(prm,
                     lists,
                     "Watched marker",
                     parameters.mechanism.watched_markers);

        prm.enter_subsection("Dynamics");
        parameters.dynamics.add_parameters(prm);
        prm.leave_subsection();
        prm.enter_subsection("Wear");
        parameters.wear.add_parameters(prm);
        prm.leave_subsection();

        prm.enter_subsection("Output");
        Parameters::add_text(prm,
                             "Directory",
                             parameters.output_directory,
                             "Where results are written; empty: output/<name "
                             "of the parameter file>.");
        Parameters::add_integer(prm,
                                "Number of outputs",
                                parameters.n_outputs,
                                "How often duty cycles, profiles and VTU files "
                                "are written, evenly spread over the cycles, "
                                "first and last included.",
                                2,
                                9999);
        prm.leave_subsection();
      }



      std::string
      print(dealii::ParameterHandler &prm)
      {
        std::ostringstream stream;
        prm.print_parameters(stream,
                             dealii::ParameterHandler::PRM |
                               dealii::ParameterHandler::KeepDeclarationOrder);
        return stream.str();
      }



      Material
      find_material(const std::vector<Material> &materials,
                    const std::string           &name,
                    const std::string           &path)
      {
        std::vector<std::string> names;
        for (const Material &material : materials)
          {
            if (material.name == name)
              return material;
            names.push_back(material.name);
          }
        throw ExcParameter(path,
                           "there is no material '" + name +
                             (names.empty()
                                ? "'; 'Materials' is empty"
                                : "'; 'Materials' lists: " +
                                    boost::algorithm::join(names, ", ")));
      }



      void
      resolve_materials(CaseParameters &parameters)
      {
        for (Multibody::JointParameters &joint : parameters.mechanism.joints)
          if (joint.has_contact_law())
            {
              const std::string path = "Joint " + joint.name + "/";
              joint.pin_material     = find_material(parameters.materials,
                                                 joint.pin_material_name,
                                                 path + "Pin material");
              joint.bushing_material =
                find_material(parameters.materials,
                              joint.bushing_material_name,
                              path + "Bushing material");
            }
      }



      // Finite elements inside the dynamics need a bushing to ask.
      void
      apply_scheme(CaseParameters &parameters)
      {
        const auto &bushings = parameters.bushings;
        const auto  has_bushing =
          [&bushings](const Multibody::JointParameters &joint) {
            return std::any_of(bushings.begin(),
                               bushings.end(),
                               [&joint](const BushingParameters &bushing) {
                                 return bushing.name == joint.name;
                               });
          };
        const bool is_coupled = parameters.wear.scheme == WearScheme::coupled;
        AssertThrow(!is_coupled || !bushings.empty(),
                    ExcParameter("Wear/Scheme",
                                 "'coupled' is about the joints that are "
                                 "listed in 'Bushings', but there are none"));
        for (Multibody::JointParameters &joint : parameters.mechanism.joints)
          {
            if (is_coupled && joint.has_contact_law() && has_bushing(joint))
              joint.contact_force_law = Multibody::ContactForceLawChoice::of<
                Multibody::FiniteElementLaw>();
            AssertThrow(
              !joint.needs_support() || has_bushing(joint),
              ExcParameter("Joint " + joint.name + "/Contact force law",
                           "'finite element' asks the joint's "
                           "bushing for the force, but '" +
                             joint.name +
                             "' is not listed in 'Bushings'. Add it "
                             "there with a subsection 'Bushing " +
                             joint.name + "', or choose another law"));
          }
      }



      // A bushing is that of a joint which can press on it.
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



      // With the files that it names found from anywhere, so that it can be run
      // again where the results are.
      std::string
      print_to_run_again(const ParameterFile      &file,
                         const CaseParameters     &parameters,
                         dealii::ParameterHandler &prm)
      {
        const auto set_full_path = [&](const std::vector<std::string> &path,
                                       const std::string              &entry) {
          for (const std::string &subsection : path)
            prm.enter_subsection(subsection);
          prm.set(entry,
                  full_path(file.file_named_by(
                    boost::algorithm::join(path, "/") + "/" + entry)));
          for (std::size_t i = 0; i < path.size(); ++i)
            prm.leave_subsection();
        };
        for (const BushingParameters &bushing : parameters.bushings)
          {
            const std::string subsection = "Bushing " + bushing.name;
            if (bushing.mesh_file.is_given())
              set_full_path({subsection, "Mesh"}, "File");
            if (!bushing.duty_cycle_file.empty())
              set_full_path({subsection}, "Duty cycle file");
            if (!bushing.wear_coefficient_table.empty())
              set_full_path({subsection}, "Wear coefficient table");
          }
        set_full_paths_of_tables(file, parameters.mechanism, prm);
        return print(prm);
      }



      // Files are named relative to the parameter file that names them, or to
      // the current directory on the command line.
      void
      resolve_files(const ParameterFile &file, CaseParameters &parameters)
      {
        for (BushingParameters &bushing : parameters.bushings)
          {
            const std::string path = "Bushing " + bushing.name + "/";
            if (bushing.mesh_file.is_given())
              bushing.mesh_file.name = file.file_named_by(path + "Mesh/File");
            if (!bushing.duty_cycle_file.empty())
              bushing.duty_cycle_file =
                file.file_named_by(path + "Duty cycle file");
            if (!bushing.wear_coefficient_table.empty())
              bushing.wear_coefficient_table =
                file.file_named_by(path + "Wear coefficient table");
          }
      }



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



      void
      check_names(const CaseParameters &parameters)
      {
        check_file_names("Bodies", parameters.mechanism.bodies);
        check_file_names("Drivers", parameters.mechanism.drivers);
        check_file_names("Joints",
                         parameters.mechanism.joints,
                         {"bodies", "drivers", "mechanism", "watched_markers"});
        check_file_names("Watched markers",
                         parameters.mechanism.watched_markers);
        check_file_names("Load cases", parameters.load_cases);
      }



      bool
      has_given_loads(const CaseParameters &parameters)
      {
        return std::any_of(parameters.bushings.begin(),
                           parameters.bushings.end(),
                           [](const BushingParameters &bushing) {
                             return !bushing.duty_cycle_file.empty();
                           });
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



      // Values that belong to the case and that nobody can guess: a default
      // would be a silent invention.
      void
      check_required(const ParameterFile  &file,
                     const CaseParameters &parameters)
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
            if (!has_given_loads(parameters))
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
          }
      }



      // Of the duty cycle: coordinates of bodies with two derivatives, and what
      // joints have, each kept two or three times.
      double
      estimate_memory_of_samples(const CaseParameters &parameters)
      {
        const double of_body  = 3. * 9. * sizeof(double),
                     of_joint = 3. * 20. * sizeof(double);
        return parameters.dynamics.samples_per_cycle *
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



      // Steps that are a small enough part of the run are lost in its rounding.
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



      // Either all loads come from files, or a mechanism has them.
      Multibody::DutyCycle
      read_given_loads(const CaseParameters &parameters)
      {
        std::vector<GivenLoads> loads;
        for (const BushingParameters &bushing : parameters.bushings)
          {
            AssertThrow(!bushing.duty_cycle_file.empty(),
                        ExcParameter("Bushing " + bushing.name +
                                       "/Duty cycle file",
                                     "is not set; where one bushing has its "
                                     "loads from a file, all have"));
            loads.push_back({bushing.name,
                             bushing.duty_cycle_file,
                             parameters.joint(bushing.name).bushing_radius});
          }
        AssertThrow(
          parameters.mechanism.bodies.empty(),
          ExcParameter("Bodies",
                       "there is no mechanism where the loads of "
                       "bushings come from a 'Duty cycle file'; leave "
                       "bodies, drivers, springs and forces out"));
        const Multibody::MechanismParameters &mechanism = parameters.mechanism;
        const auto refuse = [](const char *list, const std::size_t n) {
          AssertThrow(n == 0,
                      ExcParameter(list,
                                   "there is no mechanism where the loads of "
                                   "bushings come from a 'Duty cycle file'; "
                                   "leave this out"));
        };
        refuse("Drivers", mechanism.drivers.size());
        refuse("Springs", mechanism.springs.size());
        refuse("Rotational springs", mechanism.rotational_springs.size());
        refuse("Forces", mechanism.forces.size());
        refuse("Torques", mechanism.torques.size());
        refuse("Watched markers", mechanism.watched_markers.size());
        AssertThrow(parameters.wear.scheme == WearScheme::staggered,
                    ExcParameter("Wear/Scheme",
                                 "'coupled' is about the motion, and loads "
                                 "from a 'Duty cycle file' have none"));
        AssertThrow(parameters.mechanism.joints.size() == loads.size(),
                    ExcParameter("Joints",
                                 "where loads come from a 'Duty cycle file', "
                                 "the joints are those of 'Bushings'"));
        return read_duty_cycle(loads);
      }



      // Of the mechanism. Returns the time that a cycle takes [s].
      double
      check_mechanism(const CaseParameters &parameters)
      {
        // Markers and bodies that joints, springs and drivers refer to, and
        // whether the mechanism can be assembled.
        const Multibody::Mechanism mechanism(
          Multibody::count_redundant_constraints(parameters.mechanism));
        check_repetition(mechanism, parameters.dynamics, parameters.cycles > 0);
        const Multibody::CycleSimulation simulation(mechanism,
                                                    parameters.dynamics);
        if (parameters.cycles > 0)
          simulation.check_repetition();
        return simulation.duration();
      }



      void
      check(const CaseParameters &parameters)
      {
        for (const Material &material : parameters.materials)
          material.check();
        parameters.dynamics.check();
        parameters.wear.check();
        check_cycles_per_step(parameters);
        if (!has_given_loads(parameters))
          parameters.mechanism.check();
        for (const Multibody::JointParameters &joint :
             parameters.mechanism.joints)
          joint.check();
        for (const BushingParameters &bushing : parameters.bushings)
          bushing.check(parameters.joint(bushing.name));

        AssertThrow(parameters.cycles == 0 || !parameters.bushings.empty(),
                    ExcParameter("Cycles",
                                 std::to_string(parameters.cycles) +
                                   " cycles of wear need at least one entry "
                                   "in 'Bushings'; 0 cycles need none"));

        check_memory_of_case(parameters);
      }



      // A run that lasts a time, or as long as its load cases, has its cycles
      // from there; until they are known it has one.
      void
      set_first_cycle(const ParameterFile &file, CaseParameters &parameters)
      {
        AssertThrow(
          parameters.operating_share > 0. && parameters.operating_share <= 1.,
          ExcParameter("Operating share",
                       Units::to_string(parameters.operating_share, "", "") +
                         " is no part of the time: it is above 0 and "
                         "at most 1"));
        AssertThrow(
          parameters.stop_at_time >= 0.,
          ExcParameter("Stop at time",
                       Units::to_string(parameters.stop_at_time, "s", "h") +
                         " is negative"));
        const bool is_in_sequence =
          parameters.load_case_order == LoadCaseOrder::in_sequence;
        AssertThrow(!is_in_sequence || !parameters.load_cases.empty(),
                    ExcParameter("Order of load cases",
                                 "'in sequence' needs 'Load cases'"));
        AssertThrow(!is_in_sequence || parameters.cycles == 0,
                    ExcParameter("Cycles",
                                 "load cases in sequence have their own "
                                 "'Cycles' or 'Duration' each; these are not "
                                 "set, or 0 for the dynamics alone"));
        if (!file.is_set("Cycles") &&
            (is_in_sequence || parameters.stop_at_time > 0.))
          parameters.cycles = 1;
      }



      // With what the parameters have for it.
      void
      complete(LoadCase &load_case, const CaseParameters &parameters)
      {
        load_case.mechanism = parameters.mechanism;
        load_case.dynamics  = parameters.dynamics;
        if (has_given_loads(parameters))
          load_case.given_duty_cycle = read_given_loads(parameters);
        load_case.period = load_case.given_duty_cycle
                             ? load_case.given_duty_cycle->period
                             : check_mechanism(parameters);
      }



      // One load case of the file, or all of it if there are none: read,
      // resolved and checked. The file is as this case has it.
      CaseParameters
      read_load_case(const ParameterFile &file,
                     const std::string   &file_name,
                     const std::string   &name)
      {
        CaseParameters           parameters;
        std::vector<NameList>    lists = read_name_lists(file);
        dealii::ParameterHandler prm;
        declare(prm, parameters, lists);
        file.apply(prm, lists_of_kinds(lists));

        const std::string prefix =
          name.empty() ? "" : "Load case " + name + ": ";
        try
          {
            set_first_cycle(file, parameters);
            check_names(parameters);
            check_bushing_joints(parameters);
            apply_scheme(parameters);
            check_required(file, parameters);
            resolve_materials(parameters);
            resolve_files(file, parameters);
            read_tables(file, parameters.mechanism);
            check(parameters);
            if (name.empty())
              parameters.load_cases.emplace_back();
            for (LoadCase &load_case : parameters.load_cases)
              if (load_case.name == name)
                complete(load_case, parameters);
          }
        catch (const ExcParameter &exception)
          {
            throw ExcInput(file.location(exception.path) + ": " + prefix +
                           exception.path + ": " + exception.problem);
          }
        // Nothing has been run: what cannot be evaluated here is part of the
        // input.
        catch (const ExcRun &exception)
          {
            throw ExcInput(file_name + ": " + prefix + message_of(exception));
          }
        return parameters;
      }



      // With the cycles that this makes.
      void
      set_spectrum(const ParameterFile &file, CaseParameters &parameters)
      {
        parameters.spectrum =
          make_spectrum(parameters.load_cases, parameters.load_case_order);
        if (parameters.cycles == 0)
          return;
        double n_cycles =
          parameters.load_case_order == LoadCaseOrder::in_sequence
            ? parameters.spectrum.n_cycles()
            : std::numeric_limits<double>::infinity();
        if (file.is_set("Cycles"))
          n_cycles = parameters.cycles;
        if (parameters.stop_at_time > 0.)
          {
            const double in_time = parameters.spectrum.cycles_in(
              parameters.operating_share * parameters.stop_at_time);
            parameters.ends_by_time =
              std::isfinite(n_cycles) && in_time < n_cycles;
            n_cycles = std::min(n_cycles, in_time);
          }
        n_cycles = std::round(n_cycles);
        AssertThrow(n_cycles >= 1. && n_cycles <= max_n_cycles,
                    ExcParameter(parameters.stop_at_time > 0. ? "Stop at time"
                                                              : "Load cases",
                                 "this makes " +
                                   significant_digits(n_cycles, 6) +
                                   " cycles; there may be 1 to " +
                                   std::to_string(max_n_cycles)));
        parameters.cycles = static_cast<unsigned int>(n_cycles);
        check_cycles_per_step(parameters);
      }



      // Of what all load cases have in common, and then what each repeats.
      std::string
      print_with_load_cases(const ParameterFile            &file,
                            const std::vector<std::string> &names)
      {
        const ParameterFile      common = file_of_all_load_cases(file, names);
        CaseParameters           parameters;
        std::vector<NameList>    lists = read_name_lists(common);
        dealii::ParameterHandler prm;
        declare(prm, parameters, lists);
        common.apply(prm, lists_of_kinds(lists));
        return print_to_run_again(common, parameters, prm) +
               print_repeated(file, names);
      }
    } // namespace



    const Multibody::JointParameters &
    CaseParameters::joint(const std::string &name) const
    {
      const auto found =
        std::find_if(mechanism.joints.begin(),
                     mechanism.joints.end(),
                     [&name](const auto &joint) { return joint.name == name; });
      Assert(found != mechanism.joints.end(), dealii::ExcInternalError());
      return *found;
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



    CaseParameters
    read_case(const std::string              &file_name,
              const std::vector<std::string> &overrides)
    {
      const ParameterFile            file(file_name, overrides);
      const std::vector<std::string> names =
        names_of_kind(read_name_lists(file), "Load case");
      const std::string text = print_with_load_cases(file, names);

      // What they have in common is taken from the first.
      CaseParameters parameters;
      if (names.empty())
        parameters = read_load_case(file, file_name, "");
      for (std::size_t i = 0; i < names.size(); ++i)
        {
          const CaseParameters of_case =
            read_load_case(file_of_load_case(file, names, names[i]),
                           file_name,
                           names[i]);
          if (i == 0)
            parameters = of_case;
          parameters.load_cases[i] = of_case.load_cases[i];
        }
      try
        {
          set_spectrum(file, parameters);
        }
      catch (const ExcParameter &exception)
        {
          throw ExcInput(file.location(exception.path) + ": " + exception.path +
                         ": " + exception.problem);
        }

      parameters.text = text;
      if (parameters.output_directory.empty())
        parameters.output_directory = (std::filesystem::path("output") /
                                       std::filesystem::path(file_name).stem())
                                        .string();
      return parameters;
    }



    std::string
    parameter_template()
    {
      CaseParameters           parameters;
      std::vector<NameList>    lists = make_name_lists();
      dealii::ParameterHandler prm;
      declare(prm, parameters, lists);
      return print(prm);
    }
  } // namespace Coupling
} // namespace Tribody

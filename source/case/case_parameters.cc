// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/parameter_handler.h>

#include <boost/algorithm/string/join.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/base/parameter_file.h>
#include <tribody/base/significant_digits.h>
#include <tribody/base/units.h>
#include <tribody/case/case_checks.h>
#include <tribody/case/case_declaration.h>
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

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
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
            const Multibody::JointParameters &joint =
              parameters.joint(bushing.name);
            loads.push_back(
              {bushing.name,
               bushing.duty_cycle_file,
               joint.bushing_radius,
               bushing.heat.is_on() ? joint.friction_coefficient : 0.});
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
        load_case.mechanism           = parameters.mechanism;
        load_case.dynamics            = parameters.dynamics;
        load_case.ambient_temperature = parameters.ambient_temperature;
        if (parameters.has_given_loads())
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
            check_values(parameters);
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



    const BushingParameters *
    CaseParameters::bushing(const std::string &name) const
    {
      const auto found = std::find_if(bushings.begin(),
                                      bushings.end(),
                                      [&name](const BushingParameters &b) {
                                        return b.name == name;
                                      });
      return found != bushings.end() ? &*found : nullptr;
    }



    bool
    CaseParameters::has_given_loads() const
    {
      return std::any_of(bushings.begin(),
                         bushings.end(),
                         [](const BushingParameters &bushing) {
                           return !bushing.duty_cycle_file.empty();
                         });
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

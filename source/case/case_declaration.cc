// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/parameter_handler.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/in_quotes.h>
#include <tribody/case/case_declaration.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
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
    } // namespace



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



    std::vector<NameList>
    read_name_lists(const ParameterFile &file)
    {
      std::vector<NameList> lists = make_name_lists();
      for (NameList &list : lists)
        try
          {
            list.names = split_names(file.value(list.list, ""), list.name_kind);
          }
        catch (const ExcInput &exception)
          {
            throw ExcInput(file.location(list.list) + ": " + list.list + ": " +
                           message_of(exception));
          }
      check_bushing_names(file, lists);
      return lists;
    }



    ParameterFile::NamedLists
    lists_of_kinds(const std::vector<NameList> &lists)
    {
      ParameterFile::NamedLists result;
      for (const NameList &list : lists)
        result.emplace(list.kind, list.list);
      return result;
    }



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
      Parameters::add_quantity(prm,
                               "Ambient temperature",
                               parameters.ambient_temperature,
                               "K",
                               "Of the surroundings of all joints, for those "
                               "that have a 'Heat/Temperature'.",
                               "degC");

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
  } // namespace Coupling
} // namespace Tribody

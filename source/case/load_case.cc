// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/parameter_handler.h>

#include <boost/algorithm/string/predicate.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/base/in_quotes.h>
#include <tribody/base/parameters.h>
#include <tribody/base/significant_digits.h>
#include <tribody/base/units.h>
#include <tribody/case/load_case.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      constexpr std::array<const char *, 4> own_entries = {
        {"Cycles", "Duration", "Share", "Wear coefficient factor"}};

      // As ParameterFile compares names: but for blanks, exactly.
      bool
      is_own_entry(const std::string &path)
      {
        return std::find(own_entries.begin(), own_entries.end(), path) !=
               own_entries.end();
      }



      // Of a joint, what is no part of what it is, where, and how it is meshed.
      bool
      may_differ_in_joint(const std::string &entry)
      {
        static const std::array<const char *, 13> entries = {
          {"Friction law",
           "Friction coefficient",
           "Friction regularisation speed",
           "Friction lower speed",
           "Friction upper speed",
           "Static friction coefficient",
           "Stribeck speed",
           "Viscous friction",
           "Tangential damping",
           "Bristle stiffness",
           "Bristle damping",
           "Restitution coefficient",
           "Contact damping"}};
        return std::find(entries.begin(), entries.end(), entry) !=
               entries.end();
      }



      bool
      may_differ(const std::string &path)
      {
        if (path == "Gravity" || path == "Ambient temperature")
          return true;
        const auto        slash      = path.find('/');
        const std::string subsection = path.substr(0, slash);
        const std::string entry =
          slash == std::string::npos ? "" : path.substr(slash + 1);
        if (entry.empty())
          return false;
        const auto is = [&subsection](const char *kind) {
          return boost::algorithm::starts_with(subsection,
                                               std::string(kind) + ' ');
        };
        if (is("Joint"))
          return may_differ_in_joint(entry);
        if (is("Bushing"))
          return entry == "Duty cycle file";
        if (is("Body"))
          return entry != "Markers";
        return subsection == "Dynamics" || is("Driver") || is("Force") ||
               is("Torque") || is("Spring") || is("Rotational spring");
      }



      // What the subsection of a load case repeats of others.
      std::vector<std::string>
      repeated_paths(const ParameterFile &file, const std::string &subsection)
      {
        std::vector<std::string> paths = file.paths_in(subsection);
        paths.erase(std::remove_if(paths.begin(), paths.end(), is_own_entry),
                    paths.end());
        for (const std::string &path : paths)
          AssertThrow(may_differ(path),
                      ExcInput(
                        file.location(subsection + "/" + path) + ": " +
                        subsection + ": " + in_quotes(path) +
                        " is the same in all load cases. What may differ are "
                        "'Gravity', 'Ambient temperature', masses and starts "
                        "of bodies, friction and "
                        "damping of joints, springs, drivers, forces, torques, "
                        "'Dynamics', the 'Duty cycle file' of bushings, and "
                        "the 'Wear coefficient factor'"));
        return paths;
      }



      double
      number_of_cycles(const LoadCase &load_case)
      {
        if (load_case.cycles > 0.)
          return load_case.cycles;
        return (load_case.duration > 0. ? load_case.duration
                                        : load_case.share) /
               load_case.period;
      }
    } // namespace



    void
    LoadCase::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_quantity(
        prm,
        "Cycles",
        cycles,
        "",
        "Cycles of this load case in a block, or, in sequence, in the whole "
        "run. Give this, 'Duration' or 'Share'.");
      Parameters::add_quantity(prm,
                               "Duration",
                               duration,
                               "s",
                               "Instead of 'Cycles': the time that they take.",
                               "h");
      Parameters::add_quantity(
        prm,
        "Share",
        share,
        "",
        "Instead of 'Cycles', for all load cases alike: the part of the "
        "operating time; their sum is one. Not in sequence.");
      Parameters::add_quantity(
        prm,
        "Wear coefficient factor",
        wear_factor,
        "",
        "Multiplies the wear coefficients of all bushings and pins in this "
        "load case: dirt, a lubricant, another temperature. All other "
        "subsections but those of materials and bushings may stand here again, "
        "with the entries that differ; of joints and bodies all but what "
        "they are and where.");
    }



    std::string
    LoadCase::subsection() const
    {
      return "Load case " + name;
    }



    void
    LoadCase::check() const
    {
      const auto check_not_negative = [this](const double       value,
                                             const std::string &entry,
                                             const std::string &si_unit,
                                             const std::string &unit) {
        AssertThrow(value >= 0.,
                    ExcParameter(subsection() + "/" + entry,
                                 Units::to_string(value, si_unit, unit) +
                                   " is negative"));
      };
      check_not_negative(cycles, "Cycles", "", "");
      check_not_negative(duration, "Duration", "s", "h");
      check_not_negative(share, "Share", "", "");
      check_not_negative(wear_factor, "Wear coefficient factor", "", "");
      const unsigned int n_given =
        (cycles > 0.) + (duration > 0.) + (share > 0.);
      AssertThrow(n_given > 0,
                  ExcParameter(subsection(),
                               "nothing says how often it comes; set 'Cycles', "
                               "'Duration' or 'Share'"));
      AssertThrow(n_given == 1,
                  ExcParameter(subsection() + "/Cycles",
                               "a load case has either 'Cycles', or "
                               "'Duration', or 'Share', but " +
                                 std::to_string(n_given) + " are given"));
    }



    ParameterFile
    file_of_load_case(const ParameterFile            &file,
                      const std::vector<std::string> &names,
                      const std::string              &name)
    {
      ParameterFile result = file;
      for (const std::string &other : names)
        {
          const std::string subsection = "Load case " + other;
          const auto        paths      = repeated_paths(file, subsection);
          result = other == name ? result.with_raised(subsection, paths)
                                 : result.without(subsection, paths);
        }
      return result;
    }



    ParameterFile
    file_of_all_load_cases(const ParameterFile            &file,
                           const std::vector<std::string> &names)
    {
      ParameterFile result = file;
      for (const std::string &name : names)
        {
          const std::string subsection = "Load case " + name;
          result = result.without(subsection, repeated_paths(file, subsection));
        }
      return result;
    }



    std::string
    print_repeated(const ParameterFile            &file,
                   const std::vector<std::string> &names)
    {
      std::string text;
      for (const std::string &name : names)
        {
          const std::string subsection = "Load case " + name;
          text += file.print(subsection,
                             repeated_paths(file, subsection),
                             {"Duty cycle file", "Table"});
        }
      return text;
    }



    Spectrum
    make_spectrum(const std::vector<LoadCase> &cases, const LoadCaseOrder order)
    {
      // Of the sum of shares: that of numbers with a few digits.
      constexpr double rounding = 1e-6;

      Spectrum spectrum;
      spectrum.order      = order;
      spectrum.has_blocks = order == LoadCaseOrder::repeated;
      spectrum.periods.clear();
      for (const LoadCase &load_case : cases)
        spectrum.periods.push_back(load_case.period);
      if (cases.size() == 1 && cases.front().name.empty())
        {
          spectrum.has_blocks = false;
          return spectrum;
        }
      spectrum.cycles.clear();
      double sum_of_shares = 0.;
      for (const LoadCase &load_case : cases)
        {
          load_case.check();
          if (load_case.share > 0.)
            {
              AssertThrow(order == LoadCaseOrder::repeated,
                          ExcParameter(load_case.subsection() + "/Share",
                                       "load cases in sequence have no shares "
                                       "of a block; give 'Cycles' or "
                                       "'Duration'"));
              spectrum.has_blocks = false;
            }
          AssertThrow(
            (load_case.share > 0.) == (cases.front().share > 0.),
            ExcParameter(
              (load_case.share > 0. ? load_case : cases.front()).subsection() +
                "/Share",
              "is given for some load cases, 'Cycles' or "
              "'Duration' for others; give all shares of "
              "the time, or none"));
          sum_of_shares += load_case.share;
          spectrum.cycles.push_back(number_of_cycles(load_case));
        }
      AssertThrow(cases.front().share == 0. ||
                    std::abs(sum_of_shares - 1.) <= rounding,
                  ExcParameter(cases.back().subsection() + "/Share",
                               "the shares of all load cases add up to " +
                                 significant_digits(sum_of_shares, 6) +
                                 "; their sum is one"));
      return spectrum;
    }
  } // namespace Coupling
} // namespace Tribody

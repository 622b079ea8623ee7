// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/parameter_handler.h>

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/base/in_quotes.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>

#include <algorithm>
#include <cctype>

namespace Tribody
{
  namespace
  {
    // Files and directories are named after names, and columns of tables.
    constexpr std::size_t max_name_length = 100;
    // Of a list; each has a subsection with all its parameters.
    constexpr std::size_t max_n_names = 5000;



    std::string
    point_to_string(const dealii::Point<2> &point,
                    const std::string      &si_unit,
                    const std::string      &shown_unit)
    {
      return Units::to_string(point[0], si_unit, shown_unit) + ", " +
             Units::to_string(point[1], si_unit, shown_unit);
    }



    dealii::Point<2>
    point_from_string(const std::string &text, const std::string &si_unit)
    {
      const std::vector<double> values = Units::list_from_string(text, si_unit);
      AssertThrow(values.size() == 2,
                  ExcInput(in_quotes(text) +
                           " must be two quantities separated "
                           "by a comma, for example '0 " +
                           si_unit + ", 1 " + si_unit + "'"));
      return {values[0], values[1]};
    }



    void
    check_name(const std::string &name)
    {
      const bool valid =
        !name.empty() && name.size() <= max_name_length &&
        std::all_of(name.begin(), name.end(), [](char c) {
          return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ||
                 c == '-' || c == '+';
        });
      AssertThrow(valid,
                  ExcInput(in_quotes(name) +
                           " is not a name; use letters, "
                           "digits, '_', '-' and '+', at most " +
                           std::to_string(max_name_length) + " of them"));
    }



    void
    check_marker_name(const std::string &name)
    {
      const std::string::size_type dot = name.find('.');
      AssertThrow(dot != std::string::npos,
                  ExcInput(in_quotes(name) +
                           " is not a marker; write <body>.<marker>"));
      check_name(name.substr(0, dot));
      check_name(name.substr(dot + 1));
    }
  } // namespace



  void
  Parameters::add_quantity(dealii::ParameterHandler &prm,
                           const std::string        &name,
                           double                   &value,
                           const std::string        &si_unit,
                           const std::string        &documentation,
                           const std::string        &shown_unit)
  {
    prm.declare_entry(name,
                      Units::to_string(value,
                                       si_unit,
                                       shown_unit.empty() ? si_unit
                                                          : shown_unit),
                      dealii::Patterns::Anything(),
                      documentation);
    prm.add_action(name,
                   [&value, si_unit, shown_unit](const std::string &text) {
                     value = Units::from_string(text, si_unit, shown_unit);
                   });
  }



  void
  Parameters::add_point(dealii::ParameterHandler &prm,
                        const std::string        &name,
                        dealii::Point<2>         &value,
                        const std::string        &si_unit,
                        const std::string        &documentation,
                        const std::string        &shown_unit)
  {
    prm.declare_entry(name,
                      point_to_string(value,
                                      si_unit,
                                      shown_unit.empty() ? si_unit
                                                         : shown_unit),
                      dealii::Patterns::Anything(),
                      documentation);
    prm.add_action(name, [&value, si_unit](const std::string &text) {
      value = point_from_string(text, si_unit);
    });
  }



  void
  Parameters::add_named_points(dealii::ParameterHandler                &prm,
                               const std::string                       &name,
                               std::map<std::string, dealii::Point<2>> &value,
                               const std::string                       &si_unit,
                               const std::string &documentation)
  {
    std::vector<std::string> defaults;
    for (const auto &[point_name, point] : value)
      defaults.push_back(point_name + ": " +
                         point_to_string(point, si_unit, si_unit));

    prm.declare_entry(name,
                      boost::algorithm::join(defaults, "; "),
                      dealii::Patterns::Anything(),
                      documentation);
    prm.add_action(name, [&value, si_unit](const std::string &text) {
      std::map<std::string, dealii::Point<2>> points;
      std::vector<std::string>                items;
      boost::algorithm::split(items, text, boost::algorithm::is_any_of(";"));
      for (const std::string &item : items)
        {
          if (boost::algorithm::trim_copy(item).empty())
            continue;
          const auto colon = item.find(':');
          AssertThrow(colon != std::string::npos,
                      ExcInput(in_quotes(boost::algorithm::trim_copy(item)) +
                               " must be a name, a colon and a position, "
                               "for example 'A: 0 " +
                               si_unit + ", 1 " + si_unit + "'"));
          const std::string point_name =
            boost::algorithm::trim_copy(item.substr(0, colon));
          check_name(point_name);
          const bool is_new =
            points
              .emplace(point_name,
                       point_from_string(item.substr(colon + 1), si_unit))
              .second;
          AssertThrow(is_new,
                      ExcInput("the name " + in_quotes(point_name) +
                               " is given twice"));
        }
      value = points;
    });
  }



  void
  Parameters::add_names(dealii::ParameterHandler &prm,
                        const std::string        &name,
                        std::vector<std::string> &value,
                        const std::string        &documentation,
                        const NameKind            kind)
  {
    prm.declare_entry(name,
                      boost::algorithm::join(value, ", "),
                      dealii::Patterns::Anything(),
                      documentation);
    prm.add_action(name, [&value, kind](const std::string &text) {
      value = split_names(text, kind);
    });
  }



  void
  Parameters::add_word(dealii::ParameterHandler       &prm,
                       const std::string              &name,
                       const std::string              &default_word,
                       const std::vector<std::string> &words,
                       const std::string              &documentation,
                       const std::function<void(const std::string &)> &action)
  {
    prm.declare_entry(name,
                      default_word,
                      dealii::Patterns::Anything(),
                      documentation + " One of: " +
                        boost::algorithm::join(words, " | ") + ".");
    prm.add_action(name, action);
  }



  void
  Parameters::add_text(dealii::ParameterHandler &prm,
                       const std::string        &name,
                       std::string              &value,
                       const std::string        &documentation)
  {
    prm.declare_entry(name, value, dealii::Patterns::Anything(), documentation);
    prm.add_action(name, [&value](const std::string &text) { value = text; });
  }



  void
  Parameters::add_integer(dealii::ParameterHandler &prm,
                          const std::string        &name,
                          unsigned int             &value,
                          const std::string        &documentation,
                          const unsigned int        minimum,
                          const unsigned int        maximum)
  {
    prm.declare_entry(name,
                      std::to_string(value),
                      dealii::Patterns::Anything(),
                      documentation);
    prm.add_action(name, [&value, minimum, maximum](const std::string &text) {
      const std::string problem =
        in_quotes(text) + " is not a whole number from " +
        std::to_string(minimum) + " to " + std::to_string(maximum);
      AssertThrow(!text.empty() && text.size() < 18 &&
                    std::all_of(text.begin(),
                                text.end(),
                                [](unsigned char c) {
                                  return std::isdigit(c) != 0;
                                }),
                  ExcInput(problem));
      const unsigned long long number = std::stoull(text);
      AssertThrow(number >= minimum && number <= maximum, ExcInput(problem));
      value = static_cast<unsigned int>(number);
    });
  }



  std::vector<std::string>
  split_names(const std::string &text, const NameKind kind)
  {
    std::vector<std::string> parts;
    boost::algorithm::split(parts, text, boost::algorithm::is_any_of(","));

    std::vector<std::string> names;
    for (std::string &part : parts)
      {
        boost::algorithm::trim(part);
        if (part.empty())
          continue;
        kind == NameKind::marker ? check_marker_name(part) : check_name(part);
        AssertThrow(std::find(names.begin(), names.end(), part) == names.end(),
                    ExcInput("the name " + in_quotes(part) +
                             " is given twice"));
        names.push_back(part);
        AssertThrow(names.size() <= max_n_names,
                    ExcInput("more than " + std::to_string(max_n_names) +
                             " names, the first of them " +
                             in_quotes(names.front())));
      }
    return names;
  }
} // namespace Tribody

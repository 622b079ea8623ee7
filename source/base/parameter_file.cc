// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/parameter_handler.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim_all.hpp>
#include <nlohmann/json.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/base/parameter_file.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>

namespace Tribody
{
  namespace
  {
    // Included files that include further ones: deeper than this is a circle.
    constexpr unsigned int max_include_depth = 16;



    std::vector<std::string>
    split_path(const std::string &path)
    {
      std::vector<std::string> parts;
      boost::algorithm::split(parts, path, boost::algorithm::is_any_of("/"));
      for (std::string &part : parts)
        boost::algorithm::trim_all(part);
      return parts;
    }



    // Levenshtein's edit distance, ignoring case.
    unsigned int
    edit_distance(const std::string &first, const std::string &second)
    {
      const std::string a = boost::algorithm::to_lower_copy(first);
      const std::string b = boost::algorithm::to_lower_copy(second);

      std::vector<unsigned int> row(b.size() + 1);
      std::iota(row.begin(), row.end(), 0U);
      for (std::size_t i = 0; i < a.size(); ++i)
        {
          unsigned int diagonal = row[0];
          row[0]                = static_cast<unsigned int>(i) + 1;
          for (std::size_t j = 0; j < b.size(); ++j)
            {
              const unsigned int substitution =
                diagonal + (a[i] == b[j] ? 0U : 1U);
              diagonal   = row[j + 1];
              row[j + 1] = std::min({substitution, row[j] + 1, diagonal + 1});
            }
        }
      return row.back();
    }



    // The declared parameters and subsections as a tree. ParameterHandler
    // shows it only by printing.
    nlohmann::json
    declared_tree(dealii::ParameterHandler &prm)
    {
      std::stringstream stream;
      prm.print_parameters(stream, dealii::ParameterHandler::ShortJSON);
      return nlohmann::json::parse(stream);
    }



    std::vector<std::string>
    keys(const nlohmann::json &tree, const bool subsections)
    {
      std::vector<std::string> names;
      for (const auto &item : tree.items())
        if (item.value().is_object() == subsections)
          names.push_back(item.key());
      return names;
    }



    std::string
    suggestion(const std::string              &word,
               const std::vector<std::string> &candidates)
    {
      if (candidates.empty())
        return "nothing is valid here";
      const std::string nearest = nearest_names(word, candidates);
      if (!nearest.empty())
        return "did you mean " + nearest + "?";
      return "valid are: " + boost::algorithm::join(candidates, ", ");
    }



    // "Body crank" is valid once "crank" stands in the list "Bodies".
    std::string
    list_hint(const std::string               &subsection,
              const ParameterFile::NamedLists &lists)
    {
      for (const auto &[kind, list] : lists)
        if (boost::algorithm::starts_with(subsection, kind + " "))
          return " (a name must stand in 'set " + list +
                 " = ...' before it has a subsection)";
      return "";
    }



    // Throw ExcInput unless the assignment's place exists in the tree.
    void
    check_declared(const nlohmann::json            &tree,
                   const ParameterFile::NamedLists &lists,
                   const std::vector<std::string>  &subsections,
                   const std::string               &name,
                   const std::string               &location)
    {
      const nlohmann::json *level = &tree;
      std::string           where = "the top level";
      for (const std::string &subsection : subsections)
        {
          const auto next = level->find(subsection);
          AssertThrow(next != level->end() && next->is_object(),
                      ExcInput(location + ": there is no subsection '" +
                               subsection + "' in " + where + "; " +
                               suggestion(subsection, keys(*level, true)) +
                               list_hint(subsection, lists)));
          level = &*next;
          where = "subsection '" + subsection + "'";
        }

      const auto entry = level->find(name);
      AssertThrow(entry != level->end() && !entry->is_object(),
                  ExcInput(location + ": there is no parameter '" + name +
                           "' in " + where + "; " +
                           suggestion(name, keys(*level, false))));
    }



    // One line without comment and surplus blanks; a trailing backslash joins
    // the next line. Returns false at the end of the file.
    bool
    read_logical_line(std::istream &stream,
                      std::string  &line,
                      unsigned int &line_number)
    {
      line.clear();
      std::string part;
      while (std::getline(stream, part))
        {
          ++line_number;
          part = part.substr(0, part.find('#'));
          std::replace(part.begin(), part.end(), '\t', ' ');
          boost::algorithm::trim_right(part);
          const bool continued = !part.empty() && part.back() == '\\';
          if (continued)
            part.pop_back();
          line += part;
          if (!continued)
            {
              boost::algorithm::trim_all(line);
              return true;
            }
        }
      boost::algorithm::trim_all(line);
      return !line.empty();
    }
  } // namespace



  std::string
  nearest_names(const std::string              &word,
                const std::vector<std::string> &candidates)
  {
    // A third of the letters may be wrong: more is another word.
    const auto   limit = static_cast<unsigned int>(word.size() / 3 + 1);
    unsigned int best  = limit + 1;
    std::vector<std::string> nearest;
    for (const std::string &candidate : candidates)
      {
        const unsigned int distance = edit_distance(word, candidate);
        if (distance < best)
          {
            best = distance;
            nearest.clear();
          }
        if (distance == best && distance <= limit)
          nearest.push_back("'" + candidate + "'");
      }
    return boost::algorithm::join(nearest, " or ");
  }



  ParameterFile::ParameterFile(const std::string              &file_name,
                               const std::vector<std::string> &overrides)
    : file_name(file_name)
  {
    read(file_name, 0);
    for (const std::string &text : overrides)
      add_override(text);
  }



  void
  ParameterFile::read(const std::string &file_name, const unsigned int depth)
  {
    AssertThrow(depth < max_include_depth,
                ExcInput("'" + file_name + "' is included by itself."));
    AssertThrow(!std::filesystem::is_directory(file_name),
                ExcInput("'" + file_name +
                         "' is a directory, not a "
                         "parameter file."));
    std::ifstream stream(file_name);
    AssertThrow(stream,
                ExcInput("Cannot read the parameter file '" + file_name +
                         "'."));

    const std::size_t depth_at_start = open_subsections.size();
    unsigned int      line_number    = 0;
    std::string       line;
    while (read_logical_line(stream, line, line_number))
      {
        if (line.empty())
          continue;
        const std::string location =
          file_name + ":" + std::to_string(line_number);
        const auto        blank = line.find(' ');
        const std::string keyword =
          boost::algorithm::to_lower_copy(line.substr(0, blank));
        const std::string rest =
          (blank == std::string::npos ? "" : line.substr(blank + 1));

        if (keyword == "set")
          {
            const auto equals = rest.find('=');
            AssertThrow(equals != std::string::npos,
                        ExcInput(location + ": '" + line +
                                 "' has no '='; "
                                 "write 'set name = value'"));
            assignments.push_back(
              {open_subsections,
               boost::algorithm::trim_copy(rest.substr(0, equals)),
               boost::algorithm::trim_copy(rest.substr(equals + 1)),
               location});
          }
        else if (keyword == "subsection" && !rest.empty())
          open_subsections.push_back(rest);
        else if (keyword == "end" && rest.empty())
          {
            AssertThrow(open_subsections.size() > depth_at_start,
                        ExcInput(location + ": 'end' without 'subsection'"));
            open_subsections.pop_back();
          }
        else if (keyword == "include" && !rest.empty())
          {
            const std::filesystem::path included =
              std::filesystem::path(file_name).parent_path() / rest;
            AssertThrow(std::filesystem::exists(included),
                        ExcInput(location + ": the included file '" +
                                 included.string() + "' does not exist"));
            read(included.string(), depth + 1);
          }
        else
          AssertThrow(false,
                      ExcInput(location + ": '" + line +
                               "' is not understood; a line is 'set name = "
                               "value', 'subsection name', 'end', 'include "
                               "file' or a comment behind '#'"));
      }

    AssertThrow(open_subsections.size() == depth_at_start,
                ExcInput(file_name + ":" + std::to_string(line_number) +
                         ": the file ends inside subsection '" +
                         open_subsections.back() + "'; an 'end' is missing"));
  }



  void
  ParameterFile::add_override(const std::string &text)
  {
    const auto equals = text.find('=');
    AssertThrow(equals != std::string::npos,
                ExcInput("--set '" + text +
                         "': write --set \"Subsection/"
                         "name=value\""));

    std::vector<std::string> path = split_path(text.substr(0, equals));
    const std::string        name = path.back();
    path.pop_back();
    assignments.push_back({path,
                           name,
                           boost::algorithm::trim_copy(text.substr(equals + 1)),
                           "--set"});
  }



  void
  ParameterFile::apply(dealii::ParameterHandler &prm,
                       const NamedLists         &lists) const
  {
    const nlohmann::json tree = declared_tree(prm);
    for (const Assignment &assignment : assignments)
      {
        check_declared(tree,
                       lists,
                       assignment.subsections,
                       assignment.name,
                       assignment.location);

        for (const std::string &subsection : assignment.subsections)
          prm.enter_subsection(subsection);
        try
          {
            prm.set(assignment.name, assignment.value);
          }
        catch (const ExcInput &exception)
          {
            std::vector<std::string> path = assignment.subsections;
            path.push_back(assignment.name);
            throw ExcInput(assignment.location + ": " +
                           boost::algorithm::join(path, "/") + ": " +
                           message_of(exception));
          }
        for (std::size_t i = 0; i < assignment.subsections.size(); ++i)
          prm.leave_subsection();
      }
  }



  const ParameterFile::Assignment *
  ParameterFile::find(const std::string &path) const
  {
    std::vector<std::string> subsections = split_path(path);
    const std::string        name        = subsections.back();
    subsections.pop_back();

    const auto last =
      std::find_if(assignments.rbegin(),
                   assignments.rend(),
                   [&](const Assignment &assignment) {
                     return assignment.name == name &&
                            assignment.subsections == subsections;
                   });
    return last == assignments.rend() ? nullptr : &*last;
  }



  std::string
  ParameterFile::value(const std::string &path,
                       const std::string &default_value) const
  {
    const Assignment *assignment = find(path);
    return assignment == nullptr ? default_value : assignment->value;
  }



  std::string
  ParameterFile::location(const std::string &path) const
  {
    if (const Assignment *assignment = find(path))
      return assignment->location;

    const std::vector<std::string> subsections = split_path(path);
    for (const Assignment &assignment : assignments)
      if (assignment.subsections == subsections)
        return assignment.location;
    return file_name + " (default value)";
  }
} // namespace Tribody

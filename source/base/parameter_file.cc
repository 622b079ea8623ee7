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
#include <tribody/base/in_quotes.h>
#include <tribody/base/parameter_file.h>
#include <tribody/base/whole_file.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <numeric>
#include <set>
#include <sstream>
#include <system_error>

namespace Tribody
{
  namespace
  {
    // Included files that include further ones: deeper than this is a circle.
    constexpr unsigned int max_include_depth = 16;
    // Files that include others several times multiply.
    constexpr unsigned int max_n_files = 1000;
    // Of all files together, and of a line with its continuations: no case
    // comes near, a file that is none does.
    constexpr std::size_t max_n_bytes_of_case = 64 << 20,
                          max_line_length     = 1 << 20;
    // In lists of what is valid and of what may be meant.
    constexpr std::size_t max_n_listed = 20, max_n_nearest = 5;
    // Longer words are none of ours.
    constexpr std::size_t max_word_length = 200;



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
    // shows it only by printing; in its JSON a dot in a name, "Watched marker
    // slider.B", is a level more.
    nlohmann::json
    declared_tree(dealii::ParameterHandler &prm)
    {
      const std::string subsection = "subsection ", entry = "set ";
      std::stringstream stream;
      prm.print_parameters(stream, dealii::ParameterHandler::ShortPRM);
      nlohmann::json                tree = nlohmann::json::object();
      std::vector<nlohmann::json *> open = {&tree};
      for (std::string line; std::getline(stream, line);)
        {
          boost::algorithm::trim(line);
          if (boost::algorithm::starts_with(line, subsection))
            open.push_back(&(*open.back())[line.substr(subsection.size())]);
          else if (line == "end")
            open.pop_back();
          else if (boost::algorithm::starts_with(line, entry))
            (*open.back())[boost::algorithm::trim_copy(
              line.substr(entry.size(), line.find('=') - entry.size()))] = "";
        }
      return tree;
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
      std::vector<std::string> listed = candidates;
      if (listed.size() > max_n_listed)
        {
          listed.resize(max_n_listed);
          listed.emplace_back("...");
        }
      return "valid are: " + boost::algorithm::join(listed, ", ");
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



    // The file @p name that is named at @p location, "file.prm:12" or "--set".
    std::string
    beside(const std::string &location, const std::string &name)
    {
      return (std::filesystem::path(location).parent_path() / name).string();
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
                      ExcInput(location + ": there is no subsection " +
                               in_quotes(subsection) + " in " + where + "; " +
                               suggestion(subsection, keys(*level, true)) +
                               list_hint(subsection, lists)));
          level = &*next;
          where = "subsection '" + subsection + "'";
        }

      const auto entry = level->find(name);
      AssertThrow(entry != level->end() && !entry->is_object(),
                  ExcInput(location + ": there is no parameter " +
                           in_quotes(name) + " in " + where + "; " +
                           suggestion(name, keys(*level, false))));
    }



    // At most @p max_n_bytes.
    std::string
    read_text(const std::string &file_name,
              const std::string &place,
              const std::size_t  max_n_bytes)
    {
      std::string text =
        read_regular_file(file_name, "parameter file", place, max_n_bytes);
      AssertThrow(text.size() <= max_n_bytes,
                  ExcInput(place + in_quotes(file_name) +
                           " is too long for a parameter file: with all that "
                           "is included there may be " +
                           std::to_string(max_n_bytes_of_case >> 20) + " MB."));
      return text;
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
      while (line.size() <= max_line_length && std::getline(stream, part))
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
  full_path(const std::string &file_name)
  {
    std::error_code             error;
    const std::filesystem::path absolute =
      std::filesystem::absolute(file_name, error);
    return error ? file_name : absolute.lexically_normal().string();
  }



  std::string
  nearest_names(const std::string              &word,
                const std::vector<std::string> &candidates)
  {
    if (word.size() > max_word_length)
      return "";
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
    nearest.resize(std::min(nearest.size(), max_n_nearest));
    return boost::algorithm::join(nearest, " or ");
  }



  ParameterFile::ParameterFile(const std::string              &file_name,
                               const std::vector<std::string> &overrides)
    : file_name(file_name)
  {
    read(file_name, 0, "");
    for (const std::string &text : overrides)
      add_override(text);
    index_assignments();
  }



  void
  ParameterFile::index_assignments()
  {
    last_of_path.clear();
    first_of_subsection.clear();
    for (std::size_t i = 0; i < assignments.size(); ++i)
      {
        std::vector<std::string> subsections;
        for (const std::string &subsection : assignments[i].subsections)
          {
            subsections.push_back(subsection);
            first_of_subsection.emplace(joined(subsections), i);
          }
        last_of_path[path_of(assignments[i])] = i;
      }
  }



  void
  ParameterFile::read(const std::string &file_name,
                      const unsigned int depth,
                      const std::string &place)
  {
    AssertThrow(depth < max_include_depth,
                ExcInput(in_quotes(file_name) + " is included by itself."));
    AssertThrow(++n_files <= max_n_files,
                ExcInput(place + "more than " + std::to_string(max_n_files) +
                         " files are included, some of them again and again."));
    const std::string text =
      read_text(file_name, place, max_n_bytes_of_case - n_bytes);
    n_bytes += text.size();
    std::istringstream stream(text);

    const std::size_t depth_at_start = open_subsections.size();
    unsigned int      line_number    = 0;
    std::string       line;
    while (read_logical_line(stream, line, line_number))
      if (!line.empty())
        {
          const std::string location =
            file_name + ":" + std::to_string(line_number);
          AssertThrow(line.size() <= max_line_length,
                      ExcInput(location + ": " + in_quotes(line) +
                               " is a line of more than " +
                               std::to_string(max_line_length) +
                               " characters"));
          read_line(line, location, depth_at_start, depth);
        }

    AssertThrow(open_subsections.size() == depth_at_start,
                ExcInput(file_name + ":" + std::to_string(line_number) +
                         ": the file ends inside subsection " +
                         in_quotes(open_subsections.back()) +
                         "; an 'end' is missing"));
  }



  void
  ParameterFile::read_line(const std::string &line,
                           const std::string &location,
                           const std::size_t  depth_at_start,
                           const unsigned int depth)
  {
    const auto        blank = line.find(' ');
    const std::string keyword =
      boost::algorithm::to_lower_copy(line.substr(0, blank));
    const std::string rest =
      (blank == std::string::npos ? "" : line.substr(blank + 1));

    if (keyword == "set")
      {
        const auto equals = rest.find('=');
        AssertThrow(equals != std::string::npos,
                    ExcInput(location + ": " + in_quotes(line) +
                             " has no '='; "
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
        const std::string included = beside(location, rest);
        std::error_code   error;
        AssertThrow(std::filesystem::exists(included, error) || error,
                    ExcInput(location + ": the included file " +
                             in_quotes(included) + " does not exist"));
        read(included, depth + 1, location + ": ");
      }
    else
      AssertThrow(false,
                  ExcInput(location + ": " + in_quotes(line) +
                           " is not understood; a line is 'set name = "
                           "value', 'subsection name', 'end', 'include "
                           "file' or a comment behind '#'"));
  }



  void
  ParameterFile::add_override(const std::string &text)
  {
    // It must be a line of parameters.prm, in which others find it again.
    const bool is_a_line =
      text.find('#') == std::string::npos &&
      std::none_of(text.begin(), text.end(), [](const char c) {
        return std::iscntrl(static_cast<unsigned char>(c)) != 0;
      });
    AssertThrow(is_a_line && (text.empty() || text.back() != '\\'),
                ExcInput("--set " + in_quotes(text) +
                         ": a value is one line without control characters, "
                         "'#' and a backslash at its end"));
    const auto equals = text.find('=');
    AssertThrow(equals != std::string::npos,
                ExcInput("--set " + in_quotes(text) +
                         ": write --set \"Subsection/"
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
            throw ExcInput(assignment.location + ": " + joined(path) + ": " +
                           message_of(exception));
          }
        for (std::size_t i = 0; i < assignment.subsections.size(); ++i)
          prm.leave_subsection();
      }
  }



  std::string
  ParameterFile::joined(const std::vector<std::string> &subsections)
  {
    return boost::algorithm::join(subsections, "/");
  }



  std::string
  ParameterFile::path_of(const Assignment &assignment)
  {
    return joined(assignment.subsections) + "/" + assignment.name;
  }



  const ParameterFile::Assignment *
  ParameterFile::find(const std::string &path) const
  {
    std::vector<std::string> subsections = split_path(path);
    const std::string        name        = subsections.back();
    subsections.pop_back();
    const auto last = last_of_path.find(joined(subsections) + "/" + name);
    return last == last_of_path.end() ? nullptr : &assignments[last->second];
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
    const auto first = first_of_subsection.find(joined(split_path(path)));
    return first == first_of_subsection.end()
             ? file_name + " (default value)"
             : assignments[first->second].location;
  }



  std::string
  ParameterFile::path_within(const std::string &subsection,
                             const Assignment  &assignment)
  {
    const std::string path   = path_of(assignment);
    const std::string prefix = subsection + "/";
    return boost::algorithm::starts_with(path, prefix)
             ? path.substr(prefix.size())
             : "";
  }



  std::vector<std::string>
  ParameterFile::paths_in(const std::string &subsection) const
  {
    std::set<std::string> paths;
    for (const Assignment &assignment : assignments)
      if (const std::string path = path_within(subsection, assignment);
          !path.empty())
        paths.insert(path);
    return {paths.begin(), paths.end()};
  }



  std::array<std::vector<ParameterFile::Assignment>, 2>
  ParameterFile::split(const std::string              &subsection,
                       const std::vector<std::string> &paths) const
  {
    std::array<std::vector<Assignment>, 2> parts;
    for (const Assignment &assignment : assignments)
      {
        const std::string path = path_within(subsection, assignment);
        const bool is_named = std::count(paths.begin(), paths.end(), path) > 0;
        parts[is_named ? 1 : 0].push_back(assignment);
      }
    return parts;
  }



  ParameterFile
  ParameterFile::without(const std::string              &subsection,
                         const std::vector<std::string> &paths) const
  {
    ParameterFile result = *this;
    result.assignments   = split(subsection, paths)[0];
    result.index_assignments();
    return result;
  }



  ParameterFile
  ParameterFile::with_raised(const std::string              &subsection,
                             const std::vector<std::string> &paths) const
  {
    ParameterFile     result = *this;
    auto              parts  = split(subsection, paths);
    const std::size_t depth  = split_path(subsection).size();
    for (Assignment &assignment : parts[1])
      {
        assignment.subsections.erase(assignment.subsections.begin(),
                                     assignment.subsections.begin() + depth);
        parts[0].push_back(assignment);
      }
    result.assignments = parts[0];
    result.index_assignments();
    return result;
  }



  std::string
  ParameterFile::print(const std::string              &subsection,
                       const std::vector<std::string> &paths,
                       const std::vector<std::string> &file_entries) const
  {
    std::ostringstream text;
    const auto         parts = split(subsection, paths);
    for (const Assignment &assignment : parts[1])
      {
        for (const std::string &name : assignment.subsections)
          text << "subsection " << name << '\n';
        const bool is_file =
          !assignment.value.empty() && std::count(file_entries.begin(),
                                                  file_entries.end(),
                                                  assignment.name) > 0;
        text << "  set " << assignment.name << " = "
             << (is_file
                   ? full_path(beside(assignment.location, assignment.value))
                   : assignment.value)
             << '\n';
        for (std::size_t i = 0; i < assignment.subsections.size(); ++i)
          text << "end\n";
      }
    return text.str();
  }



  std::string
  ParameterFile::file_named_by(const std::string &path) const
  {
    return beside(location(path), value(path, ""));
  }
} // namespace Tribody

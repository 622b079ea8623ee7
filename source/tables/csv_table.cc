// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <boost/token_functions.hpp>
#include <boost/tokenizer.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/base/in_quotes.h>
#include <tribody/base/parameter_file.h>
#include <tribody/base/units.h>
#include <tribody/base/whole_file.h>
#include <tribody/tables/csv_table.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace Tribody
{
  namespace
  {
    // As for parameter files: no table comes near, a file that is none does.
    constexpr std::size_t max_n_bytes = 64 << 20;
    // In lists of what is valid.
    constexpr std::size_t max_n_listed = 20;



    // A file's text without a byte order mark.
    std::string
    read_text(const std::string &file_name)
    {
      std::string text = read_regular_file(file_name, "table", "", max_n_bytes);
      AssertThrow(text.size() <= max_n_bytes,
                  ExcInput(in_quotes(file_name) +
                           " is too long for a table: there may be " +
                           std::to_string(max_n_bytes >> 20) + " MB."));
      AssertThrow(text.find('\0') == std::string::npos,
                  ExcInput(in_quotes(file_name) +
                           " is no text (a spreadsheet, or two bytes for each "
                           "character?); export it as CSV in UTF-8."));
      const std::string byte_order_mark = "\xEF\xBB\xBF";
      return boost::algorithm::starts_with(text, byte_order_mark)
               ? text.substr(byte_order_mark.size())
               : text;
    }



    // Fields without the blanks around them. A backslash is a character like
    // others.
    std::vector<std::string>
    split(const std::string &line, const char separator)
    {
      const boost::escaped_list_separator<char> at("",
                                                   std::string(1, separator),
                                                   "\"");
      std::vector<std::string>                  fields;
      for (std::string field : boost::tokenizer(line, at))
        {
          boost::algorithm::trim(field);
          fields.push_back(std::move(field));
        }
      return fields;
    }



    // The one with which most columns have a unit: names and units may have a
    // comma themselves, and a comma a tab behind it.
    char
    find_separator(const std::string &header)
    {
      const auto n_columns = [&header](const char separator) {
        const std::vector<std::string> fields = split(header, separator);
        const auto                     n_units =
          std::count_if(fields.begin(),
                        fields.end(),
                        [](const std::string &field) {
                          return boost::algorithm::ends_with(field, "]");
                        });
        return std::make_pair(static_cast<std::size_t>(n_units), fields.size());
      };
      char best = ',';
      for (const char separator : {';', '\t'})
        if (n_columns(separator) > n_columns(best))
          best = separator;
      return best;
    }



    // @p text is a number altogether; what is too small to be told from 0 is 0.
    bool
    read_number(const std::string &text, double &number)
    {
      const std::size_t sign =
        text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0;
      const char *const end = text.data() + text.size();
      const auto [rest, error] =
        std::from_chars(text.data() + sign, end, number);
      if (error == std::errc::result_out_of_range)
        {
          const bool is_small = text.find("e-") != std::string::npos ||
                                text.find("E-") != std::string::npos;
          number = is_small ? 0. : std::numeric_limits<double>::infinity();
          return rest == end;
        }
      return error == std::errc() && rest == end;
    }



    // In the SI unit: factor * value + offset.
    struct Conversion
    {
      double factor, offset;
    };



    /// @throws ExcInput for a unit that does not fit, without the place.
    Conversion
    find_conversion(const std::string &unit,
                    const std::string &si_unit,
                    const std::string &usual_unit)
    {
      const std::string shown = usual_unit.empty() ? si_unit : usual_unit;
      if (si_unit.empty())
        {
          AssertThrow(unit == "-" || unit == "1" || unit == "%",
                      ExcInput(
                        unit.empty()
                          ? std::string("has no unit; write '[-]' behind "
                                        "the name of a pure number")
                          : in_quotes(unit) +
                              " is the unit of what must be a pure "
                              "number, '[-]' or '[%]'"));
          return {unit == "%" ? 0.01 : 1., 0.};
        }
      AssertThrow(!unit.empty(),
                  ExcInput("has no unit; write it in brackets behind the name, "
                           "for example '[" +
                           shown + "]'"));
      AssertThrow(unit != "-",
                  ExcInput("'-' is a pure number; a unit such as '" + shown +
                           "' is needed"));
      const auto in_si_units = [&](const std::string &number) {
        return Units::from_string(number + " " + unit, si_unit, shown);
      };
      const double one = in_si_units("1"), offset = in_si_units("0");
      // Far from the zero of a temperature, so that nothing of its size is lost
      // in the difference.
      constexpr double far = 1e4;
      return {offset == 0. ? one : (in_si_units("1e4") - offset) / far, offset};
    }



    std::string
    describe_numbers(const std::size_t n, const std::string &what)
    {
      return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
    }
  } // namespace



  CsvTable::CsvTable(const std::string &file_name)
    : name_of_file(file_name)
  {
    std::istringstream stream(read_text(file_name));
    Line               line = {0, ""};
    while (std::getline(stream, line.text))
      {
        ++line.number;
        // Tabs at the ends are separators of empty fields.
        boost::algorithm::trim_if(line.text,
                                  boost::algorithm::is_any_of(" \r"));
        if (boost::algorithm::all(line.text, boost::algorithm::is_space()) ||
            boost::algorithm::trim_left_copy(line.text)[0] == '#')
          continue;
        if (names.empty())
          {
            read_header(line);
            continue;
          }
        const std::size_t n = fields_of(line).size();
        AssertThrow(n == names.size(),
                    ExcInput(location_of(line) + ": has " +
                             describe_numbers(n, "field") + ", but line " +
                             std::to_string(header.number) + " names " +
                             describe_numbers(names.size(), "column") +
                             (n > names.size() && separator == ','
                                ? "; decimals are written with a point"
                                : "")));
        rows.push_back(line);
      }
    AssertThrow(!names.empty(),
                ExcInput(in_quotes(file_name) +
                         " has no header; the first line names the columns "
                         "with their units, for example 'time [s], force "
                         "[N]'."));
    AssertThrow(!rows.empty(),
                ExcInput(header_location() +
                         ": there are no rows below the names of the columns"));
  }



  void
  CsvTable::read_header(const Line &line)
  {
    header                = line;
    separator             = find_separator(line.text);
    const auto fields     = fields_of(line);
    double     number     = 0.;
    const bool has_number = std::any_of(fields.begin(),
                                        fields.end(),
                                        [&number](const std::string &field) {
                                          return read_number(field, number);
                                        });
    AssertThrow(!has_number,
                ExcInput(header_location() + ": " + in_quotes(line.text) +
                         " has numbers where the columns must be named with "
                         "their units, for example 'time [s], force [N]'"));
    for (const std::string &field : fields)
      {
        const auto bracket  = field.rfind('[');
        const bool has_unit = bracket != std::string::npos &&
                              boost::algorithm::ends_with(field, "]");
        names.push_back(boost::algorithm::trim_copy(
          has_unit ? field.substr(0, bracket) : field));
        units.push_back(
          has_unit ? boost::algorithm::trim_copy(
                       field.substr(bracket + 1, field.size() - bracket - 2))
                   : "");
        AssertThrow(!names.back().empty(),
                    ExcInput(header_location() + ": column " +
                             std::to_string(names.size()) + " has no name"));
        AssertThrow(std::count(names.begin(), names.end(), names.back()) == 1,
                    ExcInput(header_location() + ": there are two columns " +
                             in_quotes(names.back())));
      }
  }



  std::vector<std::string>
  CsvTable::fields_of(const Line &line) const
  {
    return split(line.text, separator);
  }



  std::string
  CsvTable::location_of(const Line &line) const
  {
    return name_of_file + ":" + std::to_string(line.number);
  }



  std::string
  CsvTable::header_location() const
  {
    return location_of(header);
  }



  std::string
  CsvTable::location(const Eigen::Index row) const
  {
    AssertIndexRange(row, n_rows());
    return location_of(rows[row]);
  }



  bool
  CsvTable::has_column(const std::string &name) const
  {
    return std::find(names.begin(), names.end(), name) != names.end();
  }



  std::size_t
  CsvTable::find_column(const std::string &name) const
  {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      {
        const std::string nearest = nearest_names(name, names);
        auto              listed  = names;
        if (listed.size() > max_n_listed)
          {
            listed.resize(max_n_listed);
            listed.emplace_back("...");
          }
        throw ExcInput(
          header_location() + ": there is no column " + in_quotes(name) +
          (nearest.empty()
             ? "; there are: " + boost::algorithm::join(listed, ", ")
             : "; did you mean " + nearest + "?"));
      }
    return found - names.begin();
  }



  Eigen::VectorXd
  CsvTable::column(const std::string &name,
                   const std::string &si_unit,
                   const std::string &usual_unit) const
  {
    const std::size_t place = find_column(name);
    const std::string words = ": column " + in_quotes(name);

    Conversion conversion = {1., 0.};
    try
      {
        conversion = find_conversion(units[place], si_unit, usual_unit);
      }
    catch (const ExcInput &exception)
      {
        throw ExcInput(header_location() + words + ": " +
                       message_of(exception));
      }

    Eigen::VectorXd values(n_rows());
    for (Eigen::Index i = 0; i < n_rows(); ++i)
      {
        const std::string text  = fields_of(rows[i])[place];
        double            value = 0.;
        AssertThrow(!text.empty(),
                    ExcInput(location(i) + words + " has a gap here"));
        AssertThrow(read_number(text, value),
                    ExcInput(location(i) + words + ": " + in_quotes(text) +
                             " is not a number" +
                             (text.find(',') != std::string::npos
                                ? " (a decimal comma? Write 0.5, not 0,5)"
                                : "")));
        values[i] = conversion.factor * value + conversion.offset;
        AssertThrow(std::isfinite(values[i]),
                    ExcInput(location(i) + words + ": " + in_quotes(text) +
                             " is not a finite number"));
      }
    return values;
  }
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/base/in_quotes.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/tables/csv_table.h>
#include <tribody/tables/table_parameters.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace
  {
    // The column that each table must have.
    const std::string time_column = "time";

    // Of the period, and of the largest value: roundings of the file's decimals
    // and of units.
    constexpr double rounding = 1e-9;



    // "3 columns beside 'time': a, b, c".
    std::string
    describe_columns(const std::vector<std::string> &names)
    {
      return std::to_string(names.size()) + " columns beside '" + time_column +
             "'" + (names.empty() ? "" : ": ") +
             boost::algorithm::join(names, ", ");
    }



    std::vector<std::string>
    find_names(const std::string               &path,
               const TableParameters           &parameters,
               const CsvTable                  &table,
               const TableParameters::Quantity &quantity)
    {
      const std::string        entry = path + "/Table column";
      std::vector<std::string> names;
      if (boost::algorithm::trim_copy(parameters.columns).empty())
        {
          for (const std::string &name : table.column_names())
            if (name != time_column)
              names.push_back(name);
          AssertThrow(!names.empty() && names.size() <= quantity.most_columns,
                      ExcParameter(entry,
                                   "is empty, and " +
                                     in_quotes(parameters.file) + " has " +
                                     describe_columns(names) + "; name " +
                                     quantity.wanted));
          return names;
        }
      boost::algorithm::split(names,
                              parameters.columns,
                              boost::algorithm::is_any_of(","));
      for (std::string &name : names)
        boost::algorithm::trim(name);
      AssertThrow(names.size() <= quantity.most_columns,
                  ExcParameter(entry,
                               in_quotes(parameters.columns) + " names " +
                                 std::to_string(names.size()) +
                                 " columns; name " + quantity.wanted));
      return names;
    }



    /// @throws ExcInput with the line unless they rise.
    void
    check_times(const CsvTable &table, const Eigen::VectorXd &times)
    {
      for (Eigen::Index i = 1; i < times.size(); ++i)
        AssertThrow(times[i] > times[i - 1],
                    ExcInput(table.location(i) + ": column '" + time_column +
                             "' must rise from row to row, but " +
                             Units::to_string(times[i], "s", "s") +
                             " stands below " +
                             Units::to_string(times[i - 1], "s", "s")));
    }



    // "the last row must repeat the first one, ...".
    std::string
    describe_end(const TableParameters::Quantity &quantity)
    {
      return std::string("The last row must repeat the first one") +
             (quantity.turn != 0. ? " or be whole turns further" : "") +
             ", one period later; where it does not, 'Table period' says when "
             "the first one comes again";
    }



    // Let @p values, with a row for each time or without the last one, end as
    // they begin. @throws ExcInput with the line.
    void
    close(const CsvTable                  &table,
          const std::string               &name,
          const TableParameters::Quantity &quantity,
          const Eigen::Index               n_times,
          Eigen::VectorXd                 &values)
    {
      const Eigen::Index last = values.size() - 1;
      if (values.size() < n_times)
        {
          // An angle that goes on comes again some turns further.
          double first = values[0];
          if (quantity.turn != 0.)
            first += quantity.turn *
                     std::round((values[last] - first) / quantity.turn);
          values.conservativeResize(n_times);
          values[n_times - 1] = first;
          return;
        }
      double end = values[0];
      if (quantity.turn != 0.)
        end += quantity.turn * std::round((values[last] - end) / quantity.turn);
      const double      size = values.lpNorm<Eigen::Infinity>();
      const std::string unit =
        quantity.usual_unit.empty() ? quantity.unit : quantity.usual_unit;
      const auto shown = [&](const double value) {
        return Units::to_string(value, quantity.unit, unit);
      };
      AssertThrow(std::abs(values[last] - end) <= rounding * size,
                  ExcInput(table.location(last) + ": column " +
                           in_quotes(name) + " ends with " +
                           shown(values[last]) + ", but begins with " +
                           shown(values[0]) + ". " + describe_end(quantity)));
      values[last] = end;
    }



    TableParameters::Columns
    read_columns(const std::string               &path,
                 const TableParameters           &parameters,
                 const TableParameters::Quantity &quantity)
    {
      const CsvTable           table(parameters.file);
      TableParameters::Columns columns;
      columns.times = table.column(time_column, "s");
      check_times(table, columns.times);
      AssertThrow(table.n_rows() > 1,
                  ExcInput(table.location(0) +
                           ": this is the only row; a table needs at least "
                           "two, the last one a period behind the first"));

      const Eigen::Index last = columns.times.size() - 1;
      const double       span = columns.times[last] - columns.times[0];
      AssertThrow(
        parameters.period == 0. || span <= (1. + rounding) * parameters.period,
        ExcParameter(path + "/Table period",
                     "is " + Units::to_string(parameters.period, "s", "s") +
                       ", but the rows of " + in_quotes(parameters.file) +
                       " take " + Units::to_string(span, "s", "s")));
      if (span < (1. - rounding) * parameters.period)
        {
          columns.times.conservativeResize(last + 2);
          columns.times[last + 1] = columns.times[0] + parameters.period;
        }
      else if (parameters.period > 0.)
        columns.times[last] = columns.times[0] + parameters.period;

      for (const std::string &name :
           find_names(path, parameters, table, quantity))
        {
          columns.values.push_back(
            table.column(name, quantity.unit, quantity.usual_unit));
          close(
            table, name, quantity, columns.times.size(), columns.values.back());
        }
      return columns;
    }
  } // namespace



  void
  TableParameters::add_parameters(dealii::ParameterHandler &prm,
                                  const std::string        &documentation)
  {
    Parameters::add_text(
      prm,
      "Table",
      file,
      "A CSV file that gives it over a period instead of 'Time function', "
      "named relative to this one. Its first line names the columns with their "
      "units, 'time [s], force [kN]'; commas, semicolons or tabs separate "
      "them, '#' begins a comment. 'time' must rise. Empty: none.");
    Parameters::add_text(prm,
                         "Table column",
                         columns,
                         documentation +
                           " Empty: what the table has beside 'time'.");
    Parameters::add_quantity(
      prm,
      "Table period",
      period,
      "s",
      "After which time the first row of the table comes again. 0: with the "
      "last row, which must repeat it. A cycle must be a whole number of "
      "periods.");
    Parameters::add_choice(
      prm,
      "Interpolation",
      interpolation,
      "Between the rows of the table: 'linear', which has kinks but never goes "
      "beyond the rows, or 'cubic', a periodic spline with two continuous "
      "derivatives.");
  }



  TableParameters::Columns
  TableParameters::read(const std::string &path, const Quantity &quantity) const
  {
    AssertThrow(period >= 0.,
                ExcParameter(path + "/Table period",
                             "must be positive, or 0 for the time from the "
                             "first row to the last, not " +
                               Units::to_string(period, "s", "s")));
    try
      {
        return read_columns(path, *this, quantity);
      }
    catch (const ExcInput &exception)
      {
        throw ExcParameter(path + "/Table", message_of(exception));
      }
  }
} // namespace Tribody

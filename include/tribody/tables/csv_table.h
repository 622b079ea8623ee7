// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_tables_csv_table_h
#define tribody_tables_csv_table_h

#include <Eigen/Core>

#include <string>
#include <vector>

namespace Tribody
{
  /**
   * A table of a user, or one that TableWriter has written: a header with the
   * names of the columns and their units in brackets, then a row of numbers in
   * each line,
   * @code
   * # Measured at 600 rpm.
   * time [s], force x [kN], angle [deg]
   * 0,        1.25,         0
   * 0.01,     1.31,         36
   * @endcode
   * Fields are separated by commas, semicolons or tabs, as the header is, and
   * may be in double quotes. Decimals have a point whatever language the
   * computer speaks. Empty lines and lines behind '#' are skipped; DOS line
   * ends and a byte order mark are taken.
   *
   * Columns are read when they are asked for, so that one that nobody needs may
   * hold words.
   */
  class CsvTable
  {
  public:
    /**
     * Read @p file_name.
     * @throws ExcInput with file and line: for a file that cannot be read, is
     *   no text or longer than 64 MB, a header without names or with the same
     *   name twice, a row that has not one field for each column, no rows.
     */
    explicit CsvTable(const std::string &file_name);

    /// As it was given.
    const std::string &
    file_name() const
    {
      return name_of_file;
    }

    /// In the order of the file, without units.
    const std::vector<std::string> &
    column_names() const
    {
      return names;
    }

    /// Whether there is a column of that name.
    bool
    has_column(const std::string &name) const;

    /// At least 1.
    Eigen::Index
    n_rows() const
    {
      return static_cast<Eigen::Index>(rows.size());
    }

    /**
     * The values of the column @p name in @p si_unit.
     * @param si_unit the dimension that it must have; if empty, a pure number,
     *   whose unit is "-", "1" or "%".
     * @param usual_unit the one to show in messages; @p si_unit if empty.
     * @throws ExcInput with file and line: no such column (with the nearest
     *   names), no unit or one of another dimension, a gap, something that is
     *   not a finite number.
     */
    Eigen::VectorXd
    column(const std::string &name,
           const std::string &si_unit,
           const std::string &usual_unit = "") const;

    /// "file.csv:1", where the columns are named.
    std::string
    header_location() const;

    /// "file.csv:12", where the row @p row stands. @pre less than n_rows().
    std::string
    location(const Eigen::Index row) const;

  private:
    /// As it stands in the file.
    struct Line
    {
      std::size_t number;
      std::string text;
    };

    void
    read_header(const Line &line);

    std::vector<std::string>
    fields_of(const Line &line) const;

    std::string
    location_of(const Line &line) const;

    /// Its place in the header. @throws ExcInput if there is none.
    std::size_t
    find_column(const std::string &name) const;

    std::string              name_of_file;
    Line                     header;
    char                     separator = ',';
    std::vector<std::string> names;
    // In brackets; empty where there are none.
    std::vector<std::string> units;
    std::vector<Line>        rows;
  };
} // namespace Tribody

#endif

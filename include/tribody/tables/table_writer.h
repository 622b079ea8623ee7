// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_tables_table_writer_h
#define tribody_tables_table_writer_h

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace Tribody
{
  /// When the rows of a table are on the disk.
  enum class TableKind
  {
    /// All of them together, when finish() returns.
    whole,
    /// Each of them when write_row() returns.
    growing
  };

  /**
   * A CSV file: comment lines behind '#', a header with a unit for each
   * column ("normal_force [N]"), rows of numbers with all their digits.
   */
  class TableWriter
  {
  public:
    /**
     * @param comments lines that state body, frame and sign.
     * @param columns names with units.
     * @throws ExcRun if the file cannot be written.
     */
    TableWriter(const std::string              &file_name,
                const std::vector<std::string> &comments,
                const std::vector<std::string> &columns,
                const TableKind                 kind = TableKind::whole);

    /// @pre one value per column.
    /// @throws ExcRun if the disk does not take it.
    void
    write_row(const std::vector<double> &values);

    /// Write the file if it is TableKind::whole.
    /// @throws ExcRun if the disk does not take it.
    void
    finish() const;

  private:
    /// To the disk if the table grows.
    void
    pass_on();

    std::string        file_name;
    std::size_t        n_columns;
    TableKind          kind;
    std::ostringstream text;
    std::ofstream      file;
  };
} // namespace Tribody

#endif

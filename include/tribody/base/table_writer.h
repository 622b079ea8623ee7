// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_table_writer_h
#define tribody_base_table_writer_h

#include <fstream>
#include <string>
#include <vector>

namespace Tribody
{
  /**
   * A CSV file: comment lines behind '#', a header with a unit for each
   * column ("normal_force [N]"), rows of numbers with all their digits. Every
   * row is on the disk when write_row() returns.
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
                const std::vector<std::string> &columns);

    /// @pre one value per column.
    /// @throws ExcRun if the disk does not take it.
    void
    write_row(const std::vector<double> &values);

  private:
    std::string   file_name;
    std::size_t   n_columns;
    std::ofstream file;
  };
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/algorithm/string/join.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/base/table_writer.h>

#include <limits>

namespace Tribody
{
  TableWriter::TableWriter(const std::string              &file_name,
                           const std::vector<std::string> &comments,
                           const std::vector<std::string> &columns)
    : file_name(file_name)
    , n_columns(columns.size())
    , file(file_name)
  {
    file.precision(std::numeric_limits<double>::max_digits10);
    for (const std::string &comment : comments)
      file << "# " << comment << '\n';
    file << boost::algorithm::join(columns, ",") << std::endl;
    AssertThrow(file, ExcRun("Cannot write '" + file_name + "'."));
  }



  void
  TableWriter::write_row(const std::vector<double> &values)
  {
    Assert(values.size() == n_columns,
           dealii::ExcDimensionMismatch(values.size(), n_columns));

    for (std::size_t i = 0; i < values.size(); ++i)
      file << (i > 0 ? "," : "") << values[i];
    file << std::endl;
    AssertThrow(file, ExcRun("Cannot write '" + file_name + "'."));
  }
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/algorithm/string/join.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/base/whole_file.h>
#include <tribody/tables/table_writer.h>

#include <cerrno>
#include <limits>

namespace Tribody
{
  TableWriter::TableWriter(const std::string              &file_name,
                           const std::vector<std::string> &comments,
                           const std::vector<std::string> &columns,
                           const TableKind                 kind)
    : file_name(file_name)
    , n_columns(columns.size())
    , kind(kind)
  {
    if (kind == TableKind::growing)
      {
        errno = 0;
        file.open(file_name);
        AssertThrow(file, ExcRun(describe_write_error(file_name, errno)));
      }
    text.precision(std::numeric_limits<double>::max_digits10);
    for (const std::string &comment : comments)
      text << "# " << comment << '\n';
    text << boost::algorithm::join(columns, ",") << '\n';
    pass_on();
  }



  void
  TableWriter::write_row(const std::vector<double> &values)
  {
    Assert(values.size() == n_columns,
           dealii::ExcDimensionMismatch(values.size(), n_columns));

    for (std::size_t i = 0; i < values.size(); ++i)
      text << (i > 0 ? "," : "") << values[i];
    text << '\n';
    pass_on();
  }



  void
  TableWriter::finish() const
  {
    if (kind == TableKind::whole)
      write_whole_file(file_name,
                       [this](std::ostream &out) { out << text.str(); });
  }



  void
  TableWriter::pass_on()
  {
    if (kind == TableKind::whole)
      return;
    errno = 0;
    file << text.str() << std::flush;
    text.str("");
    AssertThrow(file, ExcRun(describe_write_error(file_name, errno)));
  }
} // namespace Tribody

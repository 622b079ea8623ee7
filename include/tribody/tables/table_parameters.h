// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_tables_table_parameters_h
#define tribody_tables_table_parameters_h

#include <tribody/tables/periodic_table.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  /// Which columns of which file are functions of time.
  struct TableParameters
  {
    /// Values of columns as they stand, but for units, at times of a period.
    struct Columns
    {
      /// [s]; the last one is a period after the first.
      Eigen::VectorXd times;
      /// In SI units; the last one of each is the first one, but for
      /// what it was allowed to change by.
      std::vector<Eigen::VectorXd> values;
    };

    /// What the values of the columns measure.
    struct Quantity
    {
      /// SI unit, "N".
      std::string unit;
      /// The one for messages, "kN".
      std::string usual_unit;
      /// What may be added from one period to the next, any number of times:
      /// a turn; 0: nothing.
      double turn = 0.;
      /// How many there may be.
      std::size_t most_columns = 1;
      /// "a column for the force, or two for its x and y components"
      std::string wanted;
    };

    /// @param interpolation that is meant if nothing is said.
    explicit TableParameters(const TableInterpolation interpolation)
      : interpolation(interpolation)
    {}

    /// Empty: there is no table.
    std::string file;
    /// Names separated by commas; empty: all but the time.
    std::string columns;
    /// What is between the rows.
    TableInterpolation interpolation;
    /// From the first row to its repetition [s]; 0: to the last row.
    double period = 0.;

    /// Declares in the current subsection. @param documentation what the
    /// columns are.
    void
    add_parameters(dealii::ParameterHandler &prm,
                   const std::string        &documentation);

    /// Whether there is a table.
    bool
    is_given() const
    {
      return !file.empty();
    }

    /// Read the file. @throws ExcParameter with paths that start with @p path.
    Columns
    read(const std::string &path, const Quantity &quantity) const;
  };
} // namespace Tribody

#endif

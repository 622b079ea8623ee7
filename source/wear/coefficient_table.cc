// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/function_lib.h>
#include <deal.II/base/table.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/in_quotes.h>
#include <tribody/base/units.h>
#include <tribody/tables/csv_table.h>
#include <tribody/wear/coefficient_table.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace Tribody
{
  namespace Wear
  {
    namespace
    {
      /// What a coefficient may depend on.
      struct Quantity
      {
        std::string name, si_unit, shown_unit;
      };

      // The order of the arguments of the interpolation.
      const std::array<Quantity, 3> arguments = {
        {{"pressure", "Pa", "MPa"},
         {"speed", "m/s", "m/s"},
         {"temperature", "K", "degC"}}};

      const Quantity coefficient = {"wear coefficient", "Pa^-1", "mm^3/(N m)"};



      /// An axis of the grid.
      struct GridAxis
      {
        Quantity quantity;
        // Of each row; empty if there is no such column.
        Eigen::VectorXd of_row;
        // Rising; one of any size if there is no such column.
        std::vector<double> values = {0.};

        bool
        is_given() const
        {
          return of_row.size() > 0;
        }

        std::size_t
        place_of(const Eigen::Index row) const
        {
          if (!is_given())
            return 0;
          return std::lower_bound(values.begin(), values.end(), of_row[row]) -
                 values.begin();
        }
      };

      using Grid = std::array<GridAxis, 3>;



      std::string
      shown(const Quantity &quantity, const double value)
      {
        return quantity.name + " " +
               Units::to_string(value, quantity.si_unit, quantity.shown_unit);
      }



      Eigen::VectorXd
      read_column(const CsvTable &table, const Quantity &quantity)
      {
        Eigen::VectorXd values =
          table.column(quantity.name, quantity.si_unit, quantity.shown_unit);
        for (Eigen::Index row = 0; row < values.size(); ++row)
          AssertThrow(values[row] >= 0.,
                      ExcInput(table.location(row) + ": " +
                               shown(quantity, values[row]) +
                               " must not be negative"));
        return values;
      }



      // Whatever changes fastest, a value that is new is above those before it.
      GridAxis
      read_axis(const CsvTable &table, const Quantity &quantity)
      {
        GridAxis axis{quantity, {}};
        if (!table.has_column(quantity.name))
          return axis;
        axis.of_row = read_column(table, quantity);
        std::vector<double> values;
        for (Eigen::Index row = 0; row < table.n_rows(); ++row)
          {
            const double value = axis.of_row[row];
            if (std::binary_search(values.begin(), values.end(), value))
              continue;
            AssertThrow(values.empty() || value > values.back(),
                        ExcInput(table.location(row) + ": " +
                                 shown(quantity, value) + " comes after " +
                                 shown(quantity, values.back()) +
                                 "; the values must rise"));
            values.push_back(value);
          }
        AssertThrow(values.size() > 1,
                    ExcInput(table.location(0) + ": " +
                             shown(quantity, values.front()) +
                             " is the only one; a table needs two or more, or "
                             "does without the column"));
        axis.values = std::move(values);
        return axis;
      }



      Grid
      read_grid(const CsvTable &table)
      {
        for (const std::string &name : table.column_names())
          AssertThrow(name == coefficient.name ||
                        std::any_of(arguments.begin(),
                                    arguments.end(),
                                    [&name](const Quantity &argument) {
                                      return argument.name == name;
                                    }),
                      ExcInput(table.header_location() + ": the column " +
                               in_quotes(name) +
                               " is none of 'pressure', 'speed', "
                               "'temperature', 'wear coefficient'"));
        Grid grid;
        for (std::size_t i = 0; i < grid.size(); ++i)
          grid[i] = read_axis(table, arguments[i]);
        AssertThrow(std::any_of(grid.begin(),
                                grid.end(),
                                [](const GridAxis &axis) {
                                  return axis.is_given();
                                }),
                    ExcInput(table.header_location() +
                             ": there is no column 'pressure', 'speed' or "
                             "'temperature' for the wear coefficient to "
                             "depend on"));
        return grid;
      }



      using Place = dealii::TableIndices<3>;

      // All points, in the order of a table.
      std::vector<Place>
      places_of(const Grid &grid)
      {
        std::vector<Place> places;
        for (std::size_t i = 0; i < grid[0].values.size(); ++i)
          for (std::size_t j = 0; j < grid[1].values.size(); ++j)
            for (std::size_t k = 0; k < grid[2].values.size(); ++k)
              places.emplace_back(i, j, k);
        return places;
      }



      std::string
      shown_point(const Grid &grid, const Place &place)
      {
        std::string text;
        for (std::size_t i = 0; i < grid.size(); ++i)
          if (grid[i].is_given())
            text += (text.empty() ? "" : " with ") +
                    shown(grid[i].quantity, grid[i].values[place[i]]);
        return text;
      }



      // The coefficient at all points, whatever the order of the rows.
      dealii::Table<3, double>
      read_coefficients(const CsvTable &table, const Grid &grid)
      {
        const Eigen::VectorXd    k = read_column(table, coefficient);
        dealii::Table<3, double> coefficients(grid[0].values.size(),
                                              grid[1].values.size(),
                                              grid[2].values.size());

        constexpr Eigen::Index         none = -1;
        dealii::Table<3, Eigen::Index> rows;
        rows.reinit(coefficients.size());
        rows.fill(none);
        for (Eigen::Index row = 0; row < table.n_rows(); ++row)
          {
            const Place place(grid[0].place_of(row),
                              grid[1].place_of(row),
                              grid[2].place_of(row));
            AssertThrow(
              rows(place) == none,
              ExcInput(table.location(row) + ": " + shown_point(grid, place) +
                       " stands already in " + table.location(rows(place))));
            rows(place)         = row;
            coefficients(place) = k[row];
          }
        for (const Place &place : places_of(grid))
          AssertThrow(rows(place) != none,
                      ExcInput(table.header_location() +
                               ": the table has no row for " +
                               shown_point(grid, place) +
                               "; each value of a column needs each of the "
                               "others"));
        return coefficients;
      }



      // The interpolation needs two values along each axis, the same ones
      // where nothing is known of it.
      dealii::Table<3, double>
      extend(Grid &grid, const dealii::Table<3, double> &k)
      {
        for (GridAxis &axis : grid)
          if (!axis.is_given())
            axis.values.push_back(1.);
        dealii::Table<3, double> extended(grid[0].values.size(),
                                          grid[1].values.size(),
                                          grid[2].values.size());
        for (const Place &place : places_of(grid))
          extended(place) = k(Place(grid[0].is_given() ? place[0] : 0,
                                    grid[1].is_given() ? place[1] : 0,
                                    grid[2].is_given() ? place[2] : 0));
        return extended;
      }
    } // namespace



    CoefficientTable::CoefficientTable(const std::string &file_name)
    {
      const CsvTable           table(file_name);
      Grid                     grid = read_grid(table);
      dealii::Table<3, double> k = extend(grid, read_coefficients(table, grid));
      for (const Place &place : places_of(grid))
        largest_value = std::max(largest_value, k(place));
      AssertThrow(largest_value > 0.,
                  ExcInput(table.header_location() +
                           ": every wear coefficient is 0; one at least must "
                           "be positive"));
      has_temperature = grid[2].is_given();
      pressures       = {grid[0].values.front(), grid[0].values.back()};
      interpolation   = std::make_shared<
        const dealii::Functions::InterpolatedTensorProductGridData<n_axes>>(
        std::array<std::vector<double>, n_axes>{
          {grid[0].values, grid[1].values, grid[2].values}},
        std::move(k));
    }



    FactorValue
    CoefficientTable::evaluate(const double   pressure,
                               const Sliding &sliding) const
    {
      // Where nobody knows the temperature, the table has none.
      const dealii::Point<n_axes> place(
        pressure, sliding.speed, has_temperature ? sliding.temperature : 0.);
      // Beyond its grid the interpolation is constant, but its gradient is that
      // of the edge, against its documentation (deal.II 9.4).
      const bool is_beyond =
        pressure < pressures.first || pressure > pressures.second;
      return {interpolation->value(place) / largest_value,
              is_beyond ? 0.
                        : interpolation->gradient(place)[0] / largest_value};
    }
  } // namespace Wear
} // namespace Tribody

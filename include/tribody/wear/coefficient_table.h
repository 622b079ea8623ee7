// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_wear_coefficient_table_h
#define tribody_wear_coefficient_table_h

#include <tribody/wear/factor_value.h>

#include <memory>
#include <string>
#include <utility>

namespace dealii
{
  namespace Functions
  {
    template <int dim>
    class InterpolatedTensorProductGridData;
  }
} // namespace dealii

namespace Tribody
{
  namespace Wear
  {
    /**
     * A wear coefficient k(p, v, T) that was measured at some pressures, speeds
     * and temperatures of the contact, a CsvTable with the columns
     * @code
     * pressure [MPa], speed [m/s], temperature [degC], wear coefficient [Pa^-1]
     * @endcode
     * The rows are a rectangular grid: each pressure with each speed and each
     * temperature, the values of each rising. One or two of the three columns
     * may be left out; k does not depend on them then. Between the points k is
     * linear in each, beyond the grid that of its edge.
     *
     * The part of k that is a number is its largest() value, and evaluate()
     * gives the fraction of that. A plain value; copies share the points.
     */
    class CoefficientTable
    {
    public:
      /// @throws ExcInput with file and line for a table that is none: a
      /// missing
      ///   column or unit, an axis with one value, values that do not rise,
      ///   points that are missing or there twice, a coefficient that is
      ///   negative, none that is positive.
      explicit CoefficientTable(const std::string &file_name);

      /// [Pa^-1], positive.
      double
      largest() const
      {
        return largest_value;
      }

      /// k/largest() and its derivative, which jumps where there is a point.
      FactorValue
      evaluate(const double pressure, const Sliding &sliding) const;

      /// Whether it has the column 'temperature'.
      bool
      depends_on_temperature() const
      {
        return has_temperature;
      }

    private:
      static constexpr int n_axes = 3;

      std::shared_ptr<
        const dealii::Functions::InterpolatedTensorProductGridData<n_axes>>
        interpolation;
      // Ends of the axis.
      std::pair<double, double> pressures       = {0., 0.};
      bool                      has_temperature = false;
      double                    largest_value   = 0.;
    };
  } // namespace Wear
} // namespace Tribody

#endif

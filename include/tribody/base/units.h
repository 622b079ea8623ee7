// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_units_h
#define tribody_base_units_h

#include <deal.II/base/numbers.h>

#include <string>
#include <vector>

namespace Tribody
{
  /**
   * Physical quantities as they stand in a data sheet, "9.525 mm", read and
   * written with UDUNITS-2. Inside the program every number is in SI units
   * and radians.
   */
  namespace Units
  {
    /**
     * The value of @p text in the unit @p si_unit.
     *
     * @param text a number, then a unit of the same dimension as
     *   @p si_unit: "5.05e-4 mm^3/(N m)" for "Pa^-1". If @p si_unit is empty,
     *   @p text must be a bare number.
     * @param usual_unit the one to show in messages; @p si_unit if empty.
     * @throws ExcInput for a missing unit (shows the one to write), a wrong
     *   dimension, an unknown unit or something that is not a finite number.
     *   "30 Hz" is no angular speed: radians are counted as a dimension.
     */
    double
    from_string(const std::string &text,
                const std::string &si_unit,
                const std::string &usual_unit = "");

    /// Two or more quantities separated by commas: "0 mm, 3 mm".
    std::vector<double>
    list_from_string(const std::string &text,
                     const std::string &si_unit,
                     const std::string &usual_unit = "");

    /// @p value [@p si_unit] in the unit @p shown_unit of the same dimension,
    /// as a string that from_string() reads back.
    std::string
    to_string(const double       value,
              const std::string &si_unit,
              const std::string &shown_unit);

    /// The same with @p n_digits significant digits, for messages.
    std::string
    to_string(const double       value,
              const std::string &si_unit,
              const std::string &shown_unit,
              const int          n_digits);

    /// @p radians in degrees.
    constexpr double
    degrees(const double radians)
    {
      return radians * (180. / dealii::numbers::PI);
    }
  } // namespace Units
} // namespace Tribody

#endif

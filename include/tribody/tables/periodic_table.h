// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_tables_periodic_table_h
#define tribody_tables_periodic_table_h

#include <Eigen/Core>

#include <tribody/base/choice.h>

#include <array>

namespace Tribody
{
  /// What is between the rows of a table.
  enum class TableInterpolation
  {
    linear,
    cubic
  };

  /// Their words, see ChoiceNames.
  inline ChoiceNames<TableInterpolation>
  choice_names(const TableInterpolation)
  {
    return {{TableInterpolation::linear, "linear"},
            {TableInterpolation::cubic, "cubic"}};
  }

  /**
   * A periodic function of time that is given at some times of a period:
   * straight between them, or a cubic spline with two continuous derivatives
   * everywhere, also from one period to the next.
   *
   * Between the times @f$t_i@f$ and @f$t_{i+1} = t_i + h@f$, with
   * @f$b = (t - t_i)/h@f$ and @f$a = 1 - b@f$,
   * @f[ f = a f_i + b f_{i+1} +
   *       \frac{h^2}{6}\left((a^3 - a) M_i + (b^3 - b) M_{i+1}\right). @f]
   * The second derivatives @f$M_i@f$ are zero or those that make the slope
   * continuous, a cyclic tridiagonal system; see @cite deboor1978.
   */
  class PeriodicTable
  {
  public:
    /**
     * @param times that rise [s]; the last one is a period after the first.
     * @param values at these times; the last one is the first one.
     * @pre at least two of each.
     */
    PeriodicTable(const Eigen::VectorXd   &times,
                  const Eigen::VectorXd   &values,
                  const TableInterpolation interpolation);

    /// At any time @p t [s].
    double
    value(const double t) const;

    /// f' and f'', exactly. At a kink those of the right side; where the table
    /// is linear, f'' is zero.
    std::array<double, 2>
    derivatives(const double t) const;

    /// [s]
    double
    period() const
    {
      return phases[phases.size() - 1];
    }

    /// The smallest of the values that were given.
    double
    smallest() const
    {
      return values.minCoeff();
    }

  private:
    /// Where a time is between the rows.
    struct Place
    {
      Eigen::Index interval;
      /// Weights of its beginning and its end.
      double a, b;
      /// Its length [s].
      double length;
    };

    Place
    find(const double t) const;

    // Time of the first row; times from there on.
    double          start;
    Eigen::VectorXd phases, values, second_derivatives;
  };
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <Eigen/SparseCholesky>

#include <tribody/tables/periodic_table.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Tribody
{
  namespace
  {
    // Of the periodic spline through @p values. The slope left and right of a
    // time is the same; symmetric and diagonally dominant.
    Eigen::VectorXd
    find_second_derivatives(const Eigen::VectorXd &phases,
                            const Eigen::VectorXd &values)
    {
      const Eigen::Index                  n = phases.size() - 1;
      std::vector<Eigen::Triplet<double>> entries;
      Eigen::VectorXd                     right = Eigen::VectorXd::Zero(n);
      for (Eigen::Index i = 0; i < n; ++i)
        {
          const Eigen::Index next  = (i + 1) % n;
          const double       h     = phases[i + 1] - phases[i];
          const double       slope = (values[i + 1] - values[i]) / h;
          entries.emplace_back(i, i, 2. * h);
          entries.emplace_back(next, next, 2. * h);
          entries.emplace_back(i, next, h);
          entries.emplace_back(next, i, h);
          right[i] += 6. * slope;
          right[next] -= 6. * slope;
        }
      Eigen::SparseMatrix<double> matrix(n, n);
      matrix.setFromTriplets(entries.begin(), entries.end());
      const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
      Assert(factor.info() == Eigen::Success, dealii::ExcInternalError());

      Eigen::VectorXd result(n + 1);
      result.head(n) = factor.solve(right);
      result[n]      = result[0];
      return result;
    }
  } // namespace



  PeriodicTable::PeriodicTable(const Eigen::VectorXd   &times,
                               const Eigen::VectorXd   &values,
                               const TableInterpolation interpolation)
    : start(times[0])
    , phases(times.array() - times[0])
    , values(values)
    , second_derivatives(interpolation == TableInterpolation::cubic
                           ? find_second_derivatives(phases, values)
                           : Eigen::VectorXd::Zero(values.size()))
  {
    AssertDimension(times.size(), values.size());
    Assert(values[0] == values[values.size() - 1],
           dealii::ExcMessage("The table does not close."));
  }



  PeriodicTable::Place
  PeriodicTable::find(const double t) const
  {
    const double phase =
      (t - start) - period() * std::floor((t - start) / period());
    // The first time behind it; rounding may have led to the end of the period.
    const auto end = std::upper_bound(phases.begin(), phases.end() - 1, phase);
    const auto i   = std::max<Eigen::Index>(end - phases.begin() - 1, 0);
    const double length = phases[i + 1] - phases[i];
    const double b      = std::clamp((phase - phases[i]) / length, 0., 1.);
    return {i, 1. - b, b, length};
  }



  double
  PeriodicTable::value(const double t) const
  {
    const auto [i, a, b, h] = find(t);
    return a * values[i] + b * values[i + 1] +
           h * h / 6. *
             (a * (a * a - 1.) * second_derivatives[i] +
              b * (b * b - 1.) * second_derivatives[i + 1]);
  }



  std::array<double, 2>
  PeriodicTable::derivatives(const double t) const
  {
    const auto [i, a, b, h] = find(t);
    const double left       = second_derivatives[i],
                 right      = second_derivatives[i + 1];
    return {{(values[i + 1] - values[i]) / h +
               h / 6. * ((3. * b * b - 1.) * right - (3. * a * a - 1.) * left),
             a * left + b * right}};
  }
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/base/significant_digits.h>
#include <tribody/elasticity/surface_compliance.h>

namespace Tribody
{
  namespace Elasticity
  {
    Eigen::MatrixXd
    repeat_around(const Eigen::MatrixXd &first_columns)
    {
      const Eigen::Index n = first_columns.rows();
      const Eigen::Index p = first_columns.cols();
      Eigen::MatrixXd    compliance(n, n);
      for (Eigen::Index j = 0; j < n; ++j)
        {
          const auto         column         = first_columns.col(j % p);
          const Eigen::Index shift          = j - j % p;
          compliance.col(j).tail(n - shift) = column.head(n - shift);
          compliance.col(j).head(shift)     = column.tail(shift);
        }
      return compliance;
    }



    Eigen::MatrixXd
    symmetric_part(const Eigen::MatrixXd &compliance, const std::string &body)
    {
      // 4e-11 at 9360 equations; it grows with their number, and a pin with its
      // mesh as fine as a bore of 1440 cells is beyond 1e-10.
      constexpr double largest_asymmetry = 1e-7;

      const double asymmetry =
        (compliance - compliance.transpose()).cwiseAbs().maxCoeff() /
        compliance.cwiseAbs().maxCoeff();
      AssertThrow(asymmetry < largest_asymmetry,
                  ExcRun("The compliance of a " + body +
                         " came out unsymmetric by " +
                         significant_digits(asymmetry) +
                         " of its largest entry: its stiffness is close to "
                         "singular. Check the mesh and Poisson's ratio."));
      return 0.5 * (compliance + compliance.transpose());
    }
  } // namespace Elasticity
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/exceptions.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <tribody/wear/constant_extrapolation.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace Wear
  {
    double
    ConstantExtrapolation::next_step(const double cycles_done,
                                     const double n_cycles) const
    {
      return std::min(cycles_per_step, n_cycles - cycles_done);
    }



    double
    max_stable_step(const Eigen::MatrixXd &compliance,
                    const Eigen::VectorXd &area_derivative,
                    const double           wear_per_pressure)
    {
      Assert(wear_per_pressure > 0., dealii::ExcMessage("nothing wears"));

      // The largest eigenvalue of D^-1/2 C^-1 D^-1/2 is one over the smallest
      // of D^1/2 C D^1/2.
      const auto            root   = area_derivative.cwiseSqrt().asDiagonal();
      const Eigen::MatrixXd scaled = root * compliance * root;
      const double          smallest =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled,
                                                       Eigen::EigenvaluesOnly)
          .eigenvalues()[0];
      return 2. * smallest / wear_per_pressure;
    }



    Eigen::VectorXd
    euler_error(const Eigen::VectorXd &rate_before,
                const Eigen::VectorXd &rate_after,
                const double           n_cycles)
    {
      return 0.5 * n_cycles * (rate_after - rate_before);
    }
  } // namespace Wear
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_wear_constant_extrapolation_h
#define tribody_wear_constant_extrapolation_h

#include <Eigen/Core>

#include <vector>

namespace Tribody
{
  namespace Wear
  {
    /**
     * The paper's extrapolation over cycles, eqs. (24) and (25): the worn
     * profile obeys @f$ dh/dN = W(h) @f$ with the wear W of one cycle, and
     * explicit Euler steps of a constant number of cycles integrate it. The
     * last step is shortened so that any number of cycles can be reached.
     *
     * The equation is stiff. W falls with h where the mesh resolves it, at the
     * rate @f$ k\,s\,C^{-1}/w @f$ (compliance C of the bore, sliding s per
     * cycle), so steps beyond max_stable_step() grow a sawtooth of the mesh
     * size in pressure and depth.
     */
    struct ConstantExtrapolation
    {
      /// Cycles per wear step A_E; positive.
      double cycles_per_step = 1.;

      /// Cycles of the step that starts after @p cycles_done of @p n_cycles.
      double
      next_step(const double cycles_done, const double n_cycles) const;
    };

    /**
     * Cycles per step up to which explicit steps are stable: 2 over the largest
     * eigenvalue of @f$ k\,s\,D^{-1} C^{-1} @f$. A lower bound: it holds for
     * every active set, since restricting C can only lower that eigenvalue.
     *
     * @param compliance C, normal compliance of the bore nodes [m/(N/m)].
     * @param area_derivative D, derivative of the bore's area with respect to
     *   the depth at each node [m].
     * @param wear_per_pressure k s: wear coefficient times sliding distance per
     *   cycle [m/Pa]; positive.
     */
    double
    max_stable_step(const Eigen::MatrixXd &compliance,
                    const Eigen::VectorXd &area_derivative,
                    const double           wear_per_pressure);

    /**
     * Estimate of the error that an explicit Euler step of @p n_cycles leaves,
     * to leading order half of @f$ \Delta N (W_{n+1} - W_n) @f$ [m], from the
     * rates [m per cycle] before and after it, one value per node.
     */
    Eigen::VectorXd
    euler_error(const Eigen::VectorXd &rate_before,
                const Eigen::VectorXd &rate_after,
                const double           n_cycles);
  } // namespace Wear
} // namespace Tribody

#endif

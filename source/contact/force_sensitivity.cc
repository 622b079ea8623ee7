// SPDX-License-Identifier: LGPL-2.1-or-later

#include <Eigen/LU>

#include <tribody/algebra/dense_products.h>
#include <tribody/contact/force_sensitivity.h>
#include <tribody/contact/pin_gap.h>
#include <tribody/contact/rigid_places.h>

namespace Tribody
{
  namespace Contact
  {
    ForceSensitivity::ForceSensitivity(const Eigen::Matrix2Xd &positions,
                                       const Compliance       &compliance,
                                       const double            pin_radius,
                                       const Housing          *housing)
      : positions(positions)
      , pin_radius(pin_radius)
      , housing(housing)
      , active_compliance(compliance, ActiveCompliance::Use::inverse)
    {}



    Eigen::MatrixXd
    ForceSensitivity::compute(const ContactSolution &solution)
    {
      const Eigen::Index n = solution.active_set.size();
      if (n == 0)
        return {};
      const PinGap pin(positions, solution.pin_centre, pin_radius);
      if (housing == nullptr)
        return compute<2>(solution, pin);
      return compute<4>(solution,
                        append_rim(pin, *housing, solution.rim.ring_place))
        .topLeftCorner(n, n);
    }



    template <int n_free>
    Eigen::MatrixXd
    ForceSensitivity::compute(const ContactSolution &solution,
                              const PinGap          &gap)
    {
      using Places = RigidPlaces<n_free>;
      using Square = typename Places::Square;

      const Eigen::Index n_bore = solution.nodal_force.size();
      ActiveSet          active = solution.active_set;
      for (const Eigen::Index k : solution.rim.active_set)
        active.push_back(n_bore + k);
      const Eigen::Index n = active.size();
      active_compliance.update(active, /*small changes = */ true);

      using Columns      = Eigen::Matrix<double, Eigen::Dynamic, n_free>;
      Columns directions = Columns::Zero(n, n_free);
      Square  geometric  = Square::Zero();
      for (Eigen::Index k = 0; k < n; ++k)
        {
          const Eigen::Index i = active[k];
          directions.template block<1, 2>(k, Places::first_column(i, n_bore)) =
            gap.directions.col(i).transpose();
          Places::add_curvature(geometric,
                                gap,
                                i,
                                n_bore,
                                i < n_bore
                                  ? solution.nodal_force[i]
                                  : solution.rim.nodal_force[i - n_bore]);
        }

      const Columns y         = active_compliance.solve(directions);
      const Square  stiffness = directions.transpose() * y;
      const Square  balance =
        Places::are_held(active, n_bore)
           ? Square((stiffness + geometric).inverse())
           : Places::invert_stiffness(stiffness, active, n_bore);
      Eigen::MatrixXd sensitivity = active_compliance.compute_inverse();
      DenseProducts::add_product(-y * balance, y.transpose(), sensitivity);
      return sensitivity;
    }
  } // namespace Contact
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/elements/massless_link_constraint.h>

#include <algorithm>

namespace Tribody
{
  namespace Multibody
  {
    MasslessLinkConstraint::MasslessLinkConstraint(
      const std::string &description,
      const Marker      &pin,
      const Marker      &bushing,
      const double       length)
      : Constraint(description, {pin.body, bushing.body}, 1)
      , length(length)
      , ends(description, pin, bushing)
    {}



    Eigen::Vector2d
    MasslessLinkConstraint::eccentricity(const PairVector &q) const
    {
      return ends.value(0., q).head<2>();
    }



    Eigen::Matrix<double, 2, 6>
    MasslessLinkConstraint::eccentricity_jacobian(const PairVector &q) const
    {
      return ends.jacobian(q).topRows<2>();
    }



    Eigen::Vector2d
    MasslessLinkConstraint::direction(const PairVector &q) const
    {
      const Eigen::Vector2d e = eccentricity(q);
      const double          r = e.norm();
      // Markers that are meant to coincide do so up to rounding.
      return r > 1e-6 * length ? Eigen::Vector2d(e / r)
                               : Eigen::Vector2d::UnitX();
    }



    Constraint::Values
    MasslessLinkConstraint::value(const double /*t*/, const PairVector &q) const
    {
      return {eccentricity(q).norm() - length, 0., 0.};
    }



    Constraint::Jacobian
    MasslessLinkConstraint::jacobian(const PairVector &q) const
    {
      Jacobian result = Jacobian::Zero();
      result.row(0)   = direction(q).transpose() * eccentricity_jacobian(q);
      return result;
    }



    PairMatrix
    MasslessLinkConstraint::weighted_hessian(const PairVector &q,
                                             const Values     &weights) const
    {
      // n turns by (k x n)^T de/|e|.
      const Eigen::Vector2d n = direction(q);
      const double          r = std::max(eccentricity(q).norm(), 1e-6 * length);
      const Eigen::Matrix<double, 1, 6> turn =
        perpendicular(n).transpose() * eccentricity_jacobian(q);
      return weights(0) / r * turn.transpose() * turn +
             ends.weighted_hessian(
               q, {weights(0) * n.x(), weights(0) * n.y(), 0.});
    }



    Eigen::Vector2d
    MasslessLinkConstraint::reaction_force(const PairVector &q,
                                           const Values     &multipliers) const
    {
      return multipliers(0) * direction(q);
    }
  } // namespace Multibody
} // namespace Tribody

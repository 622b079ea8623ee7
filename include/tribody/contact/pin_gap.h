// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_contact_pin_gap_h
#define tribody_contact_pin_gap_h

#include <Eigen/Core>

namespace Tribody
{
  namespace Contact
  {
    /**
     * The gap between a round pin of radius R, centred at e, and the
     * undeformed bore nodes x_i,
     * @f[ g^0_i = |x_i - e| - R, \qquad
     *     \frac{\partial g^0_i}{\partial e} = -m_i, \qquad
     *     \frac{\partial^2 g^0_i}{\partial e^2} =
     *       \frac{I - m_i m_i^T}{|x_i - e|}, \qquad
     *     m_i = \frac{x_i - e}{|x_i - e|}. @f]
     * Exact: the linearised gap is wrong by as much as the clearance once half
     * a millimetre has been worn away. Where the pin is worn, the gap is wider
     * by its recess: that much the pin's surface lies inside its circle where
     * it faces node i. That the recess faces other nodes when e changes is left
     * out, so that the derivatives are those of a round pin; the slope of the
     * recess is their relative error.
     */
    struct PinGap
    {
      PinGap() = default;

      /// @param pin_recess one value per node [m]; empty: none.
      PinGap(const Eigen::Matrix2Xd &positions,
             const Eigen::Vector2d  &pin_centre,
             const double            pin_radius,
             const Eigen::VectorXd  &pin_recess = {})
        : directions(positions.colwise() - pin_centre)
        , distances(positions.cols())
      {
        // Step by step, so that roots and quotients are taken by twos.
        const Eigen::Array2Xd squares = directions.array().square();
        distances = (squares.row(0) + squares.row(1)).matrix();
        distances = distances.cwiseSqrt();
        const Eigen::VectorXd inverse = distances.cwiseInverse();
        directions.array().rowwise() *= inverse.transpose().array();
        gap = distances.array() - pin_radius;
        if (pin_recess.size() > 0)
          gap += pin_recess;
      }

      /// m_i, one column each.
      Eigen::Matrix2Xd directions;
      /// |x_i - e| [m].
      Eigen::VectorXd distances;
      /// g^0_i [m].
      Eigen::VectorXd gap;
    };
  } // namespace Contact
} // namespace Tribody

#endif

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
     * a millimetre has been worn away.
     */
    struct PinGap
    {
      PinGap() = default;

      PinGap(const Eigen::Matrix2Xd &positions,
             const Eigen::Vector2d  &pin_centre,
             const double            pin_radius)
        : directions(positions.colwise() - pin_centre)
        , distances(directions.colwise().norm())
        , gap(distances.array() - pin_radius)
      {
        directions.array().rowwise() /= distances.transpose().array();
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

#include <tribody/multibody/spring.h>

#include <limits>

namespace Tribody
{
  namespace Multibody
  {
    PairForce
    Spring::compute_force(const PairVector &q, const PairVector &v) const
    {
      const Eigen::Vector2d a1 = turned(s_1, q(2)), a2 = turned(s_2, q(5));
      const Eigen::Vector2d d = q.segment<2>(3) + a2 - q.head<2>() - a1;
      const double          l = d.norm();
      if (l < std::numeric_limits<double>::min())
        return {PairVector::Zero(), PairMatrix::Zero(), PairMatrix::Zero()};
      const Eigen::Vector2d u = d / l;

      // First and second derivatives of the length with respect to q.
      Eigen::Matrix<double, 2, 6> d_q;
      d_q << -Eigen::Matrix2d::Identity(), -perpendicular(a1),
        Eigen::Matrix2d::Identity(), perpendicular(a2);
      const PairVector l_q = d_q.transpose() * u;
      PairMatrix       l_qq =
        d_q.transpose() *
        ((Eigen::Matrix2d::Identity() - u * u.transpose()) / l) * d_q;
      l_qq(2, 2) += u.dot(a1);
      l_qq(5, 5) -= u.dot(a2);

      const double tension = force_at_reference_length +
                             stiffness * (l - reference_length) +
                             damping * l_q.dot(v);
      return {-tension * l_q,
              -tension * l_qq -
                l_q * (stiffness * l_q + damping * l_qq * v).transpose(),
              -damping * l_q * l_q.transpose()};
    }



    double
    Spring::potential_energy(const PairVector &q) const
    {
      const double extension =
        (marker_position(q.tail<3>(), s_2) - marker_position(q.head<3>(), s_1))
          .norm() -
        reference_length;
      return (force_at_reference_length + stiffness / 2 * extension) *
             extension;
    }
  } // namespace Multibody
} // namespace Tribody

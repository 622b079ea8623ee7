// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_contact_rigid_places_h
#define tribody_contact_rigid_places_h

#include <Eigen/LU>
#include <Eigen/QR>

#include <tribody/contact/active_compliance.h>
#include <tribody/contact/contact_solution.h>
#include <tribody/contact/pin_gap.h>

#include <algorithm>

namespace Tribody
{
  namespace Contact
  {
    /**
     * What the places of the rigid bodies have to do with the nodes in contact:
     * of the pin, e (n_free = 2), and of the ring in its housing, d
     * (n_free = 4). The rows of M are @f$m_i^T@f$ in the columns of the body
     * that node i touches, so that the gaps close by @f$ M_A (e, d) @f$ and the
     * forces are balanced if @f$ M_A^T \lambda_A = (f, f) @f$.
     */
    template <int n_free>
    struct RigidPlaces
    {
      /// A matrix by the coordinates of the places.
      using Square = Eigen::Matrix<double, n_free, n_free>;
      /// The coordinates of the places, e and then d.
      using Vector = Eigen::Matrix<double, n_free, 1>;

      /// The column of M in which the entries of node @p i begin.
      static int
      first_column(const Eigen::Index i, const Eigen::Index n_bore)
      {
        return n_free == 4 && i >= n_bore ? 2 : 0;
      }

      /// f of each body.
      static Vector
      repeat(const Eigen::Vector2d &force)
      {
        return force.template replicate<n_free / 2, 1>();
      }

      /// Add to @p H what the force @p lambda at node @p i does to the
      /// derivative of M^T lambda by the places: the gap's second derivative.
      static void
      add_curvature(Square            &H,
                    const PinGap      &gap,
                    const Eigen::Index i,
                    const Eigen::Index n_bore,
                    const double       lambda)
      {
        const int             first        = first_column(i, n_bore);
        const Eigen::Vector2d m            = gap.directions.col(i);
        const double          signed_force = first == 0 ? lambda : -lambda;
        H.template block<2, 2>(first, first) -=
          signed_force / gap.distances[i] *
          (Eigen::Matrix2d::Identity() - m * m.transpose());
      }

      /// Whether each body is touched by two nodes or more of @p active, which
      /// hold it against all forces.
      static bool
      are_held(const ActiveSet &active, const Eigen::Index n_bore)
      {
        if (n_free == 2)
          return active.size() > 1;
        const auto rim = std::lower_bound(active.begin(), active.end(), n_bore);
        return rim - active.begin() > 1 && active.end() - rim > 1;
      }

      /// The inverse of @f$ M_A^T C_A^{-1} M_A @f$ [m^2/N]; a body that is not
      /// held stays where it is.
      static Square
      invert_stiffness(const Square      &stiffness,
                       const ActiveSet   &active,
                       const Eigen::Index n_bore)
      {
        if constexpr (n_free == 2)
          return invert_pin_stiffness(stiffness, active.size());
        else
          {
            if (are_held(active, n_bore))
              return stiffness.inverse();
            Eigen::CompleteOrthogonalDecomposition<Square> decomposition;
            decomposition.setThreshold(1e-10);
            decomposition.compute(stiffness);
            return decomposition.pseudoInverse();
          }
      }
    };
  } // namespace Contact
} // namespace Tribody

#endif

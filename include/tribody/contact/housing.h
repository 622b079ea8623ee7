// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_contact_housing_h
#define tribody_contact_housing_h

#include <Eigen/Core>

#include <tribody/contact/pin_gap.h>
#include <tribody/surface/bore_surface.h>

namespace Tribody
{
  namespace Contact
  {
    /**
     * A rigid, round and smooth housing in which the bushing is a free ring.
     * The ring touches it with the nodes @f$X_k@f$ of its rim. Displaced as a
     * rigid body by d, it leaves the gap
     * @f[ g^0_k = R_h - |X_k + d|, \qquad
     *     \frac{\partial g^0_k}{\partial d} = -m_k, \qquad
     *     \frac{\partial^2 g^0_k}{\partial d^2} =
     *       -\frac{I - m_k m_k^T}{|X_k + d|}, \qquad
     *     m_k = \frac{X_k + d}{|X_k + d|}, @f]
     * exact like that of PinGap. Nodal forces @f$q_k \ge 0@f$ press the rim
     * against its outward normals; the ring is in equilibrium under the force F
     * of the pin if @f$ \sum_k q_k m_k = F/L @f$.
     *
     * Both contacts are solved as one, with the nodes of the rim behind those
     * of the bore in every vector and matrix. The compliance of a free ring has
     * no unique value, but for forces in equilibrium it is unique up to
     * displacements of a rigid body, which change the places of pin and ring
     * only. So any compliance will do that is right for such forces.
     */
    struct Housing
    {
      /// The rim of the undeformed ring; its normals point out of the ring.
      BoreSurface rim;
      /// R_h [m].
      double radius;
    };

    /// The gaps of @p bore followed by those of the rim with the ring displaced
    /// by @p ring_place [m]; their directions are m.
    PinGap
    append_rim(const PinGap          &bore,
               const Housing         &housing,
               const Eigen::Vector2d &ring_place);
  } // namespace Contact
} // namespace Tribody

#endif

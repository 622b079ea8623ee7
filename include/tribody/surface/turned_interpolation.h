// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_surface_turned_interpolation_h
#define tribody_surface_turned_interpolation_h

#include <Eigen/Core>

#include <tribody/surface/bore_surface.h>

namespace Tribody
{
  /**
   * How a pin feels the nodal forces in the bore, when it is turned against
   * the bushing by an angle @f$\alpha@f$ and its nodes lie elsewhere: forces
   * @f$\lambda@f$ along the bore's normals press on the pin's nodes along the
   * pin's radii by @f$ P \lambda @f$, and displacements u of the pin's nodes
   * are those of @f$ P^T u @f$ at the bore's nodes, so that their work is the
   * same.
   *
   * Bore and pin touch where their normals agree. There, the pin's displacement
   * is projected onto the bore's shape functions in the mean square,
   * @f[ P = B M^{-1}, \qquad B_{kj} = \int N_k \varphi_j\,ds, \qquad
   *     M_{ij} = \int \varphi_i \varphi_j\,ds. @f]
   * What misses then to the force of each node (as little as the curves differ
   * from circles) is added as a pressure that is a cosine around the pin, which
   * makes P conservative: @f$ \sum_k P_{kj} r_k = n_j @f$ to rounding, r_k the
   * unit radii. The pin feels no moment, since all its forces point to its
   * centre.
   *
   * @param bore the worn or unworn bore, in the bushing's frame.
   * @param pin its surface, in the pin's frame.
   * @param pin_angle alpha, by which the pin's frame is turned
   *   counter-clockwise against the bushing's [rad].
   * @return P, one row per node of the pin, one column per node of the bore.
   */
  Eigen::MatrixXd
  make_turned_interpolation(const BoreSurface &bore,
                            const BoreSurface &pin,
                            const double       pin_angle);
} // namespace Tribody

#endif

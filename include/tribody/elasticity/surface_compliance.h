// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_elasticity_surface_compliance_h
#define tribody_elasticity_surface_compliance_h

#include <Eigen/Core>

#include <string>

namespace Tribody
{
  namespace Elasticity
  {
    /// What the cells around a ring have in common.
    enum class RingSymmetry
    {
      /// Nothing.
      none,
      /// Mesh and geometry look the same from each of its cells: an unworn
      /// ring from make_ring_mesh() or make_pin_mesh().
      cells_alike
    };

    /**
     * The compliance of n surface nodes from its first p columns, p nodes
     * being the step from a cell to the next: a matrix that is circulant in
     * blocks, @f$ C_{i+p,j+p} = C_{ij} @f$, indices modulo n.
     */
    Eigen::MatrixXd
    repeat_around(const Eigen::MatrixXd &first_columns);

    /**
     * The compliance without its rounding errors: a compliance is symmetric.
     * @param body for the message.
     * @throws ExcRun if more is missing to symmetry than the rounding of a
     *   million equations, or what an iterative solver leaves of them.
     */
    Eigen::MatrixXd
    symmetric_part(const Eigen::MatrixXd &compliance, const std::string &body);
  } // namespace Elasticity
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_surface_bore_nodes_h
#define tribody_surface_bore_nodes_h

#include <deal.II/base/types.h>

#include <Eigen/Core>

#include <tribody/surface/boundary_ids.h>

#include <vector>

namespace dealii
{
  template <int dim, int spacedim>
  class DoFHandler;
}

namespace Tribody
{
  /**
   * The nodes of a vector-valued Lagrange element on the bore of a bushing
   * mesh, or on the outside of a pin's mesh, counter-clockwise. Node 0 is a
   * vertex of the mesh; with elements of degree p every p-th node is one.
   */
  struct BoreNodes
  {
    /// Degree of the element.
    unsigned int degree = 1;
    /// As-manufactured positions [m], one column per node.
    Eigen::Matrix2Xd positions;
    /// Angles of the positions about the bore's centre (0, 0) [rad],
    /// ascending from node 0, in [0, 2 pi).
    Eigen::VectorXd angles;
    /// Indices of the x degrees of freedom of each node.
    std::vector<dealii::types::global_dof_index> x_dofs;
    /// Indices of the y degrees of freedom of each node.
    std::vector<dealii::types::global_dof_index> y_dofs;

    /// Nodes around the curve; the first one is not repeated.
    Eigen::Index
    n_nodes() const
    {
      return angles.size();
    }

    /// Unit vectors from the bore's centre to the nodes, one column each: the
    /// direction in which wear depth is counted.
    Eigen::Matrix2Xd
    radial_directions() const;
  };

  /**
   * Collect the bore nodes of @p dof_handler, whose element must be
   * FESystem<2>(FE_Q<2>(p), 2). Positions are those of the mesh's manifold
   * (exactly on the circle), whatever mapping is used later.
   * @param boundary_id BoundaryIds::pin_surface for the outside of a pin,
   *   BoundaryIds::rim for the rim of a ring.
   * @throws ExcRun if the boundary with this id is not one closed curve around
   *   the origin.
   */
  BoreNodes
  make_bore_nodes(
    const dealii::DoFHandler<2, 2>  &dof_handler,
    const dealii::types::boundary_id boundary_id = BoundaryIds::bore);
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_surface_bore_surface_h
#define tribody_surface_bore_surface_h

#include <Eigen/Core>

namespace Tribody
{
  /**
   * A closed curve through nodes, piecewise polynomial of degree p with
   * Gauss-Lobatto nodes: exactly the image of the bore under an isoparametric
   * mapping of that degree. A plain value, computed from node positions alone,
   * so that no part that needs it needs the mesh.
   *
   * With the Lagrange functions @f$\varphi_i@f$ of the curve:
   * @f$ w_i = \int \varphi_i\,ds @f$ turns a nodal force per axial length into
   * a pressure, @f$ p_i = \lambda_i / w_i @f$, and
   * @f$ \mathbf w_i = \int \varphi_i \mathbf n\,ds @f$ is the derivative of the
   * enclosed area with respect to the position of node i.
   */
  struct BoreSurface
  {
    /// Polynomial degree of the pieces.
    unsigned int degree = 1;
    /// Node positions [m], counter-clockwise, one column per node.
    Eigen::Matrix2Xd positions;
    /// Lumped weights w_i [m].
    Eigen::VectorXd weights;
    /// Vector weights [m], pointing into the material, one column per node.
    Eigen::Matrix2Xd vector_weights;
    /// Unit normals at the nodes, into the material: the directions of the
    /// vector weights.
    Eigen::Matrix2Xd normals;
    /// Area inside the curve [m^2].
    double enclosed_area = 0.;

    /// Nodes around the curve; the first one is not repeated.
    Eigen::Index
    n_nodes() const
    {
      return weights.size();
    }
  };

  /**
   * The curve of degree @p degree through @p positions [m] (2 x n,
   * counter-clockwise, n a multiple of @p degree, node 0 a vertex).
   */
  BoreSurface
  make_bore_surface(const Eigen::Matrix2Xd &positions,
                    const unsigned int      degree);
} // namespace Tribody

#endif

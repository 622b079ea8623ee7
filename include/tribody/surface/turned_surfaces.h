// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_surface_turned_surfaces_h
#define tribody_surface_turned_surfaces_h

#include <deal.II/base/quadrature_lib.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <tribody/surface/bore_surface.h>

#include <memory>
#include <vector>

namespace Tribody
{
  /**
   * Carries fields between a bore and the surface of a pin that is turned
   * against it, see TurnedSurfaces. A plain value; copies share what does not
   * depend on the angle.
   */
  class TurnedTransfer
  {
  public:
    /// @f$ P\,f @f$: what amounts @p at_bore at the bore's nodes (nodal forces,
    /// areas) are at the nodes of the pin.
    Eigen::VectorXd
    to_pin(const Eigen::VectorXd &at_bore) const;

    /// @f$ P^T h @f$: what the field with the values @p at_pin at the pin's
    /// nodes is at the nodes of the bore.
    Eigen::VectorXd
    to_bore(const Eigen::VectorXd &at_pin) const;

    /// The columns of P that belong to the bore's @p nodes, to 1e-4 of their
    /// largest entry, for Jacobians. They add up to one to rounding: Newton's
    /// steps keep the balance of what leaves the bore and arrives at the pin.
    Eigen::SparseMatrix<double>
    columns(const std::vector<Eigen::Index> &nodes) const;

  private:
    friend class TurnedSurfaces;

    using Matrix = Eigen::SparseMatrix<double>;

    struct Mass
    {
      Eigen::SimplicialLDLT<Matrix> factor;
      /// What is not small in the inverse.
      Matrix inverse;
    };

    std::shared_ptr<const Mass> mass;
    /// B, one row per node of the pin, one column per node of the bore.
    Matrix mixed;
  };

  /**
   * The surfaces of a bore and of a round pin that turns in it, both of
   * piecewise polynomials with Gauss-Lobatto nodes. The pin has pieces of equal
   * angle, node 0 at the angle 0 of its own frame.
   *
   * Bore and pin touch where their normals agree. So a point of the bore faces
   * the pin at the angle @f$\psi - \alpha@f$ of the pin's frame, with
   * @f$\psi@f$ its own angle plus that by which wear has turned the bore's
   * normal there; and with the shape functions
   * @f$\varphi_j@f$ of the bore and @f$N_k@f$ of the pin
   * @f[ P = B M^{-1}, \qquad B_{kj} = \int N_k \varphi_j\,ds, \qquad
   *     M_{ij} = \int \varphi_i \varphi_j\,ds: @f]
   * @f$P^T h@f$ is the projection of the pin's field in the mean square, and
   * because @f$ \sum_k N_k = 1 @f$ all columns of P add up to one. What leaves
   * the bore arrives at the pin, to rounding.
   *
   * Unlike make_turned_interpolation(), which keeps the directions of
   * forces, this one keeps amounts. P is never formed: B is sparse, and M is a
   * narrow band, so that hundreds of angles cost little time and memory.
   */
  class TurnedSurfaces
  {
  public:
    /// @param bore the worn bore in the bushing's frame. @param unworn the
    ///   positions of its nodes as manufactured [m]. @param n_pin_pieces
    ///   around the pin, of the bore's degree.
    TurnedSurfaces(const BoreSurface      &bore,
                   const Eigen::Matrix2Xd &unworn,
                   const unsigned int      n_pin_pieces);

    /// For a pin whose frame is turned counter-clockwise by @p pin_angle
    /// [rad] against the bushing's.
    TurnedTransfer
    turned_by(const double pin_angle) const;

    /// Psi [rad] at the nodes of the worn @p bore, whose positions were @p
    /// unworn [m].
    static Eigen::VectorXd
    facing_node_angles(const BoreSurface &bore, const Eigen::Matrix2Xd &unworn);

    /// Angles [rad] of the nodes of a pin with @p n_pieces of @p degree in its
    /// own frame, ascending.
    static Eigen::VectorXd
    pin_node_angles(const unsigned int n_pieces, const unsigned int degree);

  private:
    /// Add the integral over a part of a piece to the entries of B.
    void
    integrate(const Eigen::Index                   piece,
              const double                         begin,
              const double                         end,
              const double                         pin_angle,
              std::vector<Eigen::Triplet<double>> &entries) const;

    Eigen::Index
    node(const Eigen::Index piece, const unsigned int k) const
    {
      return (piece * degree + k) % n_bore_nodes;
    }

    unsigned int      degree;
    Eigen::Index      n_bore_nodes;
    Eigen::Index      n_pin_pieces;
    dealii::QGauss<1> quadrature;
    /// Psi at the nodes of each piece of the bore [rad], one column per piece,
    /// without jumps in it.
    Eigen::MatrixXd facing_angles;
    /// Lengths of the pieces [m].
    Eigen::VectorXd                             lengths;
    std::shared_ptr<const TurnedTransfer::Mass> mass;
  };
} // namespace Tribody

#endif

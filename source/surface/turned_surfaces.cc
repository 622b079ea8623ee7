// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>
#include <deal.II/base/polynomial.h>

#include <tribody/surface/turned_surfaces.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace
  {
    // What columns() leaves out.
    constexpr double dropped = 1e-4;

    using Polynomials = std::vector<dealii::Polynomials::Polynomial<double>>;

    const Polynomials &
    shape_functions(const unsigned int degree)
    {
      static const std::vector<Polynomials> bases = [] {
        std::vector<Polynomials> result(1);
        for (unsigned int p = 1; p <= 3; ++p)
          result.push_back(
            dealii::Polynomials::generate_complete_Lagrange_basis(
              dealii::QGaussLobatto<1>(p + 1).get_points()));
        return result;
      }();
      Assert(degree > 0 && degree < bases.size(),
             dealii::ExcMessage("The degree is not 1, 2 or 3."));
      return bases[degree];
    }



    double
    angle_of(const Eigen::Vector2d &vector)
    {
      return std::atan2(vector[1], vector[0]);
    }



    Eigen::VectorXd
    shape_values(const unsigned int degree, const double s)
    {
      const Polynomials &basis = shape_functions(degree);
      Eigen::VectorXd    values(basis.size());
      for (unsigned int k = 0; k < basis.size(); ++k)
        values[k] = basis[k].value(s);
      return values;
    }



    // Where in (0, 1) an increasing function is zero.
    template <typename Function>
    double
    bisect(const Function &function)
    {
      double begin = 0., end = 1.;
      while (end - begin > 1e-13)
        {
          const double middle                   = 0.5 * (begin + end);
          (function(middle) < 0. ? begin : end) = middle;
        }
      return 0.5 * (begin + end);
    }
  } // namespace



  Eigen::VectorXd
  TurnedTransfer::to_pin(const Eigen::VectorXd &at_bore) const
  {
    return mixed * mass->factor.solve(at_bore);
  }



  Eigen::VectorXd
  TurnedTransfer::to_bore(const Eigen::VectorXd &at_pin) const
  {
    return mass->factor.solve(mixed.transpose() * at_pin);
  }



  Eigen::SparseMatrix<double>
  TurnedTransfer::columns(const std::vector<Eigen::Index> &nodes) const
  {
    Matrix chosen(mass->inverse.rows(), nodes.size());
    chosen.reserve(mass->inverse.nonZeros());
    for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        chosen.startVec(k);
        for (Matrix::InnerIterator entry(mass->inverse, nodes[k]); entry;
             ++entry)
          chosen.insertBack(entry.row(), k) = entry.value();
      }
    chosen.finalize();
    Matrix P = mixed * chosen;
    for (Eigen::Index k = 0; k < P.cols(); ++k)
      P.col(k) /= P.col(k).sum();
    return P;
  }



  TurnedSurfaces::TurnedSurfaces(const BoreSurface      &bore,
                                 const Eigen::Matrix2Xd &unworn,
                                 const unsigned int      n_pin_pieces)
    : degree(bore.degree)
    , n_bore_nodes(bore.n_nodes())
    , n_pin_pieces(n_pin_pieces)
    , quadrature(degree + 1)
    , facing_angles(degree + 1, n_bore_nodes / degree)
    , lengths(n_bore_nodes / degree)
  {
    const Eigen::VectorXd facing_angle = facing_node_angles(bore, unworn);
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index piece = 0; piece < lengths.size(); ++piece)
      {
        lengths[piece] =
          (unworn.col(node(piece, degree)) - unworn.col(node(piece, 0))).norm();
        const double first      = facing_angle[node(piece, 0)];
        facing_angles(0, piece) = first;
        for (unsigned int k = 1; k <= degree; ++k)
          facing_angles(k, piece) =
            first + std::remainder(facing_angle[node(piece, k)] - first,
                                   2. * dealii::numbers::PI);
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            const Eigen::VectorXd phi =
              shape_values(degree, quadrature.point(q)[0]);
            for (unsigned int i = 0; i <= degree; ++i)
              for (unsigned int j = 0; j <= degree; ++j)
                entries.emplace_back(node(piece, i),
                                     node(piece, j),
                                     phi[i] * phi[j] * lengths[piece] *
                                       quadrature.weight(q));
          }
      }

    TurnedTransfer::Matrix matrix(n_bore_nodes, n_bore_nodes);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const auto made = std::make_shared<TurnedTransfer::Mass>();
    made->factor.compute(matrix);
    const Eigen::MatrixXd inverse =
      made->factor.solve(Eigen::MatrixXd::Identity(n_bore_nodes, n_bore_nodes));
    made->inverse = inverse.sparseView(inverse.maxCoeff(), dropped);
    mass          = made;
  }



  TurnedTransfer
  TurnedSurfaces::turned_by(const double pin_angle) const
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(2 * lengths.size() * (degree + 2) * (degree + 1) *
                    (degree + 1));
    for (Eigen::Index piece = 0; piece < lengths.size(); ++piece)
      {
        // Number of the piece of the pin, with its fraction. Where wear ends,
        // the normals of a piece may turn back: parts without breaks then, for
        // which the integral is a little less accurate and as conservative.
        const auto place = [&](const double s) {
          return (shape_values(degree, s).dot(facing_angles.col(piece)) -
                  pin_angle) *
                 n_pin_pieces / (2. * dealii::numbers::PI);
        };
        double       begin = 0.;
        const double last  = std::ceil(place(1.)) - 0.5;
        for (double k = std::floor(place(0.)) + 1.; k < last; ++k)
          {
            const double end =
              bisect([&](const double s) { return place(s) - k; });
            integrate(piece, begin, end, pin_angle, entries);
            begin = end;
          }
        integrate(piece, begin, 1., pin_angle, entries);
      }

    TurnedTransfer transfer;
    transfer.mass = mass;
    transfer.mixed.resize(n_pin_pieces * degree, n_bore_nodes);
    transfer.mixed.setFromTriplets(entries.begin(), entries.end());
    return transfer;
  }



  void
  TurnedSurfaces::integrate(const Eigen::Index                   piece,
                            const double                         begin,
                            const double                         end,
                            const double                         pin_angle,
                            std::vector<Eigen::Triplet<double>> &entries) const
  {
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const double s = begin + (end - begin) * quadrature.point(q)[0];
        const double weight =
          lengths[piece] * (end - begin) * quadrature.weight(q);
        const Eigen::VectorXd phi = shape_values(degree, s);
        const double place = (phi.dot(facing_angles.col(piece)) - pin_angle) *
                             n_pin_pieces / (2. * dealii::numbers::PI);
        const double       whole     = std::floor(place);
        const Eigen::Index pin_piece = static_cast<Eigen::Index>(
          whole - n_pin_pieces * std::floor(whole / n_pin_pieces));
        const Eigen::VectorXd N = shape_values(degree, place - whole);
        for (unsigned int j = 0; j <= degree; ++j)
          for (unsigned int k = 0; k <= degree; ++k)
            entries.emplace_back((pin_piece * degree + k) %
                                   (n_pin_pieces * degree),
                                 node(piece, j),
                                 N[k] * phi[j] * weight);
      }
  }



  Eigen::VectorXd
  TurnedSurfaces::facing_node_angles(const BoreSurface      &bore,
                                     const Eigen::Matrix2Xd &unworn)
  {
    // The curve's normals at its nodes are not quite the radii, not even of a
    // round bore: what wear changes in them is.
    const Eigen::Matrix2Xd unworn_normals =
      make_bore_surface(unworn, bore.degree).normals;
    Eigen::VectorXd angles(bore.n_nodes());
    for (Eigen::Index i = 0; i < angles.size(); ++i)
      angles[i] = angle_of(unworn.col(i)) + angle_of(bore.normals.col(i)) -
                  angle_of(unworn_normals.col(i));
    return angles;
  }



  Eigen::VectorXd
  TurnedSurfaces::pin_node_angles(const unsigned int n_pieces,
                                  const unsigned int degree)
  {
    const dealii::QGaussLobatto<1> nodes(degree + 1);
    Eigen::VectorXd                angles(n_pieces * degree);
    for (unsigned int piece = 0; piece < n_pieces; ++piece)
      for (unsigned int k = 0; k < degree; ++k)
        angles[piece * degree + k] =
          2. * dealii::numbers::PI * (piece + nodes.point(k)[0]) / n_pieces;
    return angles;
  }
} // namespace Tribody

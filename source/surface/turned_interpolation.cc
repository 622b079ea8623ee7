// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>
#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <tribody/surface/turned_interpolation.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Tribody
{
  namespace
  {
    double
    cross(const Eigen::Vector2d &a, const Eigen::Vector2d &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }

    /// One curve, piece by piece.
    class CurvePieces
    {
    public:
      explicit CurvePieces(const BoreSurface &curve)
        : curve(curve)
        , basis(dealii::Polynomials::generate_complete_Lagrange_basis(
            dealii::QGaussLobatto<1>(curve.degree + 1).get_points()))
      {}

      Eigen::Index
      n_pieces() const
      {
        return curve.n_nodes() / curve.degree;
      }

      unsigned int
      nodes_per_piece() const
      {
        return curve.degree + 1;
      }

      /// Index of the k-th node of a piece.
      Eigen::Index
      node(const Eigen::Index piece, const unsigned int k) const
      {
        return (piece * curve.degree + k) % curve.n_nodes();
      }

      Eigen::VectorXd
      shape_values(const double s) const
      {
        Eigen::VectorXd values(basis.size());
        for (unsigned int k = 0; k < basis.size(); ++k)
          values[k] = basis[k].value(s);
        return values;
      }

      /// Position and derivative at @p s in [0, 1] of a piece.
      std::pair<Eigen::Vector2d, Eigen::Vector2d>
      evaluate(const Eigen::Index piece, const double s) const
      {
        std::pair<Eigen::Vector2d, Eigen::Vector2d> x{{0., 0.}, {0., 0.}};
        std::vector<double>                         values(2);
        for (unsigned int k = 0; k < basis.size(); ++k)
          {
            basis[k].value(s, values);
            x.first += values[0] * curve.positions.col(node(piece, k));
            x.second += values[1] * curve.positions.col(node(piece, k));
          }
        return x;
      }

      /// Length element at @p s of a piece [m].
      double
      length_element(const Eigen::Index piece, const double s) const
      {
        return evaluate(piece, s).second.norm();
      }

      /// The normals of the nodes, interpolated: continuous, unlike those of
      /// the pieces.
      Eigen::Vector2d
      normal(const Eigen::Index piece, const double s) const
      {
        const Eigen::VectorXd values = shape_values(s);
        Eigen::Vector2d       normal(0., 0.);
        for (unsigned int k = 0; k < basis.size(); ++k)
          normal += values[k] * curve.normals.col(node(piece, k));
        return normal;
      }

    private:
      const BoreSurface                                   &curve;
      std::vector<dealii::Polynomials::Polynomial<double>> basis;
    };

    /// The pin, whose pieces are found by direction from its centre.
    class PinPieces : public CurvePieces
    {
    public:
      PinPieces(const BoreSurface &pin, const double turned_by)
        : CurvePieces(pin)
        , to_pin_frame(Eigen::Rotation2Dd(-turned_by).toRotationMatrix())
      {
        for (Eigen::Index i = 0; i < n_pieces(); ++i)
          {
            const Eigen::Vector2d vertex = pin.positions.col(node(i, 0));
            angles.push_back(std::atan2(vertex[1], vertex[0]));
            if (i > 0 && angles[i] < angles[0])
              angles[i] += 2. * dealii::numbers::PI;
          }
      }

      /// The piece that lies in a @p direction of the bushing's frame, and
      /// where on it.
      std::pair<Eigen::Index, double>
      find(const Eigen::Vector2d &direction) const
      {
        const Eigen::Vector2d d     = to_pin_frame * direction.normalized();
        double                angle = std::atan2(d[1], d[0]) - angles[0];
        angle += angles[0] - 2. * dealii::numbers::PI *
                               std::floor(angle / (2. * dealii::numbers::PI));
        const auto next = std::upper_bound(angles.begin(), angles.end(), angle);
        const Eigen::Index piece = next - angles.begin() - 1;
        const double       end =
          (next == angles.end()) ? angles[0] + 2. * dealii::numbers::PI : *next;
        double s = (angle - angles[piece]) / (end - angles[piece]);
        // Newton's method on the nearly linear angle: three steps are exact.
        for (unsigned int k = 0; k < 3; ++k)
          {
            const auto [x, derivative] = evaluate(piece, s);
            s -= cross(d, x) / cross(d, derivative);
          }
        return {piece, s};
      }

    private:
      Eigen::Matrix2d     to_pin_frame;
      std::vector<double> angles;
    };

    /// Where a piece of the bore passes from one piece of the pin to another
    /// between @p begin and @p end, ascending, by bisection.
    void
    find_breaks(const CurvePieces   &bore,
                const PinPieces     &pin,
                const Eigen::Index   piece,
                const double         begin,
                const double         end,
                std::vector<double> &breaks)
    {
      constexpr double resolution = 1e-10;
      if (pin.find(bore.normal(piece, begin)).first ==
          pin.find(bore.normal(piece, end)).first)
        return;
      const double middle = 0.5 * (begin + end);
      if (end - begin < resolution)
        {
          breaks.push_back(middle);
          return;
        }
      find_breaks(bore, pin, piece, begin, middle, breaks);
      find_breaks(bore, pin, piece, middle, end, breaks);
    }

    struct CouplingMatrices
    {
      Eigen::MatrixXd mixed;
      Eigen::MatrixXd mass;
    };

    CouplingMatrices
    integrate(const BoreSurface &bore_curve,
              const BoreSurface &pin_curve,
              const double       pin_angle)
    {
      const CurvePieces       bore(bore_curve);
      const PinPieces         pin(pin_curve, pin_angle);
      const dealii::QGauss<1> quadrature(
        std::max(bore_curve.degree, pin_curve.degree) + 2);

      const Eigen::Index n_bore = bore_curve.n_nodes();
      CouplingMatrices   result{Eigen::MatrixXd::Zero(pin_curve.n_nodes(),
                                                    n_bore),
                              Eigen::MatrixXd::Zero(n_bore, n_bore)};
      for (Eigen::Index piece = 0; piece < bore.n_pieces(); ++piece)
        {
          std::vector<double> ends{0.};
          find_breaks(bore, pin, piece, 0., 1., ends);
          ends.push_back(1.);
          for (std::size_t part = 1; part < ends.size(); ++part)
            for (unsigned int q = 0; q < quadrature.size(); ++q)
              {
                const double length = ends[part] - ends[part - 1];
                const double s =
                  ends[part - 1] + length * quadrature.point(q)[0];
                const Eigen::Vector2d normal     = bore.normal(piece, s);
                const auto [pin_piece, on_piece] = pin.find(normal);
                const Eigen::VectorXd phi        = bore.shape_values(s);
                const Eigen::VectorXd N          = pin.shape_values(on_piece);
                const double          ds =
                  bore.length_element(piece, s) * length * quadrature.weight(q);
                for (unsigned int j = 0; j < bore.nodes_per_piece(); ++j)
                  {
                    const Eigen::Index column = bore.node(piece, j);
                    for (unsigned int i = 0; i < bore.nodes_per_piece(); ++i)
                      result.mass(bore.node(piece, i), column) +=
                        phi[i] * phi[j] * ds;
                    for (unsigned int k = 0; k < pin.nodes_per_piece(); ++k)
                      result.mixed(pin.node(pin_piece, k), column) +=
                        N[k] * phi[j] * ds;
                  }
              }
        }
      return result;
    }
  } // namespace



  Eigen::MatrixXd
  make_turned_interpolation(const BoreSurface &bore,
                            const BoreSurface &pin,
                            const double       pin_angle)
  {
    const CouplingMatrices matrices = integrate(bore, pin, pin_angle);
    Eigen::MatrixXd        P        = Eigen::LLT<Eigen::MatrixXd>(matrices.mass)
                          .solve(matrices.mixed.transpose())
                          .transpose();

    const Eigen::Matrix2Xd normals =
      Eigen::Rotation2Dd(pin_angle).toRotationMatrix() *
      pin.positions.colwise().normalized();
    const Eigen::Matrix2Xd weighted = normals * pin.weights.asDiagonal();
    const Eigen::Matrix2d resultant_of_cosines = weighted * normals.transpose();
    const Eigen::Matrix2Xd missing             = bore.normals - normals * P;
    P += weighted.transpose() * (resultant_of_cosines.inverse() * missing);
    return P;
  }
} // namespace Tribody

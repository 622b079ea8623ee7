// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>
#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <tribody/elasticity/pressure_models.h>
#include <tribody/elasticity/surface_compliance.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Tribody
{
  namespace Elasticity
  {
    namespace
    {
      double
      angle_of(const BoreSurface &bore, const Eigen::Index node)
      {
        return std::atan2(bore.positions(1, node), bore.positions(0, node));
      }

      double
      positive_turn(const double angle)
      {
        return angle < 0. ? angle + 2. * dealii::numbers::PI : angle;
      }

      /**
       * The shape functions of the bore curve as functions of the angle about
       * its centre: their values at quadrature points.
       */
      struct Shapes
      {
        explicit Shapes(const BoreSurface &bore)
        {
          const Eigen::Index p = bore.degree, n = bore.n_nodes();
          const auto         basis =
            dealii::Polynomials::generate_complete_Lagrange_basis(
              dealii::QGaussLobatto<1>(p + 1).get_points());
          // Two waves between two nodes, and so some 4 p in a piece, are the
          // shortest to be integrated.
          const dealii::QGauss<1> quadrature(8 * p + 4);
          const Eigen::Index      n_q = quadrature.size();

          angles.resize(n / p * n_q);
          weights.resize(n / p * n_q);
          std::vector<Eigen::Triplet<double>> entries;
          for (Eigen::Index first = 0; first < n; first += p)
            {
              const double begin = angle_of(bore, first);
              const double width =
                positive_turn(angle_of(bore, (first + p) % n) - begin);
              for (Eigen::Index q = 0; q < n_q; ++q)
                {
                  const double       x      = quadrature.point(q)[0];
                  const Eigen::Index column = first / p * n_q + q;
                  angles[column]            = begin + width * x;
                  weights[column]           = width * quadrature.weight(q);
                  for (Eigen::Index k = 0; k <= p; ++k)
                    entries.emplace_back((first + k) % n,
                                         column,
                                         basis[k].value(x));
                }
            }
          values.resize(n, angles.size());
          values.setFromTriplets(entries.begin(), entries.end());
        }

        /// One row per node, one column per quadrature point.
        Eigen::SparseMatrix<double> values;
        /// Of the quadrature points [rad], and their weights [rad].
        Eigen::ArrayXd  angles;
        Eigen::VectorXd weights;
      };

      /// Whether the nodes of all pieces weigh the same.
      bool
      pieces_are_alike(const BoreSurface &bore)
      {
        const Eigen::Index p = bore.degree, n = bore.n_nodes();
        return (bore.weights.tail(n - p) - bore.weights.head(n - p))
                 .lpNorm<Eigen::Infinity>() < 1e-9 * bore.weights.maxCoeff();
      }

      /// Displacement [m/Pa] of the hole under unit pressure cos n theta.
      double
      hole_compliance(const PlaneHooke &law,
                      const double      radius,
                      const double      held_radius,
                      const double      n)
      {
        const double kappa = (law.lambda + 3. * law.mu) / (law.lambda + law.mu);
        if (n == 0.)
          return radius / (2. * law.mu);
        if (n == 1.)
          return radius * kappa * std::log(held_radius / radius) /
                 (2. * law.mu * (kappa + 1.));
        return radius / (4. * law.mu) * ((kappa + 1.) * n + (kappa - 1.)) /
               (n * n - 1.);
      }
    } // namespace



    Eigen::MatrixXd
    winkler_compliance(const BoreSurface &bore,
                       const PlaneHooke  &law,
                       const double       outer_radius)
    {
      const Eigen::VectorXd thickness =
        (outer_radius - bore.positions.colwise().norm().array()).matrix();
      return (thickness / (law.lambda + 2. * law.mu))
        .cwiseQuotient(bore.weights)
        .asDiagonal();
    }



    Eigen::MatrixXd
    infinite_plate_compliance(const BoreSurface &bore,
                              const PlaneHooke  &law,
                              const double       held_radius)
    {
      const Eigen::Index n_nodes   = bore.n_nodes();
      const double       radius    = bore.positions.col(0).norm();
      const bool         alike     = pieces_are_alike(bore);
      const Eigen::Index n_columns = alike ? bore.degree : n_nodes;

      const Shapes                                             shapes(bore);
      const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> mass(
        shapes.values * shapes.weights.asDiagonal() *
        shapes.values.transpose());

      // The terms fall like the fifth power of n once it has a wave between two
      // nodes.
      double spacing = 2. * dealii::numbers::PI;
      for (Eigen::Index i = 0; i < n_nodes; ++i)
        spacing = std::min(spacing,
                           positive_turn(angle_of(bore, (i + 1) % n_nodes) -
                                         angle_of(bore, i)));
      const auto n_terms =
        static_cast<Eigen::Index>(4. * dealii::numbers::PI / spacing);

      Eigen::MatrixXd compliance(n_nodes, n_columns);
      compliance.setConstant(hole_compliance(law, radius, held_radius, 0.) /
                             (2. * dealii::numbers::PI * radius));
      constexpr Eigen::Index block = 64;
      for (Eigen::Index first = 1; first <= n_terms; first += block)
        {
          const Eigen::Index n = std::min(block, n_terms + 1 - first);
          Eigen::MatrixXd    waves(shapes.angles.size(), 2 * n);
          Eigen::VectorXd    factors(2 * n);
          for (Eigen::Index k = 0; k < n; ++k)
            {
              const double order = static_cast<double>(first + k);
              waves.col(k)       = (order * shapes.angles).cos();
              waves.col(n + k)   = (order * shapes.angles).sin();
              factors[k]         = factors[n + k] =
                hole_compliance(law, radius, held_radius, order) /
                (dealii::numbers::PI * radius);
            }
          const Eigen::MatrixXd integrals =
            shapes.values * (shapes.weights.asDiagonal() * waves);
          const Eigen::MatrixXd projected = mass.solve(integrals);
          compliance.noalias() += projected * factors.asDiagonal() *
                                  projected.topRows(n_columns).transpose();
        }
      return symmetric_part(alike ? repeat_around(compliance) : compliance,
                            "plate");
    }
  } // namespace Elasticity
} // namespace Tribody

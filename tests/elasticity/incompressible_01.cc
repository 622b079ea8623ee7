// SPDX-License-Identifier: LGPL-2.1-or-later

// Rings that hardly change their volume, as rubber. Closed forms in plane
// strain: a hole in an infinite plate under p cos n t moves as in harmonics_01,
// and a ring under pressure p in the bore, clamped at its rim b, by u(a) = A (a
// - b^2/a) with A = -p/(2 (lambda + mu) + 2 mu b^2/a^2), which vanishes as nu
// goes to 1/2; its error is relative to the motion of a free hole, p a/(2 mu).
// Elements that lock are too stiff: at nu = 0.49999 linear ones have 6 % of the
// motion of the hole, quadratic ones 2.5 % too little.

#include <deal.II/base/mpi.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>

#include <tribody/elasticity/bushing_elasticity.h>
#include <tribody/elasticity/ring_mesh.h>
#include <tribody/surface/bore_surface.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <vector>

using namespace Tribody;
using namespace Tribody::Elasticity;

constexpr double a = 10e-3;

/// Errors of the displacements under p cos n t, relative to the closed forms or
/// to a free hole.
std::vector<double>
errors(const unsigned int               degree,
       const Material                  &material,
       const RingMeshParameters        &mesh,
       const double                     b,
       const std::vector<unsigned int> &waves)
{
  const PlaneHooke         law(material, PlaneState::strain);
  dealii::Triangulation<2> triangulation;
  make_ring_mesh(mesh, a, b, triangulation);
  BushingElasticity ring(triangulation, degree, material, PlaneState::strain);
  ring.reinit(dealii::MappingQ<2>(degree));
  const BoreNodes      &nodes   = ring.bore_nodes();
  const BoreSurface     surface = make_bore_surface(nodes.positions, degree);
  const Eigen::MatrixXd C = ring.normal_compliance(nodes.radial_directions(),
                                                   RingSymmetry::cells_alike);

  std::vector<double> result;
  for (const unsigned int n : waves)
    {
      const double A =
        -1. / (2. * (law.lambda + law.mu) + 2. * law.mu * b * b / (a * a));
      const double          kappa   = 3. - 4. * material.poissons_ratio;
      const double          exact   = n == 0 ? A * (a - b * b / a)
                                             : a / (4. * law.mu) *
                                      ((kappa + 1.) * n + (kappa - 1.)) /
                                      (static_cast<double>(n) * n - 1.);
      const Eigen::VectorXd cosines = (n * nodes.angles.array()).cos();
      const double          computed =
        (C * surface.weights.cwiseProduct(cosines)).dot(cosines) /
        cosines.squaredNorm();
      result.push_back(std::abs(computed - exact) /
                       (n == 0 ? a / (2. * law.mu) : exact));
    }
  return result;
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::setprecision(7);
  for (unsigned int degree = 1; degree <= 3; ++degree)
    for (const double nu : {0.3, 0.499, 0.49999, 0.4999999})
      {
        const Material     rubber{"rubber", 1.4e6, nu, 1100.};
        const unsigned int n = 360 / degree;
        const auto ring      = errors(degree, rubber, {n, 12, 1.}, 2. * a, {0});
        const auto hole =
          errors(degree, rubber, {n, 40, 3.}, 100. * a, {2, 3, 4, 6, 8});
        const double worst = *std::max_element(hole.begin(), hole.end());
        std::cout << "degree " << degree << ", nu = " << nu
                  << ": clamped ring right to 0.1 % " << (ring[0] < 1e-3)
                  << "; hole right to 2 % " << (worst < 0.02) << ", to 0.1 % "
                  << (worst < 1e-3) << std::endl;
      }
}

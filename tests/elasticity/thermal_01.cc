// SPDX-License-Identifier: LGPL-2.1-or-later

// A heated ring in a rigid housing, clamped at its rim b: how far its bore a
// moves inwards. Closed form (Timoshenko and Goodier, Theory of Elasticity,
// section 150) in plane stress,
//   u(r) = (1 + nu) alpha/r int_a^r T r dr + A r + B/r,
// with u(b) = 0 and no stress at the bore: (1 + nu) A - (1 - nu) B/a^2 = 0; in
// plane strain with nu/(1 - nu) and (1 + nu) alpha for nu and alpha. The
// temperature is the same everywhere, or T = T_a ln(b/r)/ln(b/a). On a soft
// foundation a uniformly heated ring grows as if it were free, u(a) = alpha T a
// in plane stress and (1 + nu) alpha T a in plane strain.
// Quadratic elements are right to 1e-4 on this mesh; linear ones, whose
// temperature is constant in each cell, to 1 %.

#include <deal.II/base/function.h>
#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/vector_tools_interpolate.h>

#include <tribody/elasticity/bushing_elasticity.h>
#include <tribody/elasticity/ring_mesh.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace Tribody;
using namespace Tribody::Elasticity;

namespace
{
  constexpr double a = 9.535e-3, b = 15.875e-3, rise = 20., expansion = 1.3e-4;



  struct Logarithm : dealii::Function<2>
  {
    double
    value(const dealii::Point<2> &x, const unsigned int = 0) const override
    {
      return rise * std::log(b / x.norm()) / std::log(b / a);
    }
  };



  // int_a^b T r dr.
  double
  moment(const bool is_uniform)
  {
    if (is_uniform)
      return rise * (b * b - a * a) / 2.;
    return rise / std::log(b / a) *
           ((b * b - a * a) / 4. - a * a / 2. * std::log(b / a));
  }



  double
  exact(const bool is_uniform, double nu, const PlaneState state)
  {
    double alpha = expansion;
    if (state == PlaneState::strain)
      {
        alpha *= 1. + nu;
        nu /= 1. - nu;
      }
    // A b + B/b = -(1 + nu) alpha/b int, A = (1 - nu)/(1 + nu) B/a^2.
    const double B = -(1. + nu) * alpha / b * moment(is_uniform) /
                     ((1. - nu) / (1. + nu) * b / (a * a) + 1. / b);
    return (1. - nu) / (1. + nu) * B / a + B / a;
  }



  double
  computed(const bool         is_uniform,
           const double       nu,
           const PlaneState   state,
           const unsigned int degree,
           const RimSupport  &support = {})
  {
    dealii::Triangulation<2> mesh;
    make_ring_mesh({96, 12, 1.}, a, b, mesh);
    BushingElasticity ring(
      mesh, degree, {"PTFE", 0.139e9, nu, 2160.}, state, support);
    const dealii::MappingQ<2> mapping(degree);
    ring.reinit(mapping);
    const dealii::FE_Q<2> fe(degree);
    dealii::DoFHandler<2> temperatures(mesh);
    temperatures.distribute_dofs(fe);
    dealii::Vector<double> T(temperatures.n_dofs());
    if (is_uniform)
      T = rise;
    else
      dealii::VectorTools::interpolate(mapping, temperatures, Logarithm(), T);
    return ring
      .thermal_displacement(mapping,
                            ring.bore_nodes().radial_directions(),
                            temperatures,
                            T,
                            expansion)
      .mean();
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::setprecision(4);
  for (const PlaneState state : {PlaneState::strain, PlaneState::stress})
    for (const bool is_uniform : {true, false})
      for (const double nu : {0.38, 0.4999})
        {
          const double known = exact(is_uniform, nu, state);
          std::cout << name_of(state) << ", "
                    << (is_uniform ? "uniform" : "logarithmic") << ", nu " << nu
                    << ": bore moves by " << 1e6 * known
                    << " um; right to 1 %, 0.01 %:";
          for (unsigned int degree = 1; degree <= 2; ++degree)
            {
              const double error =
                std::abs(computed(is_uniform, nu, state, degree) / known - 1.);
              std::cout << ' ' << (error < (degree == 1 ? 1e-2 : 1e-4));
            }
          std::cout << std::endl;
        }
  RimSupport soft;
  soft.kind             = RimSupport::Kind::elastic_foundation;
  soft.normal_stiffness = 1.;
  for (const PlaneState state : {PlaneState::strain, PlaneState::stress})
    {
      const double free =
        (state == PlaneState::strain ? 1.38 : 1.) * expansion * rise * a;
      std::cout << name_of(state) << ", free: right to 0.01 % "
                << (std::abs(computed(true, 0.38, state, 2, soft) / free - 1.) <
                    1e-4)
                << std::endl;
    }
}

// SPDX-License-Identifier: LGPL-2.1-or-later

// A ring under pressure in its bore, clamped at the rim (Lame): u = A r + B/r
// with u(b) = 0 and sigma_r(a) = -p, in plane strain and plane stress. The
// L2 error of the displacement must fall at the rates 2, 3 (and 4) for degrees
// 1, 2 (and 3), the stress (in-plane, axial, von Mises, by the postprocessor)
// at one less. The stresses are compared with those of Hooke's law in three
// dimensions, with the axial strain that the plane state implies. The pressure
// enters as nodal forces p w_i with the vector weights of the bore curve,
// which for a constant pressure are the consistent ones. Last, the compliance
// must be that of its definition: its quadratic form is the work of forces.

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/vector.h>

#include <tribody/elasticity/bushing_elasticity.h>
#include <tribody/elasticity/ring_mesh.h>
#include <tribody/elasticity/stress_postprocessor.h>
#include <tribody/surface/bore_surface.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace Tribody;
using namespace Tribody::Elasticity;

constexpr double a = 9.535e-3, b = 15.875e-3, pressure = 1e6;

/// The exact solution, from Hooke's law in three dimensions.
struct Lame
{
  Lame(const Material &material, const PlaneState state)
  {
    const double E = material.youngs_modulus, nu = material.poissons_ratio;
    mu     = E / (2. * (1. + nu));
    lambda = E * nu / ((1. + nu) * (1. - 2. * nu));
    // eps_z = zeta (eps_x + eps_y)
    zeta = (state == PlaneState::strain) ? 0. : -nu / (1. - nu);
    // sigma_r(a) = 2 lambda (1 + zeta) A + 2 mu (A - B/a^2), B = -A b^2
    A = -pressure /
        (2. * lambda * (1. + zeta) + 2. * mu * (1. + b * b / (a * a)));
    B = -A * b * b;
  }

  dealii::Tensor<1, 2>
  displacement(const dealii::Point<2> &x) const
  {
    return (A + B / x.norm_square()) * x;
  }

  /// xx, xy, yx, yy, zz, von Mises.
  dealii::Vector<double>
  stress(const dealii::Point<2> &x) const
  {
    const double         r2 = x.norm_square();
    dealii::Tensor<2, 3> strain;
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < 2; ++j)
        strain[i][j] =
          (i == j ? A + B / r2 : 0.) - 2. * B * x[i] * x[j] / (r2 * r2);
    strain[2][2]           = zeta * 2. * A;
    dealii::Tensor<2, 3> s = 2. * mu * strain;
    for (unsigned int i = 0; i < 3; ++i)
      s[i][i] += lambda * (1. + zeta) * 2. * A;
    dealii::Tensor<2, 3> deviator = s;
    for (unsigned int i = 0; i < 3; ++i)
      deviator[i][i] -= trace(s) / 3.;

    dealii::Vector<double> result(6);
    result[0] = s[0][0];
    result[1] = result[2] = s[0][1];
    result[3]             = s[1][1];
    result[4]             = s[2][2];
    result[5]             = std::sqrt(1.5) * deviator.norm();
    return result;
  }

  double mu, lambda, zeta, A, B;
};

/// Relative L2 errors of displacement and stress.
std::pair<double, double>
compute_errors(const BushingElasticity  &elasticity,
               const dealii::Mapping<2> &mapping,
               const MeshVector         &solution,
               const Lame               &exact)
{
  const auto               &fe = elasticity.get_dof_handler().get_fe();
  const StressPostprocessor stress(elasticity.hooke());
  const dealii::QGauss<2>   quadrature(fe.degree + 3);
  dealii::FEValues<2>       fe_values(mapping,
                                fe,
                                quadrature,
                                dealii::update_values |
                                  dealii::update_gradients |
                                  dealii::update_quadrature_points |
                                  dealii::update_JxW_values);
  const unsigned int        n = quadrature.size();

  std::vector<dealii::Vector<double>> values(n, dealii::Vector<double>(2));
  std::vector<dealii::Vector<double>> stresses(n, dealii::Vector<double>(6));
  dealii::DataPostprocessorInputs::Vector<2> inputs;
  inputs.solution_gradients.resize(n, std::vector<dealii::Tensor<1, 2>>(2));
  double u_error = 0., u_norm = 0., s_error = 0., s_norm = 0.;
  for (const auto &cell : elasticity.get_dof_handler().active_cell_iterators())
    {
      fe_values.reinit(cell);
      fe_values.get_function_values(solution, values);
      fe_values.get_function_gradients(solution, inputs.solution_gradients);
      stress.evaluate_vector_field(inputs, stresses);
      for (unsigned int q = 0; q < n; ++q)
        {
          const auto &x   = fe_values.quadrature_point(q);
          const auto  u   = exact.displacement(x);
          auto        s   = exact.stress(x);
          const auto  JxW = fe_values.JxW(q);
          u_error += (std::pow(u[0] - values[q][0], 2) +
                      std::pow(u[1] - values[q][1], 2)) *
                     JxW;
          u_norm += u.norm_square() * JxW;
          s_norm += s.norm_sqr() * JxW;
          s -= stresses[q];
          s_error += s.norm_sqr() * JxW;
        }
    }
  return {std::sqrt(u_error / u_norm), std::sqrt(s_error / s_norm)};
}

void
check(const unsigned int degree, const PlaneState state)
{
  const Material            material{"PTFE", 0.139e9, 0.38, 2160.};
  std::pair<double, double> coarse, fine;
  double                    work_error = 0.;
  for (const unsigned int n : {24, 48})
    {
      RingMeshParameters parameters;
      parameters.n_bore_cells   = n;
      parameters.n_radial_cells = n / 8;
      parameters.grading        = 1.;
      dealii::Triangulation<2> triangulation;
      make_ring_mesh(parameters, a, b, triangulation);
      const dealii::MappingQ<2> mapping(degree);
      BushingElasticity elasticity(triangulation, degree, material, state);
      elasticity.reinit(mapping);
      const BoreSurface surface =
        make_bore_surface(elasticity.bore_nodes().positions, degree);
      const auto solution = elasticity.solve(pressure * surface.vector_weights);
      coarse              = fine;
      fine =
        compute_errors(elasticity, mapping, solution, Lame(material, state));

      const Eigen::MatrixXd C = elasticity.normal_compliance(surface.normals);
      const Eigen::VectorXd forces =
        pressure * surface.vector_weights.colwise().norm();
      double work = 0.;
      for (Eigen::Index i = 0; i < forces.size(); ++i)
        work +=
          forces[i] *
          (surface.normals(0, i) * solution[elasticity.bore_nodes().x_dofs[i]] +
           surface.normals(1, i) * solution[elasticity.bore_nodes().y_dofs[i]]);
      work_error = std::abs(forces.dot(C * forces) / work - 1.);
    }
  std::cout << "plane " << (state == PlaneState::strain ? "strain" : "stress")
            << ", degree " << degree << ": displacement error "
            << 1e3 * fine.first << "e-3, rate "
            << std::log2(coarse.first / fine.first) << "; stress rate "
            << std::log2(coarse.second / fine.second)
            // Two direct solutions, equal to their rounding.
            << "; work right to 1e-10: " << (work_error < 1e-10) << std::endl;
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::fixed << std::setprecision(3);
  for (const auto state : {PlaneState::strain, PlaneState::stress})
    for (unsigned int degree = 1; degree <= 3; ++degree)
      check(degree, state);
}

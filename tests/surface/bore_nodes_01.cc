// SPDX-License-Identifier: LGPL-2.1-or-later

// The nodes of a bushing mesh in its bore. Known: on a ring with n cells around
// the bore and elements of degree p there are n p of them, on the circle, every
// p-th at a multiple of 2 pi / n, beginning with angle zero; the dofs of a node
// carry its coordinates when the positions of all nodes are interpolated. A
// mesh refined at one side of the bore has one node set as well. A boundary
// that is open, missing, or that does not go around the origin is refused.

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/vector_tools_interpolate.h>

#include <tribody/base/exceptions.h>
#include <tribody/surface/bore_nodes.h>
#include <tribody/surface/boundary_ids.h>

#include <cmath>
#include <iostream>

using namespace Tribody;

constexpr double       radius  = 9.535e-3;
constexpr unsigned int n_cells = 12;

void
make_ring(dealii::Triangulation<2> &triangulation)
{
  dealii::GridGenerator::hyper_shell(
    triangulation, dealii::Point<2>(), radius, 1.6 * radius, n_cells, true);
}

void
refine_at_the_right(dealii::Triangulation<2> &triangulation)
{
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->center()[0] > radius)
      cell->set_refine_flag();
  triangulation.execute_coarsening_and_refinement();
}

void
check(const dealii::Triangulation<2> &triangulation, const unsigned int degree)
{
  const dealii::FESystem<2> fe(dealii::FE_Q<2>(degree), 2);
  dealii::DoFHandler<2>     dof_handler(triangulation);
  dof_handler.distribute_dofs(fe);
  const BoreNodes        nodes = make_bore_nodes(dof_handler);
  const Eigen::Index     n     = nodes.n_nodes();
  dealii::Vector<double> positions(dof_handler.n_dofs());
  dealii::VectorTools::get_position_vector(dof_handler, positions);

  double       off_circle = 0., off_angle = 0., off_dofs = 0.;
  Eigen::Index n_descents = 0, n_regular_vertices = 0;
  for (Eigen::Index i = 0; i < n; ++i)
    {
      const Eigen::Vector2d x = nodes.positions.col(i);
      const Eigen::Vector2d by_dofs(positions[nodes.x_dofs[i]],
                                    positions[nodes.y_dofs[i]]);
      const Eigen::Vector2d by_angle(std::cos(nodes.angles[i]),
                                     std::sin(nodes.angles[i]));
      off_circle = std::max(off_circle, std::abs(x.norm() - radius));
      off_angle  = std::max(off_angle, (x - radius * by_angle).norm());
      off_dofs   = std::max(off_dofs, (x - by_dofs).norm());
      if (i > 0 && nodes.angles[i] <= nodes.angles[i - 1])
        ++n_descents;
      const double in_cells = nodes.angles[i] * n_cells / (2. * M_PI);
      if (i % degree == 0 && std::abs(in_cells - std::round(in_cells)) < 1e-12)
        ++n_regular_vertices;
    }
  // Rounding: 1e-12 is a thousand of them.
  std::cout << "degree " << degree << ": " << n << " nodes, "
            << n_regular_vertices << " of them vertices of the first mesh"
            << ", first angle " << nodes.angles[0] << ", descents "
            << n_descents << ", on the circle " << (off_circle < 1e-12 * radius)
            << ", at their angles " << (off_angle < 1e-12 * radius)
            << ", at their dofs " << (off_dofs < 1e-12 * radius) << std::endl;
}

void
check_refusal(const dealii::Triangulation<2> &triangulation)
{
  const dealii::FESystem<2> fe(dealii::FE_Q<2>(2), 2);
  dealii::DoFHandler<2>     dof_handler(triangulation);
  dof_handler.distribute_dofs(fe);
  try
    {
      make_bore_nodes(dof_handler);
      std::cout << "accepted" << std::endl;
    }
  catch (const ExcRun &exc)
    {
      exc.print_info(std::cout);
      std::cout << std::endl;
    }
}

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (unsigned int degree = 1; degree <= 3; ++degree)
    {
      dealii::Triangulation<2> ring;
      make_ring(ring);
      check(ring, degree);
      refine_at_the_right(ring);
      check(ring, degree);
    }

  dealii::Triangulation<2> half;
  dealii::GridGenerator::half_hyper_shell(
    half, dealii::Point<2>(), radius, 2. * radius, 6, true);
  check_refusal(half);

  dealii::Triangulation<2> aside;
  make_ring(aside);
  dealii::GridTools::shift(dealii::Tensor<1, 2>({5. * radius, 0.}), aside);
  check_refusal(aside);

  dealii::Triangulation<2> without_bore;
  make_ring(without_bore);
  for (const auto &face : without_bore.active_face_iterators())
    if (face->at_boundary())
      face->set_boundary_id(7);
  check_refusal(without_bore);
}

// SPDX-License-Identifier: LGPL-2.1-or-later

// Meshes read from files of Gmsh (format 2). Known:
// - A ring written to a file and read is the ring: its bore exactly round, its
//   compliance that of the ring that was not written but for the rim, which in
//   the file has 24 straight edges: the wall is thinner by up to 2.3 %, and by
//   two thirds of that in the mean, so the bushing gives way about 1 % less.
// - A file in millimetres, and one whose bore vertices are rounded to 1e-5 of
//   the radius, make no difference to the roundness of the bore.
// - What is wrong with a file is said; see the messages.

#include <deal.II/base/mpi.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>

#include <tribody/base/exceptions.h>
#include <tribody/elasticity/bushing_elasticity.h>
#include <tribody/elasticity/mesh_file.h>
#include <tribody/elasticity/ring_mesh.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>

using namespace Tribody;
using namespace Tribody::Elasticity;

constexpr double a = 10e-3, b = 16e-3;

/// What is written to the file.
struct Contents
{
  unsigned int n      = 24; ///< cells around
  unsigned int layers = 3;
  double       unit   = 1e-3;
  unsigned int bore = 5, rim = 7;
  /// Radius of a vertex of the bore in units of a, and its angle.
  std::function<double(double)> shape     = [](double) { return 1.; };
  unsigned int                  left_out  = 0; ///< faces missing in the bore
  bool                          triangles = false;
  double                        shifted   = 0.; ///< along x
};

void
write(const Contents &c, const std::string &name)
{
  std::ofstream file(name);
  file << std::setprecision(16) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
       << "$Nodes\n"
       << c.n * (c.layers + 1) << '\n';
  for (unsigned int k = 0; k <= c.layers; ++k)
    for (unsigned int i = 0; i < c.n; ++i)
      {
        const double t = 2. * M_PI * i / c.n;
        const double r = (k == 0) ? a * c.shape(t) : a + k * (b - a) / c.layers;
        file << k * c.n + i + 1 << ' ' << (r * std::cos(t) + c.shifted) / c.unit
             << ' ' << r * std::sin(t) / c.unit << " 0\n";
      }
  const unsigned int per_cell = c.triangles ? 2 : 1;
  file << "$EndNodes\n$Elements\n"
       << 2 * c.n - c.left_out + per_cell * c.n * c.layers << '\n';
  unsigned int element = 0;
  const auto   node    = [&](const unsigned int k, const unsigned int i) {
    return k * c.n + i % c.n + 1;
  };
  for (unsigned int i = c.left_out; i < c.n; ++i)
    file << ++element << " 1 2 " << c.bore << " 1 " << node(0, i) << ' '
         << node(0, i + 1) << '\n';
  for (unsigned int i = 0; i < c.n; ++i)
    file << ++element << " 1 2 " << c.rim << " 2 " << node(c.layers, i) << ' '
         << node(c.layers, i + 1) << '\n';
  for (unsigned int k = 0; k < c.layers; ++k)
    for (unsigned int i = 0; i < c.n; ++i)
      if (c.triangles)
        {
          file << ++element << " 2 2 9 1 " << node(k, i) << ' '
               << node(k + 1, i) << ' ' << node(k + 1, i + 1) << '\n';
          file << ++element << " 2 2 9 1 " << node(k, i) << ' '
               << node(k + 1, i + 1) << ' ' << node(k, i + 1) << '\n';
        }
      else
        file << ++element << " 3 2 9 1 " << node(k, i) << ' ' << node(k + 1, i)
             << ' ' << node(k + 1, i + 1) << ' ' << node(k, i + 1) << '\n';
  file << "$EndElements\n";
}

MeshFile
file_in_millimetres()
{
  MeshFile file;
  file.name        = "ring.msh";
  file.bore_id     = 5;
  file.rim_id      = 7;
  file.length_unit = 1e-3;
  return file;
}

Eigen::MatrixXd
compliance(const dealii::Triangulation<2> &triangulation)
{
  BushingElasticity elasticity(triangulation,
                               2,
                               {"steel", 200e9, 0.3, 7800.},
                               PlaneState::strain);
  elasticity.reinit(dealii::MappingQ<2>(2));
  const auto &positions = elasticity.bore_nodes().positions;
  std::cout << "  bore round "
            << ((positions.colwise().norm().array() - a).abs().maxCoeff() <
                1e-12 * a)
            << std::endl;
  return elasticity.normal_compliance(
    elasticity.bore_nodes().radial_directions());
}

void
compare_with_ring(const unsigned int n_refinements)
{
  dealii::Triangulation<2> read, made;
  MeshFile                 file = file_in_millimetres();
  file.n_refinements            = n_refinements;
  read_ring_mesh(file, a, "Mesh", read);
  const unsigned int factor = 1U << n_refinements;
  make_ring_mesh({24 * factor, 3 * factor, 0.}, a, b, made);
  const Eigen::MatrixXd of_file = compliance(read);
  const Eigen::MatrixXd of_ring = compliance(made);
  std::cout << n_refinements << " refinements: " << read.n_active_cells()
            << " cells, compliance off by "
            << 1e2 * (of_file - of_ring).norm() / of_ring.norm() << " %"
            << std::endl;
}

void
complain(const std::string &what,
         const Contents    &contents,
         const MeshFile    &file)
{
  write(contents, "ring.msh");
  dealii::Triangulation<2> triangulation;
  try
    {
      read_ring_mesh(file, a, "Bushing pin/Mesh", triangulation);
      std::cout << what << ": accepted" << std::endl;
    }
  catch (const ExcParameter &exception)
    {
      std::cout << what << ": ";
      exception.print_info(std::cout);
    }
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::fixed << std::setprecision(2);
  write({}, "ring.msh");
  for (const unsigned int n_refinements : {0, 1, 2})
    compare_with_ring(n_refinements);

  const MeshFile file = file_in_millimetres();
  Contents       contents;
  contents.shape = [](double t) { return 1. + 1e-5 * std::cos(7. * t); };
  complain("rounded vertices", contents, file);

  MeshFile other = file;
  other.name     = "no_such_file.msh";
  complain("no file", {}, other);
  {
    std::ofstream text("text.msh");
    text << "This is no mesh.\n";
  }
  other.name = "text.msh";
  complain("no mesh", {}, other);

  contents           = {};
  contents.triangles = true;
  complain("triangles", contents, file);

  other         = file;
  other.bore_id = 1;
  complain("no such id", {}, other);
  other         = file;
  other.bore_id = 7;
  complain("same ids", {}, other);

  contents          = {};
  contents.left_out = 3;
  complain("open bore", contents, file);

  other             = file;
  other.length_unit = 1.;
  complain("metres", {}, other);
  contents       = {};
  contents.shape = [](double) { return 1.3; };
  complain("too wide", contents, file);
  contents.shape = [](double t) { return t > 1. && t < 1.1 ? 1.002 : 1.; };
  complain("a bump", contents, file);
  contents         = {};
  contents.shifted = 0.5e-3;
  complain("shifted", contents, file);
}

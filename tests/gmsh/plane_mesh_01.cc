// SPDX-License-Identifier: LGPL-2.1-or-later

// Meshes whose cells fit together, and others. Known by drawing them: a sheet
// of 3 by 3 squares of 1 mm has one boundary of 12 edges, without the one in
// the middle a second one of 4; what is wrong with the others stands beside
// them.

#include <tribody/base/exceptions.h>
#include <tribody/gmsh/plane_mesh.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace Tribody;
using namespace Tribody::Gmsh;

PlaneMesh
sheet()
{
  PlaneMesh mesh;
  for (unsigned int j = 0; j < 4; ++j)
    for (unsigned int i = 0; i < 4; ++i)
      mesh.nodes.emplace_back(1e-3 * i, 1e-3 * j);
  for (unsigned int j = 0; j < 3; ++j)
    for (unsigned int i = 0; i < 3; ++i)
      mesh.cells.push_back(
        {{4 * j + i, 4 * j + i + 1, 4 * j + i + 5, 4 * j + i + 4}});
  mesh.lines.push_back({{{1, 0}}, 7});
  return mesh;
}

/// A strip of @p n cells around the origin, of half a radian each.
PlaneMesh
spiral(const unsigned int n)
{
  PlaneMesh mesh;
  for (unsigned int i = 0; i <= n; ++i)
    for (const double r : {1e-3, 2e-3})
      mesh.nodes.emplace_back(r * (1. + 0.01 * i) * std::cos(0.5 * i),
                              r * (1. + 0.01 * i) * std::sin(0.5 * i));
  for (unsigned int i = 0; i < n; ++i)
    mesh.cells.push_back({{2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2}});
  return mesh;
}

void
look_at(const std::string &what, PlaneMesh mesh)
{
  std::cout << what << ": ";
  try
    {
      check_cells(mesh, "a.msh", "File");
      const PlaneBoundary boundary = find_boundary(mesh, "a.msh", "File");
      std::cout << boundary.curves.size() << " curves of "
                << boundary.edges.size() << " edges, "
                << std::count(boundary.ids.begin(), boundary.ids.end(), 7)
                << " with the id 7" << std::endl;
    }
  catch (const ExcParameter &exception)
    {
      exception.print_info(std::cout);
    }
}

int
main()
{
  look_at("sheet", sheet());
  PlaneMesh mesh = sheet();
  std::reverse(mesh.cells[3].begin(), mesh.cells[3].end());
  look_at("one cell clockwise", mesh);
  mesh = sheet();
  mesh.cells.erase(mesh.cells.begin() + 4);
  look_at("a hole", mesh);

  mesh          = sheet();
  mesh.nodes[5] = {2.2e-3, 2.2e-3};
  look_at("a node beyond the next", mesh);
  mesh          = sheet();
  mesh.nodes[0] = {0.5e-3, 0.5e-3};
  look_at("an angle of 180 deg", mesh);
  mesh          = sheet();
  mesh.nodes[1] = mesh.nodes[0];
  look_at("an edge without length", mesh);
  mesh = sheet();
  std::swap(mesh.cells[4][1], mesh.cells[4][2]);
  look_at("two nodes of a cell exchanged", mesh);

  mesh = sheet();
  mesh.cells.push_back(mesh.cells[4]);
  look_at("a cell twice", mesh);
  mesh       = sheet();
  mesh.cells = {mesh.cells[0], mesh.cells[4]};
  look_at("two cells with one corner", mesh);
  mesh       = sheet();
  mesh.cells = {mesh.cells[0], mesh.cells[2]};
  look_at("two cells", mesh);

  mesh = sheet();
  mesh.nodes.push_back(mesh.nodes[5]);
  mesh.cells[0][2] = 16;
  look_at("a node twice", mesh);
  mesh = sheet();
  mesh.nodes.insert(mesh.nodes.end(), {{1.5e-3, 1e-3}, {1.5e-3, 2e-3}});
  mesh.cells.push_back({{16, 6, 10, 17}});
  mesh.cells[4] = {{5, 16, 17, 9}};
  look_at("a cell divided in two, its neighbours not", mesh);
  mesh.cells[1] = {{1, 2, 6, 16}};
  mesh.cells.push_back({{1, 16, 5, 1}});
  look_at("a triangle as a cell", mesh);

  look_at("half a turn", spiral(6));
  look_at("more than a turn", spiral(14));
}

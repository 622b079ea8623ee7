// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>
#include <deal.II/grid/tria.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/elasticity/mesh_file.h>
#include <tribody/gmsh/gmsh_reader.h>
#include <tribody/gmsh/plane_mesh.h>
#include <tribody/surface/boundary_ids.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace Tribody
{
  namespace Elasticity
  {
    using Gmsh::in_millimetres;
    using Gmsh::PlaneBoundary;
    using Gmsh::PlaneMesh;

    namespace
    {
      /// By how much of the radius a vertex of the bore may be off.
      constexpr double roundness = 1e-4;

      using Curve = std::vector<std::size_t>;

      /// @throws ExcParameter if no edge of @p boundary has @p id.
      void
      check_id(const long           id,
               const PlaneBoundary &boundary,
               const std::string   &name,
               const std::string   &where)
      {
        // A message is no place for more.
        constexpr std::size_t largest_list = 10;

        const std::set<long> present(boundary.ids.begin(), boundary.ids.end());
        std::string          list;
        std::size_t          n = 0;
        for (const long other : present)
          if (++n <= largest_list)
            list += (list.empty() ? "" : ", ") + std::to_string(other);
        AssertThrow(present.count(id) == 1,
                    ExcParameter(where,
                                 "no boundary in '" + name + "' has the id " +
                                   std::to_string(id) + "; there are: " + list +
                                   (n > largest_list ? ", ..." : "")));
      }



      // What belongs to bore and rim must be boundary, and not both.
      void
      check_lines(const MeshFile      &file,
                  const PlaneMesh     &mesh,
                  const PlaneBoundary &boundary,
                  const std::string   &path)
      {
        using Ends = std::pair<unsigned int, unsigned int>;
        std::map<Ends, long> id_of_edge;
        for (std::size_t i = 0; i < boundary.edges.size(); ++i)
          id_of_edge.emplace(std::minmax(boundary.edges[i][0],
                                         boundary.edges[i][1]),
                             boundary.ids[i]);
        for (const PlaneMesh::Line &line : mesh.lines)
          {
            if (line.id != file.bore_id && line.id != file.rim_id)
              continue;
            const std::string where =
              path + (line.id == file.bore_id ? "/Bore" : "/Rim") +
              " boundary id";
            const std::string piece =
              "the line of '" + file.name + "' from " +
              in_millimetres(mesh.nodes[line.nodes[0]]) + " to " +
              in_millimetres(mesh.nodes[line.nodes[1]]) + " has the id " +
              std::to_string(line.id) + " and ";
            const auto edge =
              id_of_edge.find(std::minmax(line.nodes[0], line.nodes[1]));
            AssertThrow(edge != id_of_edge.end(),
                        ExcParameter(where,
                                     piece +
                                       "is not an edge of the mesh at its "
                                       "boundary"));
            AssertThrow(edge->second == line.id,
                        ExcParameter(where,
                                     piece + std::to_string(edge->second)));
          }
      }



      /// The edges of the bore, which are a hole.
      Curve
      find_bore(const MeshFile      &file,
                const PlaneMesh     &mesh,
                const PlaneBoundary &boundary,
                const std::string   &path)
      {
        const std::string where = path + "/Bore boundary id";
        const std::string curve =
          "the curve " + std::to_string(file.bore_id) + " of '" + file.name;
        Curve bore;
        for (std::size_t c = 0; c < boundary.curves.size(); ++c)
          {
            const std::size_t begin = boundary.curves[c];
            const std::size_t end   = c + 1 < boundary.curves.size()
                                        ? boundary.curves[c + 1]
                                        : boundary.edges.size();
            const auto        n     = std::count(boundary.ids.begin() + begin,
                                      boundary.ids.begin() + end,
                                      static_cast<long>(file.bore_id));
            if (n == 0)
              continue;
            AssertThrow(bore.empty(),
                        ExcParameter(where,
                                     curve + "' is not one closed curve but "
                                             "several"));
            double twice_area = 0.;
            for (std::size_t i = begin; i < end; ++i)
              {
                const auto       &a    = mesh.nodes[boundary.edges[i][0]];
                const auto       &b    = mesh.nodes[boundary.edges[i][1]];
                const std::size_t next = i + 1 < end ? i + 1 : begin;
                AssertThrow(boundary.ids[i] != file.bore_id ||
                              boundary.ids[next] == file.bore_id,
                            ExcParameter(where,
                                         curve +
                                           "' is not closed: it ends at " +
                                           in_millimetres(b)));
                twice_area += a[0] * b[1] - a[1] * b[0];
                bore.push_back(i);
              }
            AssertThrow(twice_area < 0.,
                        ExcParameter(where,
                                     curve + "' is the outer one of the mesh, "
                                             "not that of a hole"));
          }
        return bore;
      }



      // The unit that would make it right, if it is a power of ten.
      std::string
      advise_unit(const double unit)
      {
        const double power = std::round(std::log10(unit));
        if (std::abs(unit / std::pow(10., power) - 1.) > 0.02)
          return "";
        return "; with 'File length unit' = " +
               Units::to_string(std::pow(10., power),
                                "m",
                                power < 0. ? "mm" : "m") +
               " they would agree";
      }



      // Round, of the right size, and around the origin; then exactly so.
      void
      make_bore_round(const MeshFile      &file,
                      const double         radius,
                      const PlaneBoundary &boundary,
                      const Curve         &bore,
                      const std::string   &path,
                      PlaneMesh           &mesh)
      {
        std::vector<unsigned int> nodes;
        for (const std::size_t i : bore)
          nodes.push_back(boundary.edges[i][0]);

        dealii::Point<2> mean;
        for (const unsigned int v : nodes)
          mean += mesh.nodes[v] / static_cast<double>(nodes.size());
        double mean_radius = 0.;
        for (const unsigned int v : nodes)
          mean_radius += mesh.nodes[v].distance(mean) / nodes.size();
        AssertThrow(std::abs(mean_radius / radius - 1.) < 0.1,
                    ExcParameter(
                      path + "/File length unit",
                      "the bore of '" + file.name + "' has a radius of about " +
                        in_millimetres(mean_radius) +
                        ", the joint's bushing radius is " +
                        in_millimetres(radius) +
                        advise_unit(file.length_unit * radius / mean_radius)));

        const auto off = [&](const unsigned int v) {
          return mesh.nodes[v].norm() - radius;
        };
        const unsigned int worst =
          *std::max_element(nodes.begin(),
                            nodes.end(),
                            [&](const auto a, const auto b) {
                              return std::abs(off(a)) < std::abs(off(b));
                            });
        // What rounding leaves of a centre is none.
        for (unsigned int d = 0; d < 2; ++d)
          if (std::abs(mean[d]) < 1e-9 * radius)
            mean[d] = 0.;
        AssertThrow(
          std::abs(off(worst)) <= roundness * radius,
          ExcParameter(path + "/File",
                       "the bore of '" + file.name +
                         "' is not the circle of the joint's bushing radius, " +
                         in_millimetres(radius) +
                         ", around the origin: its vertex at " +
                         in_millimetres(mesh.nodes[worst]) + " lies " +
                         in_millimetres(std::abs(off(worst))) +
                         (off(worst) > 0. ? " outside" : " inside") +
                         " of it; the centre of its vertices is " +
                         in_millimetres(mean) +
                         ", their mean distance from there " +
                         in_millimetres(mean_radius)));
        for (const unsigned int v : nodes)
          mesh.nodes[v] *= radius / mesh.nodes[v].norm();
      }



      /// @throws ExcParameter if a cell is not convex or is cut by the bore's
      /// arc.
      void
      check_beside_arcs(const MeshFile                 &file,
                        const double                    radius,
                        const std::string              &path,
                        const dealii::Triangulation<2> &triangulation)
      {
        const auto side = [](const dealii::Point<2> &a,
                             const dealii::Point<2> &b,
                             const dealii::Point<2> &c) {
          return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        };
        for (const auto &cell : triangulation.active_cell_iterators())
          for (const unsigned int f : cell->face_indices())
            {
              const auto face = cell->face(f);
              // Seen from the face, the two other vertices of the cell.
              const unsigned int other = f ^ 1U;
              dealii::Point<2>   a = face->vertex(0), b = face->vertex(1);
              dealii::Point<2>   middle = 0.5 * (a + b);
              if (face->at_boundary() &&
                  face->boundary_id() == BoundaryIds::bore)
                middle *= radius / middle.norm();
              const double orientation =
                side(a, b, cell->center()) > 0. ? 1. : -1.;
              for (const unsigned int v : {0, 1})
                {
                  const auto &far = cell->face(other)->vertex(v);
                  AssertThrow(
                    orientation * side(a, middle, far) > 0. &&
                      orientation * side(middle, b, far) > 0.,
                    ExcParameter(path + "/File",
                                 "the cell of '" + file.name + "' around " +
                                   in_millimetres(cell->center()) +
                                   " is too thin for the arc of the bore or "
                                   "turned inside out where it is divided; "
                                   "more or thicker cells are needed there"));
                }
            }
      }



      void
      make_triangulation(const MeshFile           &file,
                         const PlaneMesh          &mesh,
                         const PlaneBoundary      &boundary,
                         dealii::Triangulation<2> &triangulation)
      {
        std::vector<dealii::CellData<2>> cells;
        for (const auto &[a, b, c, d] : mesh.cells)
          {
            dealii::CellData<2> cell;
            cell.vertices = {a, b, d, c};
            cells.push_back(cell);
          }
        dealii::GridTools::consistently_order_cells(cells);
        dealii::SubCellData faces;
        for (std::size_t i = 0; i < boundary.edges.size(); ++i)
          {
            const long          id = boundary.ids[i];
            dealii::CellData<1> face;
            face.vertices    = {boundary.edges[i][0], boundary.edges[i][1]};
            face.boundary_id = id == file.bore_id  ? BoundaryIds::bore
                               : id == file.rim_id ? BoundaryIds::rim
                                                   : BoundaryIds::free;
            faces.boundary_lines.push_back(face);
          }
        triangulation.create_triangulation(mesh.nodes, cells, faces);
        triangulation.set_all_manifold_ids_on_boundary(BoundaryIds::bore,
                                                       BoundaryIds::bore);
        triangulation.set_manifold(BoundaryIds::bore,
                                   dealii::SphericalManifold<2>());
      }
    } // namespace



    void
    MeshFile::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_text(
        prm,
        "File",
        name,
        "A mesh of quadrilaterals written by Gmsh (.msh, text, format 2 or "
        "4.1), with "
        "the centre of the bore at the origin, relative to the directory of "
        "the parameter file. Bore cells, radial cells, grading and outer "
        "shape are then not used. Empty: a ring is meshed.");
      Parameters::add_integer(prm,
                              "Bore boundary id",
                              bore_id,
                              "Number of the physical group of the bore in the "
                              "file.",
                              0,
                              1000000000);
      Parameters::add_integer(prm,
                              "Rim boundary id",
                              rim_id,
                              "Number of the physical group of the rim in the "
                              "file, by which the bushing is held.",
                              0,
                              1000000000);
      Parameters::add_quantity(prm,
                               "File length unit",
                               length_unit,
                               "m",
                               "What the number 1 in the file stands for; "
                               "'1 mm' for a file in millimetres.");
      Parameters::add_integer(prm,
                              "File refinements",
                              n_refinements,
                              "How often every cell of the file is divided "
                              "into four. With one or more of them the error "
                              "of the mesh can be estimated.",
                              0,
                              8);
    }



    void
    read_ring_mesh(const MeshFile              &file,
                   const double                 inner_radius,
                   const std::string           &path,
                   dealii::Triangulation<2, 2> &triangulation)
    {
      AssertThrow(file.length_unit > 0.,
                  ExcParameter(path + "/File length unit", "must be positive"));
      AssertThrow(file.bore_id != file.rim_id,
                  ExcParameter(path + "/Rim boundary id",
                               std::to_string(file.rim_id) +
                                 " is that of the bore too"));
      const std::string where = path + "/File";
      PlaneMesh mesh = Gmsh::read_gmsh(file.name, file.length_unit, where);
      // An edge of several groups is that of bore or rim.
      std::stable_partition(mesh.lines.begin(),
                            mesh.lines.end(),
                            [&file](const PlaneMesh::Line &line) {
                              return line.id == file.bore_id ||
                                     line.id == file.rim_id;
                            });
      Gmsh::check_cells(mesh, file.name, where);
      const PlaneBoundary boundary =
        Gmsh::find_boundary(mesh, file.name, where);
      check_id(file.bore_id, boundary, file.name, path + "/Bore boundary id");
      check_id(file.rim_id, boundary, file.name, path + "/Rim boundary id");
      check_lines(file, mesh, boundary, path);
      make_bore_round(file,
                      inner_radius,
                      boundary,
                      find_bore(file, mesh, boundary, path),
                      path,
                      mesh);
      Gmsh::check_cells(mesh, file.name, where);
      make_triangulation(file, mesh, boundary, triangulation);
      check_beside_arcs(file, inner_radius, path, triangulation);
      triangulation.refine_global(file.n_refinements);
      check_beside_arcs(file, inner_radius, path, triangulation);
    }
  } // namespace Elasticity
} // namespace Tribody

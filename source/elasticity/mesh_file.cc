// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>
#include <deal.II/grid/tria.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/elasticity/mesh_file.h>
#include <tribody/surface/boundary_ids.h>

#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <vector>

namespace Tribody
{
  namespace Elasticity
  {
    namespace
    {
      using dealii::types::boundary_id;

      /// By how much of the radius a vertex of the bore may be off.
      constexpr double roundness = 1e-4;

      /// With six digits: what the file's own digits leave is not of interest.
      std::string
      millimetres(const double x)
      {
        std::ostringstream out;
        out << 1e3 * x << " mm";
        return out.str();
      }



      std::string
      millimetres(const dealii::Point<2> &x)
      {
        std::ostringstream out;
        out << '(' << 1e3 * x[0] << ", " << 1e3 * x[1] << ") mm";
        return out.str();
      }



      void
      read_file(const MeshFile           &file,
                const std::string        &path,
                dealii::Triangulation<2> &triangulation)
      {
        const std::string where = path + "/File";
        std::ifstream     stream(file.name);
        AssertThrow(
          stream,
          ExcParameter(where, "the file '" + file.name + "' cannot be opened"));
        try
          {
            dealii::GridIn<2> grid_in(triangulation);
            grid_in.read_msh(stream);
          }
        catch (const dealii::ExceptionBase &exception)
          {
            throw ExcParameter(where,
                               "'" + file.name +
                                 "' is not a mesh of Gmsh's that deal.II can "
                                 "read (format 2 or 4, linear cells): " +
                                 message_of(exception));
          }
        AssertThrow(triangulation.all_reference_cells_are_hyper_cube(),
                    ExcParameter(where,
                                 "'" + file.name +
                                   "' has cells that are not quadrilaterals; "
                                   "let Gmsh recombine its triangles "
                                   "('Recombine Surface')"));
      }



      // Whatever the ids in the file, BoundaryIds in the mesh.
      void
      set_boundary_ids(const MeshFile           &file,
                       const std::string        &path,
                       dealii::Triangulation<2> &triangulation)
      {
        std::set<boundary_id> present;
        for (const auto &face : triangulation.active_face_iterators())
          if (face->at_boundary())
            present.insert(face->boundary_id());
        std::string list;
        for (const boundary_id id : present)
          list += (list.empty() ? "" : ", ") + std::to_string(id);

        for (const auto &[id, name] :
             {std::make_pair(file.bore_id, "Bore boundary id"),
              std::make_pair(file.rim_id, "Rim boundary id")})
          AssertThrow(present.count(id) == 1,
                      ExcParameter(path + "/" + name,
                                   "no boundary in '" + file.name +
                                     "' has the id " + std::to_string(id) +
                                     "; there are: " + list));
        AssertThrow(file.bore_id != file.rim_id,
                    ExcParameter(path + "/Rim boundary id",
                                 std::to_string(file.rim_id) +
                                   " is that of the bore too"));

        for (const auto &face : triangulation.active_face_iterators())
          if (face->at_boundary())
            {
              const boundary_id id = face->boundary_id();
              face->set_boundary_id(id == file.bore_id  ? BoundaryIds::bore
                                    : id == file.rim_id ? BoundaryIds::rim
                                                        : BoundaryIds::free);
            }
      }



      /// The vertices of the bore one after the other.
      std::vector<unsigned int>
      walk_along_bore(const MeshFile                 &file,
                      const std::string              &path,
                      const dealii::Triangulation<2> &triangulation)
      {
        const std::string where = path + "/Bore boundary id";
        std::map<unsigned int, std::vector<unsigned int>> neighbours;
        for (const auto &face : triangulation.active_face_iterators())
          if (face->at_boundary() && face->boundary_id() == BoundaryIds::bore)
            for (const unsigned int v : {0, 1})
              neighbours[face->vertex_index(v)].push_back(
                face->vertex_index(1 - v));
        const auto &vertices = triangulation.get_vertices();
        for (const auto &[vertex, others] : neighbours)
          AssertThrow(others.size() == 2,
                      ExcParameter(where,
                                   "the curve " + std::to_string(file.bore_id) +
                                     " of '" + file.name + "' is not closed: " +
                                     std::to_string(others.size()) +
                                     " of its faces meet at " +
                                     millimetres(vertices[vertex])));

        std::vector<unsigned int> walk{neighbours.begin()->first};
        unsigned int              before = neighbours.begin()->second[0];
        do
          {
            const auto        &others = neighbours[walk.back()];
            const unsigned int next =
              others[0] == before ? others[1] : others[0];
            before = walk.back();
            walk.push_back(next);
        } while (walk.back() != walk.front());
        walk.pop_back();
        AssertThrow(walk.size() == neighbours.size(),
                    ExcParameter(where,
                                 "the curve " + std::to_string(file.bore_id) +
                                   " of '" + file.name +
                                   "' is not one closed curve but several"));
        return walk;
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
      make_bore_round(const MeshFile           &file,
                      const double              radius,
                      const std::string        &path,
                      dealii::Triangulation<2> &triangulation)
      {
        const std::vector<unsigned int> bore =
          walk_along_bore(file, path, triangulation);
        std::vector<dealii::Point<2>> vertices = triangulation.get_vertices();

        dealii::Point<2> mean;
        for (const unsigned int v : bore)
          mean += vertices[v] / static_cast<double>(bore.size());
        double mean_radius = 0.;
        for (const unsigned int v : bore)
          mean_radius += vertices[v].distance(mean) / bore.size();
        AssertThrow(
          std::abs(mean_radius / radius - 1.) < 0.1,
          ExcParameter(path + "/File length unit",
                       "the bore of '" + file.name +
                         "' has a radius of about " + millimetres(mean_radius) +
                         ", the joint's bushing radius is " +
                         millimetres(radius) +
                         advise_unit(file.length_unit * radius / mean_radius)));

        std::size_t worst = 0;
        const auto  off   = [&](const std::size_t i) {
          return vertices[bore[i]].norm() - radius;
        };
        for (std::size_t i = 0; i < bore.size(); ++i)
          if (std::abs(off(i)) > std::abs(off(worst)))
            worst = i;
        // What rounding leaves of a centre is none.
        for (unsigned int d = 0; d < 2; ++d)
          if (std::abs(mean[d]) < 1e-9 * radius)
            mean[d] = 0.;
        AssertThrow(
          std::abs(off(worst)) <= roundness * radius,
          ExcParameter(
            path + "/File",
            "the bore of '" + file.name +
              "' is not the circle of the joint's bushing radius, " +
              millimetres(radius) + ", around the origin: its vertex at " +
              millimetres(vertices[bore[worst]]) + " lies " +
              millimetres(std::abs(off(worst))) +
              (off(worst) > 0. ? " outside" : " inside") +
              " of it; the centre of its vertices is " + millimetres(mean) +
              ", their mean distance from there " + millimetres(mean_radius)));

        std::map<unsigned int, dealii::Point<2>> on_circle;
        for (const unsigned int v : bore)
          on_circle[v] =
            dealii::Point<2>(radius / vertices[v].norm() * vertices[v]);
        for (const auto &cell : triangulation.active_cell_iterators())
          for (const unsigned int v : cell->vertex_indices())
            {
              const auto moved = on_circle.find(cell->vertex_index(v));
              if (moved != on_circle.end())
                cell->vertex(v) = moved->second;
            }
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
        "A mesh of quadrilaterals written by Gmsh (.msh, format 2 or 4), with "
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
      read_file(file, path, triangulation);
      if (file.length_unit != 1.)
        dealii::GridTools::scale(file.length_unit, triangulation);
      set_boundary_ids(file, path, triangulation);
      make_bore_round(file, inner_radius, path, triangulation);
      triangulation.refine_global(file.n_refinements);
    }
  } // namespace Elasticity
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/filtered_iterator.h>

#include <boost/serialization/map.hpp>
#include <boost/serialization/set.hpp>
#include <boost/serialization/utility.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/surface/bore_nodes.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

namespace Tribody
{
  using dealii::types::global_dof_index;

  namespace
  {
    struct Node
    {
      dealii::Point<2> position;
      double           angle;
      global_dof_index x_dof;
      global_dof_index y_dof = dealii::numbers::invalid_dof_index;
      bool             is_vertex;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &position &angle &x_dof &y_dof &is_vertex;
      }
    };

    /// The angle of @p point about the origin in [0, 2 pi); what rounding
    /// has put below zero is zero.
    double
    angle_of(const dealii::Point<2> &point)
    {
      const double angle = std::atan2(point[1], point[0]);
      if (angle >= 0.)
        return angle;
      return angle > -1e-12 ? 0. : angle + 2. * dealii::numbers::PI;
    }

    /**
     * The nodes of all faces on the bore by their x dof, and the pairs of x
     * dofs that end each face.
     */
    struct BoreFaces
    {
      std::map<global_dof_index, Node>                        nodes;
      std::set<std::pair<global_dof_index, global_dof_index>> ends;
    };

    BoreFaces
    collect_bore_faces(const dealii::DoFHandler<2>     &dof_handler,
                       const dealii::types::boundary_id boundary_id)
    {
      const auto        &fe = dof_handler.get_fe();
      const unsigned int n  = fe.n_dofs_per_face();

      const dealii::MappingQ<2>   mapping(fe.degree);
      const dealii::Quadrature<1> nodes_of_face(
        fe.get_unit_face_support_points());
      dealii::FEFaceValues<2>       fe_face_values(mapping,
                                             fe,
                                             nodes_of_face,
                                             dealii::update_quadrature_points);
      std::vector<global_dof_index> dofs(n);

      BoreFaces faces;
      for (const auto &cell : dof_handler.active_cell_iterators() |
                                dealii::IteratorFilters::LocallyOwnedCell())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == boundary_id)
            {
              fe_face_values.reinit(cell, face);
              face->get_dof_indices(dofs);
              // Per vertex first x, then y; then the x's of the interior
              // nodes, then their y's: the element's own table knows.
              std::map<unsigned int, Node> of_this_face;
              for (unsigned int k = 0; k < n; ++k)
                {
                  const auto [component, node] =
                    fe.face_system_to_component_index(k);
                  auto &entry = of_this_face[node];
                  if (component == 0)
                    {
                      entry.position  = fe_face_values.quadrature_point(k);
                      entry.angle     = angle_of(entry.position);
                      entry.x_dof     = dofs[k];
                      entry.is_vertex = (node < 2);
                    }
                  else
                    entry.y_dof = dofs[k];
                }
              for (const auto &[node, entry] : of_this_face)
                faces.nodes[entry.x_dof] = entry;
              faces.ends.insert(std::minmax(of_this_face.at(0).x_dof,
                                            of_this_face.at(1).x_dof));
            }
      return faces;
    }

    /// What each rank has found in its cells, put together on all of them.
    BoreFaces
    gather(const BoreFaces &own, const MPI_Comm &communicator)
    {
      if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1)
        return own;
      BoreFaces all;
      for (const auto &nodes :
           dealii::Utilities::MPI::all_gather(communicator, own.nodes))
        all.nodes.insert(nodes.begin(), nodes.end());
      for (const auto &ends :
           dealii::Utilities::MPI::all_gather(communicator, own.ends))
        all.ends.insert(ends.begin(), ends.end());
      return all;
    }

    /// Counter-clockwise, beginning with the vertex of smallest angle.
    std::vector<Node>
    sort_nodes(const BoreFaces &faces)
    {
      std::vector<Node> nodes;
      for (const auto &[dof, node] : faces.nodes)
        nodes.push_back(node);
      std::sort(nodes.begin(), nodes.end(), [](const auto &a, const auto &b) {
        return a.angle < b.angle;
      });
      const auto first =
        std::find_if(nodes.begin(), nodes.end(), [](const auto &node) {
          return node.is_vertex;
        });
      for (auto node = nodes.begin(); node != first; ++node)
        node->angle += 2. * dealii::numbers::PI;
      std::rotate(nodes.begin(), first, nodes.end());
      return nodes;
    }

    void
    check_closed(const std::vector<Node>         &nodes,
                 const BoreFaces                 &faces,
                 const unsigned int               degree,
                 const dealii::types::boundary_id boundary_id)
    {
      bool closed =
        faces.ends.size() >= 3 && nodes.size() == degree * faces.ends.size();
      for (std::size_t i = 0; closed && i < nodes.size(); i += degree)
        {
          const std::size_t next = (i + degree) % nodes.size();
          const double      turn = nodes[next].angle - nodes[i].angle +
                              (next == 0 ? 2. * dealii::numbers::PI : 0.);
          closed = nodes[i].is_vertex && turn < dealii::numbers::PI &&
                   faces.ends.count(
                     std::minmax(nodes[i].x_dof, nodes[next].x_dof)) == 1;
        }
      AssertThrow(closed,
                  ExcRun("The boundary of the mesh with the " +
                         std::string(boundary_id == BoundaryIds::bore ? "bore"
                                     : boundary_id == BoundaryIds::rim
                                       ? "rim"
                                       : "pin") +
                         "'s indicator " + std::to_string(boundary_id) +
                         " is not one closed curve around the origin (" +
                         std::to_string(faces.ends.size()) + " faces, " +
                         std::to_string(nodes.size()) + " nodes)."));
    }
  } // namespace



  Eigen::Matrix2Xd
  BoreNodes::radial_directions() const
  {
    return positions.colwise().normalized();
  }



  BoreNodes
  make_bore_nodes(const dealii::DoFHandler<2, 2>  &dof_handler,
                  const dealii::types::boundary_id boundary_id)
  {
    const unsigned int degree = dof_handler.get_fe().degree;
    const BoreFaces faces = gather(collect_bore_faces(dof_handler, boundary_id),
                                   dof_handler.get_communicator());
    const auto      nodes = sort_nodes(faces);
    check_closed(nodes, faces, degree, boundary_id);

    BoreNodes bore_nodes;
    bore_nodes.degree = degree;
    bore_nodes.positions.resize(2, nodes.size());
    bore_nodes.angles.resize(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        bore_nodes.positions.col(i) << nodes[i].position[0],
          nodes[i].position[1];
        bore_nodes.angles[i] = nodes[i].angle;
        bore_nodes.x_dofs.push_back(nodes[i].x_dof);
        bore_nodes.y_dofs.push_back(nodes[i].y_dof);
      }
    return bore_nodes;
  }
} // namespace Tribody

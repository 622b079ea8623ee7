// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/segment.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/gmsh/plane_mesh.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <sstream>

namespace Tribody
{
  namespace Gmsh
  {
    namespace bg = boost::geometry;

    namespace
    {
      using Edge  = std::array<unsigned int, 2>;
      using Point = dealii::Point<2>;

      using Place   = bg::model::d2::point_xy<double>;
      using Segment = bg::model::segment<Place>;
      using Box     = bg::model::box<Place>;
      using Entry   = std::pair<Box, std::size_t>;

      /// Sine of the smallest angle of a cell, and of what is missing of the
      /// largest one to 180 degrees.
      constexpr double smallest_sine = 1e-3;

      /// Part of an edge's length below which a node lies on it.
      constexpr double touching = 1e-6;

      double
      cross(const dealii::Tensor<1, 2> &a, const dealii::Tensor<1, 2> &b)
      {
        return a[0] * b[1] - a[1] * b[0];
      }



      Point
      centre(const PlaneMesh &mesh, const std::array<unsigned int, 4> &cell)
      {
        Point sum;
        for (const unsigned int v : cell)
          sum += 0.25 * mesh.nodes[v];
        return sum;
      }



      /// Of the four angles, the smallest and the largest sine;
      /// counter-clockwise counts as positive.
      std::pair<double, double>
      sines_of_angles(const PlaneMesh                   &mesh,
                      const std::array<unsigned int, 4> &cell)
      {
        std::array<double, 4> sines;
        for (unsigned int k = 0; k < 4; ++k)
          {
            const Point &here   = mesh.nodes[cell[k]];
            const auto   before = here - mesh.nodes[cell[(k + 3) % 4]];
            const auto   after  = mesh.nodes[cell[(k + 1) % 4]] - here;
            const double size   = before.norm() * after.norm();
            sines[k]            = size > 0. ? cross(before, after) / size : 0.;
          }
        const auto [least, largest] =
          std::minmax_element(sines.begin(), sines.end());
        return {*least, *largest};
      }



      /// Edges with a cell on one side only; the cell is on their left.
      std::vector<Edge>
      find_free_edges(const PlaneMesh   &mesh,
                      const std::string &name,
                      const std::string &where)
      {
        // All edges as the cells to their left have them, so that the two of a
        // pair stand next to each other.
        std::vector<Edge> edges;
        for (const auto &cell : mesh.cells)
          for (unsigned int k = 0; k < 4; ++k)
            edges.push_back({{cell[k], cell[(k + 1) % 4]}});
        const auto ends = [](const Edge &edge) {
          return std::minmax(edge[0], edge[1]);
        };
        std::sort(edges.begin(),
                  edges.end(),
                  [&](const Edge &a, const Edge &b) {
                    return std::make_pair(ends(a), a) <
                           std::make_pair(ends(b), b);
                  });

        std::vector<Edge> free;
        for (std::size_t i = 0; i < edges.size(); ++i)
          {
            const bool has_next =
              i + 1 < edges.size() && ends(edges[i]) == ends(edges[i + 1]);
            AssertThrow(
              !has_next || edges[i] != edges[i + 1],
              ExcParameter(where,
                           "cells of '" + name +
                             "' overlap: two of them have the edge from " +
                             in_millimetres(mesh.nodes[edges[i][0]]) + " to " +
                             in_millimetres(mesh.nodes[edges[i][1]]) +
                             " on the same side"));
            if (has_next)
              ++i;
            else
              free.push_back(edges[i]);
          }
        return free;
      }



      /// Sort free edges into closed curves.
      PlaneBoundary
      sort_into_curves(const std::vector<Edge> &free,
                       const PlaneMesh         &mesh,
                       const std::string       &name,
                       const std::string       &where)
      {
        std::map<unsigned int, unsigned int> next;
        for (const Edge &edge : free)
          AssertThrow(next.emplace(edge[0], edge[1]).second,
                      ExcParameter(where,
                                   "cells of '" + name +
                                     "' touch with a corner only, at " +
                                     in_millimetres(mesh.nodes[edge[0]])));
        PlaneBoundary boundary;
        while (!next.empty())
          {
            boundary.curves.push_back(boundary.edges.size());
            // As many edges of cells begin in a node as end there.
            for (auto at = next.begin(); at != next.end();)
              {
                boundary.edges.push_back({{at->first, at->second}});
                next.erase(at);
                at = next.find(boundary.edges.back()[1]);
              }
          }
        return boundary;
      }



      Segment
      segment(const PlaneMesh &mesh, const Edge &edge)
      {
        const Point &a = mesh.nodes[edge[0]], &b = mesh.nodes[edge[1]];
        return {Place(a[0], a[1]), Place(b[0], b[1])};
      }



      /// @throws ExcParameter if @p edge of the boundary has a node of @p other
      ///   on it, or crosses it.
      void
      check_apart(const PlaneMesh   &mesh,
                  const Edge        &edge,
                  const Edge        &other,
                  const std::string &name,
                  const std::string &where)
      {
        const Segment line   = segment(mesh, edge);
        const double  length = bg::length(line);
        bool          shares = false;
        for (const unsigned int node : other)
          {
            shares         = shares || node == edge[0] || node == edge[1];
            const Point &x = mesh.nodes[node];
            if (node == edge[0] || node == edge[1] ||
                bg::distance(line, Place(x[0], x[1])) > touching * length)
              continue;
            const bool is_double =
              std::min(x.distance(mesh.nodes[edge[0]]),
                       x.distance(mesh.nodes[edge[1]])) <= touching * length;
            throw ExcParameter(
              where,
              "'" + name + "' has " +
                (is_double ? "two nodes at " + in_millimetres(x) +
                               "; they must be one for the cells to hold "
                               "together (in Gmsh: 'Coherence Mesh')"
                           : "a hanging node at " + in_millimetres(x) +
                               ": it lies on the edge of a cell that does not "
                               "have it"));
          }
        AssertThrow(shares || !bg::intersects(line, segment(mesh, other)),
                    ExcParameter(where,
                                 "cells of '" + name +
                                   "' overlap: boundaries cross near " +
                                   in_millimetres(mesh.nodes[edge[0]])));
      }



      void
      check_simple(const PlaneMesh         &mesh,
                   const std::vector<Edge> &edges,
                   const std::string       &name,
                   const std::string       &where)
      {
        std::vector<Entry> entries;
        for (std::size_t i = 0; i < edges.size(); ++i)
          {
            const Segment line = segment(mesh, edges[i]);
            Box           box;
            bg::envelope(line, box);
            bg::buffer(box, box, touching * bg::length(line));
            entries.emplace_back(box, i);
          }
        const bg::index::rtree<Entry, bg::index::quadratic<16>> tree(entries);
        std::vector<Entry>                                      near;
        for (const Entry &entry : entries)
          {
            near.clear();
            tree.query(bg::index::intersects(entry.first),
                       std::back_inserter(near));
            for (const Entry &other : near)
              if (other.second != entry.second)
                check_apart(
                  mesh, edges[entry.second], edges[other.second], name, where);
          }
      }



      /// As many curves have the material inside.
      std::size_t
      count_parts(const PlaneMesh &mesh, const PlaneBoundary &boundary)
      {
        std::size_t n = 0;
        for (std::size_t c = 0; c < boundary.curves.size(); ++c)
          {
            const std::size_t end        = c + 1 < boundary.curves.size()
                                             ? boundary.curves[c + 1]
                                             : boundary.edges.size();
            double            twice_area = 0.;
            for (std::size_t i = boundary.curves[c]; i < end; ++i)
              twice_area += cross(mesh.nodes[boundary.edges[i][0]],
                                  mesh.nodes[boundary.edges[i][1]]);
            n += twice_area > 0. ? 1 : 0;
          }
        return n;
      }
    } // namespace



    void
    check_cells(PlaneMesh         &mesh,
                const std::string &name,
                const std::string &where)
    {
      for (auto &cell : mesh.cells)
        {
          auto [least, largest] = sines_of_angles(mesh, cell);
          if (largest < 0.)
            {
              std::reverse(cell.begin(), cell.end());
              least = -largest;
            }
          if (least >= smallest_sine)
            continue;
          throw ExcParameter(where,
                             "the cell of '" + name + "' around " +
                               in_millimetres(centre(mesh, cell)) +
                               (least <= -smallest_sine
                                  ? " is turned inside out or not convex"
                                  : " is degenerate: an edge without length, "
                                    "or an angle of 0 or "
                                    "180 deg"));
        }
    }



    PlaneBoundary
    find_boundary(const PlaneMesh   &mesh,
                  const std::string &name,
                  const std::string &where)
    {
      const std::vector<Edge> free = find_free_edges(mesh, name, where);
      check_simple(mesh, free, name, where);
      PlaneBoundary     boundary = sort_into_curves(free, mesh, name, where);
      const std::size_t n_parts  = count_parts(mesh, boundary);
      AssertThrow(n_parts == 1,
                  ExcParameter(where,
                               "'" + name + "' consists of " +
                                 std::to_string(n_parts) +
                                 " parts that are not connected"));

      std::map<std::pair<unsigned int, unsigned int>, long> ids;
      for (const PlaneMesh::Line &line : mesh.lines)
        ids.emplace(std::minmax(line.nodes[0], line.nodes[1]), line.id);
      for (const Edge &edge : boundary.edges)
        {
          const auto id = ids.find(std::minmax(edge[0], edge[1]));
          boundary.ids.push_back(id != ids.end() ? id->second : 0);
        }
      return boundary;
    }



    std::string
    in_millimetres(const double x)
    {
      std::ostringstream out;
      out << 1e3 * x << " mm";
      return out.str();
    }



    std::string
    in_millimetres(const dealii::Point<2> &x)
    {
      std::ostringstream out;
      out << '(' << 1e3 * x[0] << ", " << 1e3 * x[1] << ") mm";
      return out.str();
    }
  } // namespace Gmsh
} // namespace Tribody

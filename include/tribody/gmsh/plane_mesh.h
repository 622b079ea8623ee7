// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_gmsh_plane_mesh_h
#define tribody_gmsh_plane_mesh_h

#include <deal.II/base/point.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace Tribody
{
  namespace Gmsh
  {
    /// A mesh of quadrilaterals as it stands in a file: nothing is known to
    /// fit.
    struct PlaneMesh
    {
      /// A line of a physical group.
      struct Line
      {
        /// Its ends.
        std::array<unsigned int, 2> nodes;
        /// Number of the group; 0 without one.
        long id;
      };

      /// Places [m].
      std::vector<dealii::Point<2>> nodes;
      /// Nodes of each cell, one after the other around it.
      std::vector<std::array<unsigned int, 4>> cells;
      /// Pieces of boundaries, and others.
      std::vector<Line> lines;
    };

    /**
     * The boundary of a mesh whose cells fit together: one curve around it and
     * holes, none of which touches another or itself.
     */
    struct PlaneBoundary
    {
      /// Its edges, one closed curve after the other, each with the material
      /// on its left.
      std::vector<std::array<unsigned int, 2>> edges;
      /// Number of the group of each edge; 0 without one.
      std::vector<long> ids;
      /// The first of the edges that belong to each curve.
      std::vector<std::size_t> curves;
    };

    /**
     * See that every cell of @p mesh is convex and has none of its angles at 0
     * or 180 degrees, and make all of them counter-clockwise.
     * @param name of the file, @p where the parameter that has it: for
     *   messages.
     * @throws ExcParameter with the place of the first cell that is not.
     */
    void
    check_cells(PlaneMesh         &mesh,
                const std::string &name,
                const std::string &where);

    /**
     * Find the boundary of @p mesh, whose cells are those of check_cells().
     * That cells are convex and counter-clockwise, that no edge has more than
     * one of them on either side, and that the boundary is one simple curve
     * with simple holes is enough for no place to be covered twice.
     * @throws ExcParameter with the place where cells overlap, meet in a corner
     *   only, or leave a hanging or a double node between them; if there are
     *   several parts.
     */
    PlaneBoundary
    find_boundary(const PlaneMesh   &mesh,
                  const std::string &name,
                  const std::string &where);

    /// "(1.5, 0) mm". With six digits: what a file's own digits leave is not of
    /// interest.
    std::string
    in_millimetres(const dealii::Point<2> &x);

    /// "1.5 mm".
    std::string
    in_millimetres(const double x);
  } // namespace Gmsh
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_gmsh_gmsh_reader_h
#define tribody_gmsh_gmsh_reader_h

#include <tribody/gmsh/plane_mesh.h>

#include <string>

namespace Tribody
{
  namespace Gmsh
  {
    /**
     * Read a plane mesh of quadrilaterals that Gmsh has written, as text in
     * format 2 or 4.1. deal.II's reader trusts the file: it takes the memory
     * for as many nodes as the file says it has, and orders cells before
     * anybody can see whether they fit together.
     *
     * Nodes that no cell has are left out; a line is there once for each of its
     * physical groups.
     *
     * @param name of the file.
     * @param length_unit what a coordinate 1 stands for [m].
     * @param where the parameter that has the name, for messages.
     * @throws ExcParameter, with the line where there is one, if the file
     * cannot be read or is no such mesh.
     */
    PlaneMesh
    read_gmsh(const std::string &name,
              const double       length_unit,
              const std::string &where);
  } // namespace Gmsh
} // namespace Tribody

#endif

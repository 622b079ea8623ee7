// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_elasticity_mesh_file_h
#define tribody_elasticity_mesh_file_h

#include <string>

namespace dealii
{
  class ParameterHandler;
  template <int dim, int spacedim>
  class Triangulation;
} // namespace dealii

namespace Tribody
{
  namespace Elasticity
  {
    /// A mesh of quadrilaterals that Gmsh has written.
    struct MeshFile
    {
      /// Empty: there is none.
      std::string name;
      /// Gmsh's physical group of the bore.
      unsigned int bore_id = 1;
      /// Gmsh's physical group of the rim.
      unsigned int rim_id = 2;
      /// What a coordinate 1 in the file stands for [m].
      double length_unit = 1.;
      /// How often every cell is divided into four.
      unsigned int n_refinements = 0;

      /// Declares in the current subsection.
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// Whether there is a file; else a ring is meshed.
      bool
      is_given() const
      {
        return !name.empty();
      }
    };

    /**
     * Read the mesh of a bushing with the bore |x| = @p inner_radius [m]. Its
     * bore and rim get BoundaryIds, all other boundaries are free. The bore's
     * nodes, which may be off by a ten-thousandth of the radius, are put onto
     * the circle, and a manifold keeps the bore round between them.
     *
     * @param path of the subsection of @p file, for messages.
     * @throws ExcParameter if the file cannot be read or is not a mesh of
     *   quadrilaterals; if it lacks a boundary with one of the ids; if the
     *   bore is not one closed curve around the origin with the given radius.
     */
    void
    read_ring_mesh(const MeshFile              &file,
                   const double                 inner_radius,
                   const std::string           &path,
                   dealii::Triangulation<2, 2> &triangulation);
  } // namespace Elasticity
} // namespace Tribody

#endif

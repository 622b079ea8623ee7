// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_elasticity_ring_mesh_h
#define tribody_elasticity_ring_mesh_h

#include <deal.II/base/point.h>

#include <Eigen/Core>

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
    /**
     * How finely a bushing is meshed. The defaults reproduce the peak pressure
     * of the validation joint to 0.1 % with quadratic elements
     * (tests/contact/bushing_contact_01).
     */
    struct RingMeshParameters
    {
      /// Cells around the bore [-].
      unsigned int n_bore_cells = 180;
      /// Layers of cells from bore to rim [-].
      unsigned int n_radial_cells = 6;
      /// Grading from the bore outward [-]; 0 makes all layers equally thick.
      double grading = 1.5;
      /// Nodes in the arc of contact that the mesh is to have, whatever the
      /// numbers of cells; 0: these decide. Whoever knows the forces heeds it.
      unsigned int n_contact_nodes = 0;
      /// How often the cells near the bore in a sector are divided in four.
      unsigned int n_sector_refinements = 0;
      /// Where that sector begins and ends, counter-clockwise [rad].
      dealii::Point<2> sector = dealii::Point<2>();

      /// Declares in the current subsection.
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// Thickness of the innermost of @p n layers, as a fraction of the wall.
      double
      innermost_layer(const unsigned int n) const;

      /// @param path of the subsection, for the message.
      /// @throws ExcParameter for a value that cannot be meshed.
      void
      check(const std::string &path) const;
    };

    /**
     * Mesh the ring @p inner_radius < |x| < @p outer_radius [m] with
     * BoundaryIds on bore and rim and a spherical manifold everywhere. The
     * radii of the layers are
     * @f[ r_k = r_o - (r_o - r_i)\,\frac{\tanh(\gamma (1 - k/n))}{\tanh\gamma}
     * @f] with the grading @f$\gamma@f$.
     *
     * A distributed mesh is refined from the coarsest ring that halving both
     * numbers of cells leads to, as every rank holds that one. It must not be
     * repartitioned later: cells that come to another rank are made anew there,
     * and without the grading.
     */
    void
    make_ring_mesh(const RingMeshParameters    &parameters,
                   const double                 inner_radius,
                   const double                 outer_radius,
                   dealii::Triangulation<2, 2> &triangulation);

    /**
     * Divide the cells of the sector of @p parameters in four as often as these
     * say, the k-th time those that lie up to @f$2^{-k}@f$ of @p wall [m]
     * below the bore of @p inner_radius. The bore stays one closed curve of
     * whole faces; nodes hang on faces inside only.
     * @param path of the subsection, for the message.
     * @throws ExcParameter if no cell lies in the sector.
     */
    void
    refine_sector(const RingMeshParameters    &parameters,
                  const double                 inner_radius,
                  const double                 wall,
                  const std::string           &path,
                  dealii::Triangulation<2, 2> &triangulation);

    /// How thick the unworn wall is at each of the @p angles [rad], from the
    /// bore of @p inner_radius to the first boundary that a ray meets, be it
    /// the rim or a hole [m].
    Eigen::VectorXd
    wall_thickness(const dealii::Triangulation<2, 2> &triangulation,
                   const double                       inner_radius,
                   const Eigen::VectorXd             &angles);

    /// The thinnest place between the bore of @p inner_radius and the vertices
    /// of the rim [m].
    double
    thinnest_wall(const dealii::Triangulation<2, 2> &triangulation,
                  const double                       inner_radius);

    /**
     * Mesh the cross section of a pin, @p hole_radius < |x| < @p radius [m],
     * with the same number of cells around as the bore and layers that shrink
     * towards its surface by the same rule. The surface has
     * BoundaryIds::pin_surface, the hole BoundaryIds::free.
     *
     * A solid pin (@p hole_radius = 0) gets a hole of a thousandth of its
     * radius, by which all cells around are alike: it makes the pin more
     * compliant by a few parts in a million.
     */
    void
    make_pin_mesh(const RingMeshParameters    &parameters,
                  const double                 hole_radius,
                  const double                 radius,
                  dealii::Triangulation<2, 2> &triangulation);
  } // namespace Elasticity
} // namespace Tribody

#endif

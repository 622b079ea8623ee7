// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_elasticity_rim_shape_h
#define tribody_elasticity_rim_shape_h

#include <deal.II/base/point.h>

#include <tribody/base/choice.h>
#include <tribody/elasticity/ring_mesh.h>

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
     * The rim of a bushing whose bore has its centre in (0, 0): a circle or an
     * ellipse with its axes along x and y,
     * @f[ x(t) = c + (a \cos t,\; b \sin t). @f]
     * The first semi-axis a is the outer radius, kept elsewhere.
     */
    struct RimShape
    {
      /// The curve x(t).
      enum class Kind
      {
        circle,
        ellipse
      };

      /// An ellipse has its own second semi-axis; in a circle b = a.
      Kind kind = Kind::circle;
      /// c [m].
      dealii::Point<2> centre = dealii::Point<2>();
      /// b [m] of an ellipse.
      double second_semi_axis = 0.;

      /// Declares in the current subsection.
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// @param path of the subsection, for the message.
      /// @throws ExcParameter if the rim does not enclose the bore.
      void
      check(const std::string &path,
            const double       inner_radius,
            const double       outer_radius) const;

      /// Whether bore and rim are circles about one centre, so that all cells
      /// are alike.
      bool
      is_concentric_circle() const
      {
        return kind == Kind::circle && centre.norm() == 0.;
      }

      /// x(t) [m] with the first semi-axis @p outer_radius.
      dealii::Point<2>
      point(const double outer_radius, const double t) const;
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<RimShape::Kind>
    choice_names(const RimShape::Kind)
    {
      return {{RimShape::Kind::circle, "circle"},
              {RimShape::Kind::ellipse, "ellipse"}};
    }

    /**
     * Mesh the ring between the circle of @p inner_radius and the rim @p shape.
     * The layers of make_ring_mesh() are moved along the straight lines from
     * @f$ r_i (\cos t, \sin t) @f$ to @f$ x(t) @f$; bore and rim get manifolds
     * that keep them round and elliptic.
     */
    void
    make_ring_mesh(const RingMeshParameters    &parameters,
                   const double                 inner_radius,
                   const double                 outer_radius,
                   const RimShape              &shape,
                   dealii::Triangulation<2, 2> &triangulation);
  } // namespace Elasticity
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>
#include <deal.II/grid/tria.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/elasticity/rim_shape.h>
#include <tribody/surface/boundary_ids.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace Tribody
{
  namespace Elasticity
  {
    void
    RimShape::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_choice(
        prm,
        "Outer shape",
        kind,
        "The rim: a circle of the outer radius, or an ellipse with the outer "
        "radius as its semi-axis along x of the bushing's frame.");
      Parameters::add_quantity(prm,
                               "Second semi-axis",
                               second_semi_axis,
                               "m",
                               "Semi-axis along y of an 'ellipse', larger than "
                               "the joint's bushing radius.",
                               "mm");
      Parameters::add_point(prm,
                            "Outer centre",
                            centre,
                            "m",
                            "Centre of the rim, seen from the centre of the "
                            "bore, in the bushing's frame.",
                            "mm");
    }



    void
    RimShape::check(const std::string &path,
                    const double       inner_radius,
                    const double       outer_radius) const
    {
      // Finer than any wall that could be meshed, and too thick a one for the
      // same number of layers.
      constexpr unsigned int               n_samples = 7200;
      constexpr double                     thickest  = 1e3;
      const std::pair<std::string, double> largest =
        std::max({std::make_pair(std::string("Outer radius"), outer_radius),
                  std::make_pair(std::string("Second semi-axis"),
                                 kind == Kind::ellipse ? second_semi_axis : 0.),
                  std::make_pair(std::string("Outer centre"), centre.norm())},
                 [](const auto &a, const auto &b) {
                   return a.second < b.second;
                 });
      AssertThrow(largest.second <= thickest * inner_radius,
                  ExcParameter(path + "/" + largest.first,
                               Units::to_string(largest.second, "m", "mm") +
                                 " is more than 1000 times the bushing radius "
                                 "of the joint, " +
                                 Units::to_string(inner_radius, "m", "mm") +
                                 ": no mesh of such a wall is any good"));
      AssertThrow(kind == Kind::circle || second_semi_axis > inner_radius,
                  ExcParameter(path + "/Second semi-axis",
                               Units::to_string(second_semi_axis, "m", "mm") +
                                 " must be larger than the bushing radius of "
                                 "the joint, " +
                                 Units::to_string(inner_radius, "m", "mm")));
      for (unsigned int i = 0; i < n_samples; ++i)
        {
          const double t = 2. * dealii::numbers::PI * i / n_samples;
          AssertThrow(
            point(outer_radius, t).norm() > inner_radius,
            ExcParameter(path + "/Outer centre",
                         "with it the rim cuts the bore at " +
                           Units::to_string(t, "rad", "deg") +
                           "; the rim must enclose the circle of the "
                           "joint's bushing radius, " +
                           Units::to_string(inner_radius, "m", "mm")));
        }
    }



    dealii::Point<2>
    RimShape::point(const double outer_radius, const double t) const
    {
      const double b = kind == Kind::ellipse ? second_semi_axis : outer_radius;
      return {centre[0] + outer_radius * std::cos(t),
              centre[1] + b * std::sin(t)};
    }



    void
    make_ring_mesh(const RingMeshParameters    &parameters,
                   const double                 inner_radius,
                   const double                 outer_radius,
                   const RimShape              &shape,
                   dealii::Triangulation<2, 2> &triangulation)
    {
      make_ring_mesh(parameters, inner_radius, outer_radius, triangulation);
      if (shape.is_concentric_circle())
        return;

      dealii::GridTools::transform(
        [&](const dealii::Point<2> &x) {
          const double r = x.norm();
          const double s = (r - inner_radius) / (outer_radius - inner_radius);
          const dealii::Point<2> at_rim =
            shape.point(outer_radius, std::atan2(x[1], x[0]));
          return dealii::Point<2>((1. - s) * inner_radius / r * x + s * at_rim);
        },
        triangulation);

      triangulation.reset_all_manifolds();
      triangulation.set_all_manifold_ids(dealii::numbers::flat_manifold_id);
      for (const auto id : {BoundaryIds::bore, BoundaryIds::rim})
        triangulation.set_all_manifold_ids_on_boundary(id, id);
      triangulation.set_manifold(BoundaryIds::bore,
                                 dealii::SphericalManifold<2>());
      const double a = outer_radius;
      const double b =
        shape.point(a, 0.5 * dealii::numbers::PI)[1] - shape.centre[1];
      if (a == b)
        triangulation.set_manifold(BoundaryIds::rim,
                                   dealii::SphericalManifold<2>(shape.centre));
      else
        {
          dealii::Tensor<1, 2> major_axis;
          major_axis[a > b ? 0 : 1] = 1.;
          const double ratio        = std::min(a, b) / std::max(a, b);
          triangulation.set_manifold(
            BoundaryIds::rim,
            dealii::EllipticalManifold<2>(shape.centre,
                                          major_axis,
                                          std::sqrt(1. - ratio * ratio)));
        }
    }
  } // namespace Elasticity
} // namespace Tribody

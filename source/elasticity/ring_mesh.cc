#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/elasticity/ring_mesh.h>
#include <tribody/surface/boundary_ids.h>

#include <cmath>

namespace Tribody
{
  namespace Elasticity
  {
    void
    RingMeshParameters::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_integer(
        prm,
        "Bore cells",
        n_bore_cells,
        "Number of cells around the bore. The contact pressure is resolved "
        "when a contact arc holds ten or more.",
        8,
        100000);
      Parameters::add_integer(
        prm,
        "Radial cells",
        n_radial_cells,
        "Number of layers of cells from the bore to the rim.",
        1,
        10000);
      Parameters::add_quantity(
        prm,
        "Grading",
        grading,
        "",
        "How strongly the layers shrink towards the bore: the ratio of "
        "outermost to innermost layer is about cosh^2 of this number; 0 makes "
        "all of them equally thick.");
    }



    void
    RingMeshParameters::check(const std::string &path) const
    {
      AssertThrow(grading >= 0. && grading <= 5.,
                  ExcParameter(path + "/Grading",
                               Units::to_string(grading, "", "") +
                                 " is not in [0, 5]."));
    }



    void
    make_ring_mesh(const RingMeshParameters    &parameters,
                   const double                 inner_radius,
                   const double                 outer_radius,
                   dealii::Triangulation<2, 2> &triangulation)
    {
      static_assert(BoundaryIds::bore == 0 && BoundaryIds::rim == 1,
                    "GridGenerator::concentric_hyper_shells says so");
      dealii::GridGenerator::concentric_hyper_shells(triangulation,
                                                     dealii::Point<2>(),
                                                     inner_radius,
                                                     outer_radius,
                                                     parameters.n_radial_cells,
                                                     parameters.grading,
                                                     parameters.n_bore_cells,
                                                     /*colorize = */ true);
    }



    void
    make_pin_mesh(const RingMeshParameters    &parameters,
                  const double                 hole_radius,
                  const double                 radius,
                  dealii::Triangulation<2, 2> &triangulation)
    {
      const double inner = (hole_radius > 0.) ? hole_radius : 1e-3 * radius;
      dealii::GridGenerator::concentric_hyper_shells(triangulation,
                                                     dealii::Point<2>(),
                                                     inner,
                                                     radius,
                                                     parameters.n_radial_cells,
                                                     /*skewness = */ 0.,
                                                     parameters.n_bore_cells,
                                                     /*colorize = */ true);
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            face->set_boundary_id(face->boundary_id() == 1
                                    ? BoundaryIds::pin_surface
                                    : BoundaryIds::free);
      const double gamma = parameters.grading;
      if (gamma > 0.)
        dealii::GridTools::transform(
          [&](const dealii::Point<2> &x) {
            const double r     = x.norm();
            const double depth = (radius - r) / (radius - inner);
            const double graded =
              1. - std::tanh(gamma * (1. - depth)) / std::tanh(gamma);
            return dealii::Point<2>(x * (radius - graded * (radius - inner)) /
                                    r);
          },
          triangulation);
    }
  } // namespace Elasticity
} // namespace Tribody

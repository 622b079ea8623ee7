#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/elasticity/ring_mesh.h>
#include <tribody/surface/boundary_ids.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
      Parameters::add_integer(
        prm,
        "Nodes across contact",
        n_contact_nodes,
        "Bore nodes in the arc of contact under the largest force of the first "
        "cycle: the bore gets the cells, and the ring the layers, that this "
        "takes, instead of 'Bore cells' and 'Radial cells'. With 20 the "
        "largest pressure is right to about 1 %, with 40 to about 0.3 %. 0: "
        "the numbers of cells are taken as they are given.",
        0,
        10000);
      Parameters::add_integer(
        prm,
        "Sector refinements",
        n_sector_refinements,
        "How often the cells near the bore in the 'Refined sector' are divided "
        "into four: the cells that contact can reach, if it stays on one side. "
        "Its edges should not lie where the pressure is to be known best.",
        0,
        8);
      Parameters::add_point(prm,
                            "Refined sector",
                            sector,
                            "rad",
                            "Where the refined sector begins and where it "
                            "ends, counter-clockwise in the bushing's frame, "
                            "as in '90 deg, 270 deg'.",
                            "deg");
    }



    double
    RingMeshParameters::innermost_layer(const unsigned int n) const
    {
      if (grading == 0.)
        return 1. / n;
      return 1. - std::tanh(grading * (1. - 1. / n)) / std::tanh(grading);
    }



    void
    RingMeshParameters::check(const std::string &path) const
    {
      AssertThrow(grading >= 0. && grading <= 5.,
                  ExcParameter(path + "/Grading",
                               Units::to_string(grading, "", "") +
                                 " is not in [0, 5]."));
      const double width = sector[1] - sector[0];
      AssertThrow(n_sector_refinements == 0 ||
                    (width > 0. && width < 2. * M_PI),
                  ExcParameter(path + "/Refined sector",
                               "it must end after it begins, less than a turn "
                               "later; it is " +
                                 Units::to_string(width, "rad", "deg") +
                                 " wide"));
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
    refine_sector(const RingMeshParameters    &parameters,
                  const double                 inner_radius,
                  const double                 wall,
                  const std::string           &path,
                  dealii::Triangulation<2, 2> &triangulation)
    {
      const double middle = 0.5 * (parameters.sector[0] + parameters.sector[1]);
      const double half_width =
        0.5 * (parameters.sector[1] - parameters.sector[0]);
      const auto from_middle = [middle](const dealii::Point<2> &x) {
        return std::abs(
          std::remainder(std::atan2(x[1], x[0]) - middle, 2. * M_PI));
      };
      for (unsigned int k = 1; k <= parameters.n_sector_refinements; ++k)
        {
          bool any = false;
          for (const auto &cell : triangulation.active_cell_iterators())
            {
              const dealii::Point<2> centre = cell->center();
              if (from_middle(centre) < half_width &&
                  centre.norm() - inner_radius < std::pow(0.5, k) * wall)
                {
                  cell->set_refine_flag();
                  any = true;
                }
            }
          AssertThrow(any,
                      ExcParameter(path + "/Refined sector",
                                   "is narrower than a cell: nothing would be "
                                   "refined; more 'Bore cells' or a wider "
                                   "sector"));
          triangulation.execute_coarsening_and_refinement();
        }
    }



    double
    thinnest_wall(const dealii::Triangulation<2, 2> &triangulation,
                  const double                       inner_radius)
    {
      double thinnest = std::numeric_limits<double>::max();
      for (const auto &face : triangulation.active_face_iterators())
        if (face->at_boundary() && face->boundary_id() == BoundaryIds::rim)
          for (const unsigned int v : face->vertex_indices())
            thinnest =
              std::min(thinnest, face->vertex(v).norm() - inner_radius);
      return thinnest;
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

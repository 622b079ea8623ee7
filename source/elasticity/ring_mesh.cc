// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/filtered_iterator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>
#include <deal.II/grid/tria.h>

#include <tribody/algebra/mesh_algebra.h>
#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/elasticity/ring_mesh.h>
#include <tribody/surface/boundary_ids.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace Tribody
{
  namespace Elasticity
  {
    namespace
    {
      /// Of the k-th of n layers, counted from the inner radius; a whole one
      /// or a part.
      double
      layer_radius(const double       inner_radius,
                   const double       outer_radius,
                   const double       k,
                   const unsigned int n,
                   const double       grading)
      {
        const double from_rim = 1. - k / n;
        const double part =
          grading > 0. ? std::tanh(grading * from_rim) / std::tanh(grading)
                       : from_rim;
        return outer_radius - part * (outer_radius - inner_radius);
      }



      // GridGenerator::concentric_hyper_shells() merges rings of cells by the
      // places of their vertices, and for some numbers of cells and layers
      // leaves some unmerged: a crack.
      void
      make_shells(const double                     inner_radius,
                  const double                     outer_radius,
                  const unsigned int               n,
                  const unsigned int               n_layers,
                  const double                     grading,
                  const dealii::types::boundary_id inner_id,
                  const dealii::types::boundary_id outer_id,
                  dealii::Triangulation<2>        &triangulation)
      {
        std::vector<dealii::Point<2>> vertices;
        for (unsigned int k = 0; k <= n_layers; ++k)
          {
            const double r =
              layer_radius(inner_radius, outer_radius, k, n_layers, grading);
            for (unsigned int i = 0; i < n; ++i)
              {
                const double angle = 2. * dealii::numbers::PI * i / n;
                vertices.emplace_back(r * std::cos(angle), r * std::sin(angle));
              }
          }

        std::vector<dealii::CellData<2>> cells;
        dealii::SubCellData              boundary;
        for (unsigned int k = 0; k < n_layers; ++k)
          for (unsigned int i = 0; i < n; ++i)
            {
              const unsigned int  next = (i + 1) % n;
              dealii::CellData<2> cell;
              cell.vertices = {k * n + i,
                               (k + 1) * n + i,
                               k * n + next,
                               (k + 1) * n + next};
              cells.push_back(cell);
            }
        for (const auto &[k, id] :
             {std::make_pair(0U, inner_id), std::make_pair(n_layers, outer_id)})
          for (unsigned int i = 0; i < n; ++i)
            {
              dealii::CellData<1> face;
              face.vertices    = {k * n + i, k * n + (i + 1) % n};
              face.boundary_id = id;
              boundary.boundary_lines.push_back(face);
            }
        triangulation.create_triangulation(vertices, cells, boundary);
        triangulation.set_all_manifold_ids(0);
        triangulation.set_manifold(0, dealii::SphericalManifold<2>());
      }



      // Every rank holds the coarse mesh of a distributed one. It is therefore
      // as coarse as numbers of cells can be halved, and refined on the ranks
      // that own what comes of it. Layers are graded at last: refinement makes
      // equal ones.
      void
      make_distributed_shells(const RingMeshParameters &parameters,
                              const double              inner_radius,
                              const double              outer_radius,
                              dealii::Triangulation<2> &triangulation)
      {
        constexpr unsigned int fewest_around = 8;
        unsigned int           n             = parameters.n_bore_cells;
        unsigned int           n_layers      = parameters.n_radial_cells;
        unsigned int           n_refinements = 0;
        for (; n % 2 == 0 && n_layers % 2 == 0 && n / 2 >= fewest_around;
             ++n_refinements)
          {
            n /= 2;
            n_layers /= 2;
          }
        make_shells(inner_radius,
                    outer_radius,
                    n,
                    n_layers,
                    /*grading = */ 0.,
                    BoundaryIds::bore,
                    BoundaryIds::rim,
                    triangulation);
        triangulation.refine_global(n_refinements);
        const double layer =
          (outer_radius - inner_radius) / parameters.n_radial_cells;
        dealii::GridTools::transform(
          [&](const dealii::Point<2> &x) {
            const double r = x.norm();
            const double k = std::round((r - inner_radius) / layer);
            return dealii::Point<2>(layer_radius(inner_radius,
                                                 outer_radius,
                                                 k,
                                                 parameters.n_radial_cells,
                                                 parameters.grading) /
                                    r * x);
          },
          triangulation);
      }
    } // namespace



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
        "takes, instead of 'Bore cells' and 'Radial cells'. 20 are a good "
        "choice; the error that remains is estimated ('Wear/Mesh error "
        "estimate'). 0: the numbers of cells are taken as they are given.",
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
                    (width > 0. && width < 2. * dealii::numbers::PI),
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
      if (is_distributed(triangulation))
        return make_distributed_shells(parameters,
                                       inner_radius,
                                       outer_radius,
                                       triangulation);
      make_shells(inner_radius,
                  outer_radius,
                  parameters.n_bore_cells,
                  parameters.n_radial_cells,
                  parameters.grading,
                  BoundaryIds::bore,
                  BoundaryIds::rim,
                  triangulation);
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
        return std::abs(std::remainder(std::atan2(x[1], x[0]) - middle,
                                       2. * dealii::numbers::PI));
      };
      for (unsigned int k = 1; k <= parameters.n_sector_refinements; ++k)
        {
          bool any = false;
          for (const auto &cell : triangulation.active_cell_iterators() |
                                    dealii::IteratorFilters::LocallyOwnedCell())
            {
              const dealii::Point<2> centre = cell->center();
              if (from_middle(centre) < half_width &&
                  centre.norm() - inner_radius < std::pow(0.5, k) * wall)
                {
                  cell->set_refine_flag();
                  any = true;
                }
            }
          AssertThrow(dealii::Utilities::MPI::logical_or(
                        any, triangulation.get_communicator()),
                      ExcParameter(path + "/Refined sector",
                                   "is narrower than a cell: nothing would be "
                                   "refined; more 'Bore cells' or a wider "
                                   "sector"));
          triangulation.execute_coarsening_and_refinement();
        }
    }



    namespace
    {
      // A piece of the outside as a curve r(phi), by its begin, middle and end:
      // the angle of the middle, those of the ends against it [rad] and the
      // distances of all three from the origin [m].
      struct OutsidePiece
      {
        double angle, begin, end;
        double r_begin, r_middle, r_end;

        /// Infinite beyond the ends.
        double
        distance(const double at_angle) const
        {
          // Ends of neighbours differ by rounding.
          constexpr double same = 1e-9;

          const double x =
            std::remainder(at_angle - angle, 2. * dealii::numbers::PI);
          if (x < std::min({begin, end, 0.}) - same ||
              x > std::max({begin, end, 0.}) + same)
            return std::numeric_limits<double>::infinity();
          const auto [nearest, farthest] =
            std::minmax({r_begin, r_middle, r_end});
          // Along a ray, or back again.
          if (std::min(begin, end) > -same || std::max(begin, end) < same)
            return nearest;
          const double parabola =
            r_begin * x * (x - end) / (begin * (begin - end)) +
            r_middle * (x - begin) * (x - end) / (begin * end) +
            r_end * x * (x - begin) / (end * (end - begin));
          return std::clamp(parabola, nearest, farthest);
        }
      };



      // All of the boundary but the bore, on all ranks.
      std::vector<OutsidePiece>
      outside_of(const dealii::Triangulation<2, 2> &triangulation)
      {
        std::vector<double> own;
        for (const auto &cell : triangulation.active_cell_iterators() |
                                  dealii::IteratorFilters::LocallyOwnedCell())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && face->boundary_id() != BoundaryIds::bore)
              for (const dealii::Point<2> &x :
                   {face->vertex(0),
                    face->center(/*respect_manifold = */ true),
                    face->vertex(1)})
                {
                  own.push_back(std::atan2(x[1], x[0]));
                  own.push_back(x.norm());
                }
        std::vector<OutsidePiece> pieces;
        for (const std::vector<double> &p : dealii::Utilities::MPI::all_gather(
               triangulation.get_communicator(), own))
          for (std::size_t i = 0; i < p.size(); i += 6)
            {
              const double turn = 2. * dealii::numbers::PI;
              pieces.push_back({p[i + 2],
                                std::remainder(p[i] - p[i + 2], turn),
                                std::remainder(p[i + 4] - p[i + 2], turn),
                                p[i + 1],
                                p[i + 3],
                                p[i + 5]});
            }
        return pieces;
      }
    } // namespace



    Eigen::VectorXd
    wall_thickness(const dealii::Triangulation<2, 2> &triangulation,
                   const double                       inner_radius,
                   const Eigen::VectorXd             &angles)
    {
      const std::vector<OutsidePiece> pieces = outside_of(triangulation);
      return angles.unaryExpr([&](const double angle) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const OutsidePiece &piece : pieces)
          nearest = std::min(nearest, piece.distance(angle));
        return nearest - inner_radius;
      });
    }



    double
    thinnest_wall(const dealii::Triangulation<2, 2> &triangulation,
                  const double                       inner_radius)
    {
      double thinnest = std::numeric_limits<double>::max();
      for (const auto &cell : triangulation.active_cell_iterators() |
                                dealii::IteratorFilters::LocallyOwnedCell())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == BoundaryIds::rim)
            for (const unsigned int v : face->vertex_indices())
              thinnest =
                std::min(thinnest, face->vertex(v).norm() - inner_radius);
      return dealii::Utilities::MPI::min(thinnest,
                                         triangulation.get_communicator());
    }



    void
    make_pin_mesh(const RingMeshParameters    &parameters,
                  const double                 hole_radius,
                  const double                 radius,
                  dealii::Triangulation<2, 2> &triangulation)
    {
      const double inner = (hole_radius > 0.) ? hole_radius : 1e-3 * radius;
      make_shells(inner,
                  radius,
                  parameters.n_bore_cells,
                  parameters.n_radial_cells,
                  /*grading = */ 0.,
                  BoundaryIds::free,
                  BoundaryIds::pin_surface,
                  triangulation);
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

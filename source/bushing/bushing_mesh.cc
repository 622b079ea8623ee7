// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/distributed/tria.h>
#include <deal.II/grid/tria.h>

#include <tribody/bushing/bushing_mesh.h>
#include <tribody/bushing/bushing_parameters.h>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      std::unique_ptr<dealii::Triangulation<2>>
      make_empty_mesh(const BushingParameters &parameters,
                      const MPI_Comm          &communicator)
      {
        using Distributed = dealii::parallel::distributed::Triangulation<2>;
        if (!parameters.shares_mesh())
          return std::make_unique<dealii::Triangulation<2>>();
        // Vertices of make_ring_mesh() that are moved would not follow to
        // another rank.
        return std::make_unique<Distributed>(
          communicator,
          dealii::Triangulation<2>::none,
          Distributed::no_automatic_repartitioning);
      }
    } // namespace



    std::unique_ptr<dealii::Triangulation<2>>
    make_bushing_mesh(const BushingParameters &parameters,
                      const double             bushing_radius,
                      const MPI_Comm          &communicator)
    {
      const std::string path = "Bushing " + parameters.name + "/Mesh";
      auto              mesh = make_empty_mesh(parameters, communicator);
      dealii::Triangulation<2> &triangulation = *mesh;
      if (parameters.mesh_file.is_given())
        Elasticity::read_ring_mesh(parameters.mesh_file,
                                   bushing_radius,
                                   path,
                                   triangulation);
      else
        Elasticity::make_ring_mesh(parameters.mesh,
                                   bushing_radius,
                                   parameters.outer_radius,
                                   parameters.rim_shape,
                                   triangulation);
      Elasticity::refine_sector(parameters.mesh,
                                bushing_radius,
                                Elasticity::thinnest_wall(triangulation,
                                                          bushing_radius),
                                path,
                                triangulation);
      return mesh;
    }



    std::optional<BushingParameters>
    coarsen_mesh(const BushingParameters &parameters)
    {
      // Every rank has all of it: it is small enough for the direct solver.
      BushingParameters coarse = parameters;
      coarse.stiffness_solver  = StiffnessSolver::direct;
      if (parameters.mesh_file.is_given())
        {
          if (parameters.mesh_file.n_refinements == 0)
            return {};
          --coarse.mesh_file.n_refinements;
          return coarse;
        }
      coarse.mesh.n_bore_cells   = (parameters.mesh.n_bore_cells + 1) / 2;
      coarse.mesh.n_radial_cells = (parameters.mesh.n_radial_cells + 1) / 2;
      return coarse;
    }
  } // namespace Coupling
} // namespace Tribody

#include <deal.II/grid/tria.h>

#include <tribody/coupling/bushing_mesh.h>
#include <tribody/coupling/bushing_parameters.h>

namespace Tribody
{
  namespace Coupling
  {
    dealii::Triangulation<2>
    make_bushing_mesh(const BushingParameters &parameters,
                      const double             bushing_radius)
    {
      const std::string        path = "Bushing " + parameters.name + "/Mesh";
      dealii::Triangulation<2> triangulation;
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
      return triangulation;
    }



    std::optional<BushingParameters>
    coarsen_mesh(const BushingParameters &parameters)
    {
      BushingParameters coarse = parameters;
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

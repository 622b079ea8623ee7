// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_bushing_bushing_mesh_h
#define tribody_bushing_bushing_mesh_h

#include <memory>
#include <mpi.h>
#include <optional>

namespace dealii
{
  template <int dim, int spacedim>
  class Triangulation;
}

namespace Tribody
{
  namespace Coupling
  {
    struct BushingParameters;

    /**
     * The mesh of a bushing with the bore radius @p bushing_radius [m]: a ring
     * or what its file holds, refined in the sector where that is asked for.
     * With 'Stiffness solver' = multigrid the ranks of @p communicator share
     * its cells; otherwise each of them has the whole mesh.
     * @throws ExcParameter for what cannot be meshed, see
     *   Elasticity::read_ring_mesh().
     */
    std::unique_ptr<dealii::Triangulation<2, 2>>
    make_bushing_mesh(const BushingParameters &parameters,
                      const double             bushing_radius,
                      const MPI_Comm          &communicator = MPI_COMM_SELF);

    /**
     * The same bushing on the next coarser mesh: half as many cells around and
     * half as many layers, or one refinement of the file less. Nothing if there
     * is none.
     */
    std::optional<BushingParameters>
    coarsen_mesh(const BushingParameters &parameters);
  } // namespace Coupling
} // namespace Tribody

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_stepping_mesh_error_h
#define tribody_stepping_mesh_error_h

namespace Tribody
{
  namespace Coupling
  {
    /// How much a result changes from the next coarser mesh to the one that was
    /// used, relative [-].
    struct MeshError
    {
      /// Bore nodes of the mesh that was used; 0: there is no estimate.
      unsigned int n_nodes = 0;
      /// Bore nodes of the next coarser mesh.
      unsigned int n_coarse_nodes = 0;
      /// Of the largest pressure of the first cycle.
      double max_pressure = 0.;
      /// Of the maximum depth.
      double wear_depth = 0.;
      /// Whether that depth is of the whole run, not of the first cycle alone.
      bool covers_whole_run = false;
    };
  } // namespace Coupling
} // namespace Tribody

#endif

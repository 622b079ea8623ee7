#ifndef tribody_surface_boundary_ids_h
#define tribody_surface_boundary_ids_h

#include <deal.II/base/types.h>

namespace Tribody
{
  /// Boundary indicators of every bushing mesh.
  namespace BoundaryIds
  {
    /// The bore, on which the pin slides.
    constexpr dealii::types::boundary_id bore = 0;
    /// The outer rim, by which the bushing is held.
    constexpr dealii::types::boundary_id rim = 1;
  } // namespace BoundaryIds
} // namespace Tribody

#endif

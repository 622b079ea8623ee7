// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_surface_boundary_ids_h
#define tribody_surface_boundary_ids_h

#include <deal.II/base/types.h>

namespace Tribody
{
  /// Boundary indicators of every mesh of a bushing or a pin.
  namespace BoundaryIds
  {
    /// The bore, on which the pin slides.
    constexpr dealii::types::boundary_id bore = 0;
    /// The outer rim, by which the bushing is held.
    constexpr dealii::types::boundary_id rim = 1;
    /// The outside of a pin, which slides in the bore.
    constexpr dealii::types::boundary_id pin_surface = 2;
    /// What is left free of forces, the hole of a pin for example.
    constexpr dealii::types::boundary_id free = 3;
  } // namespace BoundaryIds
} // namespace Tribody

#endif

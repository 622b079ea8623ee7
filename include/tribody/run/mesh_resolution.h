// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_run_mesh_resolution_h
#define tribody_run_mesh_resolution_h

#include <tribody/bushing/bushing_parameters.h>
#include <tribody/multibody/cycle/duty_cycle.h>
#include <tribody/multibody/joints/joint_parameters.h>

namespace Tribody
{
  namespace Coupling
  {
    /**
     * The bushing @p parameters with the mesh that its 'Nodes across contact'
     * asks for: so many bore cells that this number of nodes lies in the arc of
     * contact of the unworn bore under the largest force of @p cycle, and so
     * many layers that the innermost is not thicker than a bore cell is
     * wide. In a refined sector the cells there are so many.
     *
     * The arc is that of a contact solved on a coarse mesh, with cells doubled
     * until it holds enough nodes to be known to a few per cent. Without a
     * force, or if nothing is asked for, the parameters are returned as they
     * are.
     * @throws ExcRun if the arc is so narrow that it cannot be meshed so.
     */
    BushingParameters
    resolve_contact_arc(const BushingParameters          &parameters,
                        const Multibody::JointParameters &joint,
                        const Multibody::JointDutyCycle  &cycle);
  } // namespace Coupling
} // namespace Tribody

#endif

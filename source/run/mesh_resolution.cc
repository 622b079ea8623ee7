// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>
#include <deal.II/grid/tria.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/units.h>
#include <tribody/bushing/bushing_mesh.h>
#include <tribody/bushing/elastic_joint.h>
#include <tribody/contact/contact_solver.h>
#include <tribody/run/mesh_resolution.h>

#include <algorithm>
#include <cmath>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      /// With so many nodes in contact the arc is known to a few per cent.
      constexpr std::size_t enough_nodes = 12;

      /// More cells around make a dense compliance of several gigabytes.
      constexpr unsigned int max_bore_cells = 10000;

      unsigned int
      count_layers(const Elasticity::RingMeshParameters &mesh,
                   const double                          cell_width,
                   const double                          wall)
      {
        unsigned int n = 1;
        while (n < 1000 && mesh.innermost_layer(n) * wall > cell_width)
          ++n;
        return n;
      }



      void
      set_bore_cells(BushingParameters                &parameters,
                     const Multibody::JointParameters &joint,
                     const unsigned int                n)
      {
        parameters.mesh.n_bore_cells = n;
        parameters.mesh.n_radial_cells =
          count_layers(parameters.mesh,
                       2. * dealii::numbers::PI * joint.bushing_radius / n,
                       Elasticity::thinnest_wall(
                         *make_bushing_mesh(parameters, joint.bushing_radius),
                         joint.bushing_radius));
      }



      /// Under the largest force of the cycle [rad].
      double
      contact_arc(BushingParameters                 parameters,
                  const Multibody::JointParameters &joint,
                  const Multibody::JointDutyCycle  &cycle)
      {
        Eigen::Index j;
        cycle.normal_force.maxCoeff(&j);
        const double          angle = cycle.contact_angle_bushing[j];
        const Eigen::Vector2d force =
          cycle.normal_force[j] / parameters.axial_length *
          Eigen::Vector2d(std::cos(angle), std::sin(angle));
        // Here the whole bore is as fine.
        parameters.mesh.n_sector_refinements = 0;
        for (unsigned int n = 30; n <= max_bore_cells; n *= 2)
          {
            set_bore_cells(parameters, joint, n);
            const ElasticJoint     elastic(parameters, joint, 1.);
            Contact::ContactSolver solver(elastic.bore(),
                                          elastic.compliance(),
                                          joint.pin_radius,
                                          parameters.contact_solver,
                                          elastic.housing());
            const auto solution = solver.solve_force_controlled(force);
            if (solution.report.converged &&
                solution.active_set.size() >= enough_nodes)
              return 2. * solution.half_angle;
          }
        throw ExcRun("Bushing " + parameters.name +
                     ": the contact under the largest force of the cycle, " +
                     std::to_string(cycle.normal_force[j]) +
                     " N, is so narrow that " + std::to_string(max_bore_cells) +
                     " bore cells do not resolve it. Set 'Bore cells' instead "
                     "of 'Nodes across contact'.");
      }
    } // namespace



    BushingParameters
    resolve_contact_arc(const BushingParameters          &parameters,
                        const Multibody::JointParameters &joint,
                        const Multibody::JointDutyCycle  &cycle)
    {
      const unsigned int n_nodes = parameters.mesh.n_contact_nodes;
      if (n_nodes == 0 || !(cycle.normal_force.maxCoeff() > 0.))
        return parameters;

      const double arc          = contact_arc(parameters, joint, cycle);
      const double n_fine_cells = std::ceil(n_nodes * 2. * dealii::numbers::PI /
                                            (arc * parameters.element_degree));
      AssertThrow(
        n_fine_cells <= max_bore_cells,
        ExcRun("Bushing " + parameters.name + ": " + std::to_string(n_nodes) +
               " nodes across a contact arc of " +
               Units::to_string(arc, "rad", "deg") + " take " +
               std::to_string(std::lround(n_fine_cells)) +
               " bore cells, more than " + std::to_string(max_bore_cells) +
               ". Ask for fewer 'Nodes across contact', or set "
               "'Bore cells' and a 'Refined sector'."));
      const double cells = std::ceil(
        n_fine_cells * std::pow(0.5, parameters.mesh.n_sector_refinements));
      BushingParameters result = parameters;
      // An even number, so that the next coarser mesh has half as many; and
      // enough to be round.
      set_bore_cells(
        result,
        joint,
        std::max(12U, 2U * static_cast<unsigned int>(std::ceil(0.5 * cells))));
      return result;
    }
  } // namespace Coupling
} // namespace Tribody

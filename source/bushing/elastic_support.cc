// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/bushing/elastic_joint.h>
#include <tribody/bushing/elastic_support.h>
#include <tribody/surface/turned_surfaces.h>

namespace Tribody
{
  namespace Coupling
  {
    ElasticSupport::ElasticSupport(const ElasticJoint      &joint,
                                   const BushingParameters &parameters,
                                   const double             pin_radius,
                                   const PeriodicProfile   &pin_wear,
                                   const double             closing)
      : name(parameters.name)
      , axial_length(parameters.axial_length)
      , pin_wear(pin_wear)
      , facing_angles(
          TurnedSurfaces::facing_node_angles(joint.bore(),
                                             joint.bore_nodes().positions))
      , closing(closing)
      , solver(joint.bore(),
               joint.compliance(),
               pin_radius,
               parameters.contact_solver)
    {}



    ElasticSupport::Recess
    ElasticSupport::compute_recess(const double alpha) const
    {
      Recess recess;
      if (closing == 0. && pin_wear.is_constant() && pin_wear.mean() == 0.)
        return recess;
      const Eigen::Index n = facing_angles.size();
      recess.value.resize(n);
      recess.slope.resize(n);
      recess.curvature.resize(n);
      for (Eigen::Index i = 0; i < n; ++i)
        {
          const PeriodicProfile::Values wear =
            pin_wear.evaluate(facing_angles[i] - alpha);
          recess.value[i]     = wear.value - closing;
          recess.slope[i]     = -wear.first_derivative;
          recess.curvature[i] = wear.second_derivative;
        }
      return recess;
    }



    void
    ElasticSupport::check(const Contact::ContactSolution &solution,
                          const std::string              &given) const
    {
      // Errors of the forces are those of the gaps times the condition of the
      // compliance, 1e3 at most: 1e-6, where the motion is right to some 1e-3.
      constexpr double    sufficient = 1e-9;
      const SolverReport &report     = solution.report;
      AssertThrow(report.converged ||
                    (report.stagnated && report.residual <= sufficient),
                  ExcRun("Joint " + name +
                         ": the contact of pin and bushing that the dynamics "
                         "asks for (" +
                         given + ") has no solution: " + report.message +
                         ". A finer mesh (Bore cells) may help."));
    }



    Multibody::SupportForce
    ElasticSupport::compute_force(const Eigen::Vector2d &e,
                                  const double           alpha) const
    {
      const Eigen::Vector3d place(e.x(),
                                  e.y(),
                                  pin_wear.is_constant() ? 0. : alpha);
      if (last_place && *last_place == place)
        return last_force;
      const Recess recess = compute_recess(alpha);
      solver.set_pin_recess(recess.value);
      const Contact::ContactSolution solution =
        solver.solve_position_controlled(e,
                                         last_touching ? &*last_touching
                                                       : nullptr);
      ++solves;
      check(solution,
            "pin at x = " + std::to_string(1e3 * e.x()) +
              " mm, y = " + std::to_string(1e3 * e.y()) + " mm");
      Multibody::SupportForce result;
      if (!solution.active_set.empty())
        {
          const Contact::PinStiffness stiffness =
            solver.compute_pin_stiffness(solution, recess.slope);
          result.force        = axial_length * solution.force;
          result.d_force      = axial_length * stiffness.force;
          result.magnitudes   = axial_length * solution.nodal_force.sum();
          result.d_magnitudes = axial_length * stiffness.nodal_force_sum;
          if (recess.value.size() > 0)
            {
              result.moment =
                axial_length * solution.nodal_force.dot(recess.slope);
              result.d_moment = axial_length * stiffness.moment;
              result.d_moment[2] +=
                axial_length * solution.nodal_force.dot(recess.curvature);
            }
          last_touching = solution;
          result.energy = axial_length * solver.stored_energy(solution);
        }
      last_place = place;
      last_force = result;
      return result;
    }



    Eigen::Vector2d
    ElasticSupport::find_position(const Eigen::Vector2d &force,
                                  const double           alpha) const
    {
      solver.set_pin_recess(compute_recess(alpha).value);
      const Contact::ContactSolution solution =
        solver.solve_force_controlled(force / axial_length,
                                      last_resting ? &*last_resting : nullptr);
      ++solves;
      check(solution, "force " + std::to_string(force.norm()) + " N");
      last_resting = solution;
      return solution.pin_centre;
    }
  } // namespace Coupling
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/multibody/elements/angle_driver.h>
#include <tribody/multibody/elements/distance_driver.h>
#include <tribody/multibody/elements/find_marker.h>
#include <tribody/multibody/elements/rigid_constraint.h>
#include <tribody/multibody/elements/translational_constraint.h>
#include <tribody/multibody/system/mechanism.h>

#include <algorithm>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      Eigen::Vector2d
      to_eigen(const dealii::Point<2> &p)
      {
        return {p[0], p[1]};
      }
    } // namespace



    Mechanism::Mechanism(const MechanismParameters &parameters,
                         const std::vector<bool>   &is_following)
      : the_parameters(parameters)
    {
      parameters.check();
      add_bodies();
      for (const JointParameters &joint : parameters.joints)
        add_joint(joint, is_following);
      for (const DriverParameters &driver : parameters.drivers)
        add_driver(driver);
      for (const SpringParameters &spring : parameters.springs)
        add_spring(spring);
      for (const auto &spring : parameters.rotational_springs)
        add_rotational_spring(spring);
      for (const ForceParameters &force : parameters.forces)
        add_force(force);
      for (const TorqueParameters &torque : parameters.torques)
        add_torque(torque);
    }



    bool
    Mechanism::has_turning_driver() const
    {
      return !the_parameters.drivers.empty() &&
             the_parameters.drivers.front().is_angle() &&
             the_parameters.drivers.front().mean_speed() != 0;
    }



    double
    Mechanism::period() const
    {
      const std::string hint =
        ", but a cycle is one turn of the first driver at its 'Speed'. Where "
        "nothing turns, 'Dynamics/Cycle duration' says how long a cycle is";
      AssertThrow(!the_parameters.drivers.empty(),
                  ExcParameter("Drivers", "is empty" + hint));
      const DriverParameters &driver = the_parameters.drivers.front();
      AssertThrow(driver.is_angle(),
                  ExcParameter("Driver " + driver.name + "/Type",
                               "is '" + name_of(driver.type) + "'" + hint));
      AssertThrow(driver.mean_speed() != 0,
                  ExcParameter("Driver " + driver.name + "/Speed",
                               "is zero" + hint));
      return 2 * dealii::numbers::PI / std::abs(driver.mean_speed());
    }



    bool
    Mechanism::is_driver(const unsigned int constraint) const
    {
      return std::any_of(the_drivers.begin(),
                         the_drivers.end(),
                         [constraint](const DriverEntry &driver) {
                           return driver.constraint == constraint;
                         });
    }



    int
    Mechanism::find_body(const std::string &path, const std::string &name) const
    {
      return Multibody::find_body(path, name, the_parameters.bodies);
    }



    Marker
    Mechanism::find_marker(const std::string &path,
                           const std::string &name) const
    {
      return Multibody::find_marker(path,
                                    name,
                                    the_parameters.ground,
                                    the_parameters.bodies);
    }



    void
    Mechanism::add_bodies()
    {
      the_masses.resize(n_coordinates());
      the_weights.resize(n_coordinates());
      the_initial_coordinates.resize(n_coordinates());
      the_initial_velocities.resize(n_coordinates());
      const Eigen::Vector2d gravity = to_eigen(the_parameters.gravity);
      for (unsigned int i = 0; i < the_parameters.bodies.size(); ++i)
        {
          const BodyParameters &body = the_parameters.bodies[i];
          the_masses.segment<3>(3 * i) << body.mass, body.mass,
            body.moment_of_inertia;
          the_weights.segment<3>(3 * i) << body.mass * gravity, 0.;
          the_initial_coordinates.segment<3>(3 * i)
            << to_eigen(body.initial_position),
            body.initial_angle;
          the_initial_velocities.segment<3>(3 * i)
            << to_eigen(body.initial_velocity),
            body.initial_angular_velocity;
          for (const auto &[name, position] : body.markers)
            the_size = std::max(the_size, position.norm());
        }
      if (the_size == 0)
        the_size = find_distance();
    }



    double
    Mechanism::find_distance() const
    {
      double distance = 0.;
      for (const auto &[name, position] : the_parameters.ground.markers)
        distance = std::max(distance, position.norm());
      for (const BodyParameters &body : the_parameters.bodies)
        distance = std::max(distance, body.initial_position.norm());
      for (const SpringParameters &spring : the_parameters.springs)
        distance = std::max(distance, spring.reference_length);
      // A single body that turns about its centre of mass has no length.
      return distance > 0. ? distance : 1.;
    }



    void
    Mechanism::add_joint(const JointParameters   &joint,
                         const std::vector<bool> &is_following)
    {
      const std::string path = "Joint " + joint.name;
      JointEntry        entry;
      entry.name        = joint.name;
      entry.model       = joint.is_revolute() ? joint.model : JointModel::ideal;
      entry.index       = the_constraints.size();
      entry.is_revolute = joint.is_revolute();
      entry.bushing_radius = joint.bushing_radius;
      Marker first, second;
      if (joint.is_revolute())
        {
          first  = find_marker(path + "/Pin marker", joint.pin_marker);
          second = find_marker(path + "/Bushing marker", joint.bushing_marker);
        }
      else
        {
          first  = find_marker(path + "/First marker", joint.first_marker);
          second = find_marker(path + "/Second marker", joint.second_marker);
        }
      AssertThrow(first.body != second.body,
                  ExcParameter(path,
                               "connects a body with itself: both of its "
                               "markers are on the same one"));
      entry.bodies          = {first.body, second.body};
      entry.first_position  = first.position;
      entry.second_position = second.position;

      if (joint.has_contact_law())
        {
          entry.index = the_clearance_joints.size();
          add_clearance_joint(joint, first, second);
        }
      else if (joint.has_gap())
        add_rigid_clearance(joint, first, second, is_following, entry);
      else if (joint.is_revolute())
        add_constraint(
          std::make_shared<RevoluteConstraint>(path, first, second));
      else if (joint.type == JointType::translational)
        add_constraint(std::make_shared<TranslationalConstraint>(
          path, first, second, joint.axis_angle, joint.relative_angle));
      else if (joint.type == JointType::rigid)
        add_constraint(std::make_shared<RigidConstraint>(
          path, first, second, joint.relative_angle));
      else
        add_constraint(std::make_shared<PointOnLineConstraint>(
          path, first, second, joint.axis_angle));
      the_joints.push_back(entry);
    }



    void
    Mechanism::add_clearance_joint(const JointParameters &joint,
                                   const Marker          &pin,
                                   const Marker          &bushing)
    {
      the_clearance_joints.push_back({joint.name,
                                      {pin.body, bushing.body},
                                      pin.position,
                                      bushing.position,
                                      joint.pin_radius,
                                      joint.bushing_radius,
                                      joint.contact_force_law.make(joint),
                                      joint.friction_law.make(joint),
                                      joint.tangential_damping,
                                      joint.minimum_approach_speed});
      ClearanceJoint &made = the_clearance_joints.back();
      if (has_state(made.friction_law))
        made.friction_state_index = n_states++;
      made.penetration_measure = joint.worn_contact_geometry;
    }



    void
    Mechanism::add_rigid_clearance(const JointParameters   &joint,
                                   const Marker            &pin,
                                   const Marker            &bushing,
                                   const std::vector<bool> &is_following,
                                   JointEntry              &entry)
    {
      const auto link = std::make_shared<const MasslessLinkConstraint>(
        "Joint " + joint.name, pin, bushing, joint.clearance());
      entry.link = link;
      if (joint.model == JointModel::impact)
        {
          const unsigned int number = the_impact_joints.size();
          entry.is_flying = is_following.empty() || !is_following[number];
          the_impact_joints.push_back(
            {static_cast<unsigned int>(the_joints.size()),
             link,
             joint.pin_radius,
             joint.bushing_radius,
             joint.restitution_coefficient,
             joint.friction_law.is<NoFriction>() ? 0.
                                                 : joint.friction_coefficient,
             joint.capture_speed,
             !entry.is_flying,
             n_equations});
        }
      if (entry.is_flying)
        entry.index = static_cast<unsigned int>(-1);
      else
        add_constraint(link);
    }



    void
    Mechanism::add_constraint(
      const std::shared_ptr<const Constraint> &constraint)
    {
      the_constraints.push_back({constraint, n_equations});
      n_equations += constraint->n_equations;
    }



    void
    Mechanism::add_spring(const SpringParameters &spring)
    {
      const std::string path = "Spring " + spring.name;
      const Marker      first =
        find_marker(path + "/First marker", spring.first_marker);
      const Marker second =
        find_marker(path + "/Second marker", spring.second_marker);
      the_springs.push_back({{first.body, second.body},
                             first.position,
                             second.position,
                             spring.stiffness,
                             spring.damping,
                             spring.reference_length,
                             spring.force_at_reference_length});
    }



    void
    Mechanism::add_rotational_spring(const RotationalSpringParameters &spring)
    {
      const std::string path = "Rotational spring " + spring.name;
      the_rotational_springs.push_back(
        {{find_body(path + "/Body", spring.body),
          find_body(path + "/Reference body", spring.reference_body)},
         spring.stiffness,
         spring.damping,
         spring.reference_angle,
         spring.torque_at_reference_angle});
    }



    void
    Mechanism::add_driver(const DriverParameters &driver)
    {
      const std::string  path   = "Driver " + driver.name;
      const DriverMotion motion = driver.motion();
      if (driver.is_angle())
        {
          const BodyPair bodies = {find_body(path + "/Body", driver.body),
                                   find_body(path + "/Reference body",
                                             driver.reference_body)};
          add_driver_constraint(
            motion, std::make_shared<AngleDriver>(path, bodies, motion));
          return;
        }
      const Marker first =
        find_marker(path + "/First marker", driver.first_marker);
      const Marker second =
        find_marker(path + "/Second marker", driver.second_marker);
      AssertThrow(first.body != second.body,
                  ExcParameter(path,
                               "drives the distance of two markers of the same "
                               "body, which cannot change"));
      add_driver_constraint(
        motion, std::make_shared<DistanceDriver>(path, first, second, motion));
    }



    void
    Mechanism::add_driver_constraint(
      const DriverMotion                      &motion,
      const std::shared_ptr<const Constraint> &constraint)
    {
      the_drivers.push_back(
        {motion, static_cast<unsigned int>(the_constraints.size())});
      add_constraint(constraint);
    }



    void
    Mechanism::add_force(const ForceParameters &force)
    {
      const std::string path   = "Force " + force.name;
      const Marker      marker = find_marker(path + "/Marker", force.marker);
      AssertThrow(marker.body != ground_body,
                  ExcParameter(path + "/Marker",
                               "'" + force.marker +
                                 "' belongs to the ground, which does not "
                                 "move; name a marker of a body"));
      for (const auto &[vector, function] : force.parts())
        the_applied_forces.push_back(
          {marker, vector, force.axes == ForceAxes::body, function});
    }



    void
    Mechanism::add_torque(const TorqueParameters &torque)
    {
      const std::string path = "Torque " + torque.name;
      the_applied_torques.push_back(
        {{find_body(path + "/Body", torque.body),
          find_body(path + "/Reference body", torque.reference_body)},
         torque.factor(),
         torque.function()});
    }
  } // namespace Multibody
} // namespace Tribody

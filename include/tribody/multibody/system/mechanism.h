// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_system_mechanism_h
#define tribody_multibody_system_mechanism_h

#include <tribody/multibody/elements/applied_force.h>
#include <tribody/multibody/elements/constraint.h>
#include <tribody/multibody/elements/driver_motion.h>
#include <tribody/multibody/elements/rotational_spring.h>
#include <tribody/multibody/elements/spring.h>
#include <tribody/multibody/joints/clearance_joint.h>
#include <tribody/multibody/joints/impact_joint.h>
#include <tribody/multibody/system/mechanism_parameters.h>

#include <memory>
#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    /// One equation block of the mechanism with its place among all.
    struct NumberedConstraint
    {
      /// What it says and between which bodies.
      std::shared_ptr<const Constraint> constraint;
      /// Its first row in Phi and its first multiplier.
      unsigned int first_row;
    };

    /// A joint by its kind: where to look for it.
    struct JointEntry
    {
      /// As in the parameters.
      std::string name;
      /// Ideal for joints that are not revolute.
      JointModel model;
      /// Index into clearance_joints() with a contact law, otherwise into
      /// constraints(); without meaning for a pin that flies.
      unsigned int index;
      /// Whether pin and bushing turn against each other.
      bool is_revolute;
      /// R_j [m], which turns an angle into a sliding distance.
      double bushing_radius;
      /// First body (pin) and second body (bushing).
      BodyPair bodies;
      /// Its marker in the frame of the first body [m].
      Eigen::Vector2d first_position = Eigen::Vector2d::Zero();
      /// Its marker in the frame of the second body [m].
      Eigen::Vector2d second_position = Eigen::Vector2d::Zero();
      /// Whether the pin has impacts and is between two of them: nothing holds
      /// it.
      bool is_flying = false;
      /// e and c of the models without contact forces; null for others.
      std::shared_ptr<const MasslessLinkConstraint> link = nullptr;

      /// As JointParameters::has_gap().
      bool
      has_gap() const
      {
        return model != JointModel::ideal;
      }

      /// As JointParameters::has_contact_law().
      bool
      has_contact_law() const
      {
        return model == JointModel::clearance;
      }
    };

    /// A driver: what it prescribes, and where its equation is.
    struct DriverEntry
    {
      /// Of the angle [rad] or distance [m].
      DriverMotion motion;
      /// Index into constraints().
      unsigned int constraint;
    };

    /**
     * A planar mechanism: what it consists of and how its coordinates and
     * equations are numbered. Never changes after construction; what moves
     * is in vectors q and v of n_coordinates() entries, (x, y, phi) of each
     * body's centre of mass.
     */
    class Mechanism
    {
    public:
      /// @param is_following as MechanismState::is_following: pins of joints
      ///   with impacts that are held at the bore by a constraint.
      /// @throws ExcParameter for a value or a reference that cannot be used.
      explicit Mechanism(const MechanismParameters &parameters,
                         const std::vector<bool>   &is_following = {});

      /// Entries of q and of v: three per body.
      unsigned int
      n_coordinates() const
      {
        return 3 * the_parameters.bodies.size();
      }

      /// Equations in Phi.
      unsigned int
      n_constraints() const
      {
        return n_equations;
      }

      /**
       * Coordinates minus constraints that do not follow from others. Exact
       * only if these have been counted, of which check_redundancy() makes
       * sure.
       */
      int
      n_degrees_of_freedom() const
      {
        return static_cast<int>(n_coordinates()) -
               static_cast<int>(n_equations) + static_cast<int>(n_redundant());
      }

      /// Equations in Phi that follow from others, as the parameters say. With
      /// them Phi_q has no full rank, and the multipliers are not unique.
      unsigned int
      n_redundant() const
      {
        return the_parameters.n_redundant;
      }

      /// What the mechanism was made from.
      const MechanismParameters &
      parameters() const
      {
        return the_parameters;
      }

      /// Of joints and drivers, each with its rows in Phi.
      const std::vector<NumberedConstraint> &
      constraints() const
      {
        return the_constraints;
      }

      /// The joints with a contact law, in the order of the parameters.
      const std::vector<ClearanceJoint> &
      clearance_joints() const
      {
        return the_clearance_joints;
      }

      /// The joints with impacts, flying or following.
      const std::vector<ImpactJoint> &
      impact_joints() const
      {
        return the_impact_joints;
      }

      /// Whether no joint has_gap(): all are ideal, or not revolute.
      bool
      has_only_ideal_joints() const
      {
        for (const JointEntry &joint : the_joints)
          if (joint.has_gap())
            return false;
        return true;
      }

      /// States of friction laws: one for each that has one.
      unsigned int
      n_friction_states() const
      {
        return n_states;
      }

      /// All joints, in the order of the parameters.
      const std::vector<JointEntry> &
      joints() const
      {
        return the_joints;
      }

      /// In the order of the parameters.
      const std::vector<Spring> &
      springs() const
      {
        return the_springs;
      }

      /// In the order of the parameters.
      const std::vector<DriverEntry> &
      drivers() const
      {
        return the_drivers;
      }

      /// Whether a driver gives the equation constraints()[@p constraint].
      bool
      is_driver(const unsigned int constraint) const;

      /// In the order of the parameters.
      const std::vector<RotationalSpring> &
      rotational_springs() const
      {
        return the_rotational_springs;
      }

      /// In the order of the parameters; two where a table has two components.
      const std::vector<AppliedForce> &
      applied_forces() const
      {
        return the_applied_forces;
      }

      /// In the order of the parameters.
      const std::vector<AppliedTorque> &
      applied_torques() const
      {
        return the_applied_torques;
      }

      /// Diagonal of M: mass, mass, moment of inertia of each body.
      const Eigen::VectorXd &
      masses() const
      {
        return the_masses;
      }

      /// Forces of gravity [N], one entry per coordinate.
      const Eigen::VectorXd &
      weights() const
      {
        return the_weights;
      }

      /// The guess of the configuration at time 0.
      const Eigen::VectorXd &
      initial_coordinates() const
      {
        return the_initial_coordinates;
      }

      /// The velocities at time 0 that are wished for.
      const Eigen::VectorXd &
      initial_velocities() const
      {
        return the_initial_velocities;
      }

      /// A length [m] of the size of the mechanism's bodies.
      double
      size() const
      {
        return the_size;
      }

      /// Whether the first driver turns, so that there is a period().
      bool
      has_turning_driver() const;

      /// Time of one revolution of the first driver [s].
      /// @throws ExcParameter without a driver that turns.
      double
      period() const;

    private:
      int
      find_body(const std::string &path, const std::string &name) const;

      Marker
      find_marker(const std::string &path, const std::string &name) const;

      void
      add_bodies();

      void
      add_joint(const JointParameters   &joint,
                const std::vector<bool> &is_following);

      void
      add_clearance_joint(const JointParameters &joint,
                          const Marker          &pin,
                          const Marker          &bushing);

      // With a massless link, or with impacts.
      void
      add_rigid_clearance(const JointParameters   &joint,
                          const Marker            &pin,
                          const Marker            &bushing,
                          const std::vector<bool> &is_following,
                          JointEntry              &entry);

      void
      add_constraint(const std::shared_ptr<const Constraint> &constraint);

      // A length where no body has a marker off its centre of mass.
      double
      find_distance() const;

      void
      add_spring(const SpringParameters &spring);

      void
      add_rotational_spring(const RotationalSpringParameters &spring);

      void
      add_driver(const DriverParameters &driver);

      void
      add_driver_constraint(
        const DriverMotion                      &motion,
        const std::shared_ptr<const Constraint> &constraint);

      void
      add_force(const ForceParameters &force);

      void
      add_torque(const TorqueParameters &torque);

      const MechanismParameters       the_parameters;
      std::vector<NumberedConstraint> the_constraints;
      std::vector<ClearanceJoint>     the_clearance_joints;
      std::vector<ImpactJoint>        the_impact_joints;
      std::vector<JointEntry>         the_joints;
      std::vector<Spring>             the_springs;
      std::vector<DriverEntry>        the_drivers;
      std::vector<RotationalSpring>   the_rotational_springs;
      std::vector<AppliedForce>       the_applied_forces;
      std::vector<AppliedTorque>      the_applied_torques;
      Eigen::VectorXd                 the_masses;
      Eigen::VectorXd                 the_weights;
      Eigen::VectorXd                 the_initial_coordinates;
      Eigen::VectorXd                 the_initial_velocities;
      unsigned int                    n_equations = 0;
      unsigned int                    n_states    = 0;
      double                          the_size    = 0.;
    };
  } // namespace Multibody
} // namespace Tribody

#endif

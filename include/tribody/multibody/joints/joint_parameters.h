// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_joints_joint_parameters_h
#define tribody_multibody_joints_joint_parameters_h

#include <tribody/base/choice.h>
#include <tribody/material/material.h>
#include <tribody/multibody/joints/contact_force_law.h>
#include <tribody/multibody/joints/friction_law.h>
#include <tribody/surface/pin_in_bore.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  namespace Multibody
  {
    /// What a joint lets its two bodies do; see the constraints of these names.
    enum class JointType
    {
      revolute,
      translational,
      rigid,
      point_on_line
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<JointType>
    choice_names(const JointType)
    {
      return {{JointType::revolute, "revolute"},
              {JointType::translational, "translational"},
              {JointType::rigid, "rigid"},
              {JointType::point_on_line, "point on line"}};
    }

    /// How the pin of a revolute joint is kept in its bushing.
    enum class JointModel
    {
      /// By a constraint on both coordinates.
      ideal,
      /// By contact forces.
      clearance,
      /// By a constraint on its distance from the centre.
      massless_link,
      /// By impacts: it flies between two of them, or follows the bore.
      impact
    };

    /// Their words, see ChoiceNames.
    inline ChoiceNames<JointModel>
    choice_names(const JointModel)
    {
      return {{JointModel::ideal, "ideal"},
              {JointModel::clearance, "clearance"},
              {JointModel::massless_link, "massless link"},
              {JointModel::impact, "impact"}};
    }

    /**
     * A joint between two bodies: revolute (ideal, or with clearance),
     * translational, rigid, or a point on a line. Entries of other types are
     * ignored.
     */
    struct JointParameters
    {
      /// From the title of the subsection; unique among the joints.
      std::string name;
      /// Decides which of the values below count.
      JointType type = JointType::revolute;

      /// Centre of the pin, "<body>.<marker>".
      std::string pin_marker = "ground.O";
      /// Centre of the bushing, "<body>.<marker>".
      std::string bushing_marker = "ground.O";
      /// How the pin is kept in the bushing.
      JointModel model = JointModel::ideal;
      /// Pin radius R_i [m].
      double pin_radius = 9.525e-3;
      /// Bushing radius R_j [m].
      double bushing_radius = 9.535e-3;
      /// Name of the pin's material.
      std::string pin_material_name = "steel";
      /// Name of the bushing's material.
      std::string bushing_material_name = "steel";
      /// The pin's material. Whoever reads the names fills it in.
      Material pin_material;
      /// The bushing's material, likewise.
      Material bushing_material;
      /// Normal force of the model "clearance".
      ContactForceLawChoice contact_force_law =
        ContactForceLawChoice::of<LankaraniNikraveshLaw>();
      /// Of the contact force laws in delta^1.5.
      RadiiCombination radii_combination = RadiiCombination::sum;
      /// How penetration and direction are measured once bore or pin are worn.
      PenetrationMeasure worn_contact_geometry = PenetrationMeasure::deepest;
      /// Stiffness k of the spring-damper [N/m].
      double contact_stiffness = 0.;
      /// Damping b of the spring-damper [N s/m].
      double contact_damping = 0.;
      /// Length L of the elastic foundation along the axis [m].
      double foundation_length = 20e-3;
      /// Its thickness h [m].
      double foundation_thickness = 5e-3;
      /// Its modulus M [Pa]; 0: that of the bushing's material.
      double foundation_modulus = 0.;
      /// Restitution coefficient e_r [-], in (0, 1].
      double restitution_coefficient = 0.8;
      /// Floor of the approach speed at which a contact began [m/s].
      double minimum_approach_speed = 10e-3;
      /// Approach speed [m/s] below which a pin does not bounce any more
      /// (model "impact").
      double capture_speed = 1e-3;
      /// Friction of the model "clearance".
      FrictionLawChoice friction_law =
        FrictionLawChoice::of<RegularisedCoulombFriction>();
      /// Friction coefficient [-].
      double friction_coefficient = 0.15;
      /// Speed v_0 in tanh(v_t/v_0) [m/s].
      double friction_regularisation_speed = 1e-3;
      /// Speed below which there is no friction [m/s] (Ambrosio).
      double friction_lower_speed = 0.1e-3;
      /// Speed above which there is all of it [m/s] (Ambrosio).
      double friction_upper_speed = 1e-3;
      /// Static friction coefficient [-] (Stribeck, LuGre).
      double static_friction_coefficient = 0.2;
      /// Speed v_s over which it falls to friction_coefficient [m/s] (Stribeck,
      /// LuGre).
      double stribeck_speed = 10e-3;
      /// sigma_2 [s/m] (Stribeck, LuGre).
      double viscous_friction = 0.;
      /// sigma_0 [1/m] (LuGre).
      double bristle_stiffness = 1e5;
      /// sigma_1 [s/m] (LuGre).
      double bristle_damping = 10.;
      /// Damping of the pin's sideways swing in the bore [N s/m].
      double tangential_damping = 0.;

      /// First marker of a joint that is not revolute, "<body>.<marker>".
      std::string first_marker = "ground.O";
      /// Second marker of such a joint.
      std::string second_marker = "ground.O";
      /// Translational, point on line: direction in the first body's frame
      /// [rad].
      double axis_angle = 0.;
      /// Translational, rigid: angle of the second body relative to the first
      /// [rad].
      double relative_angle = 0.;

      /// Declares in the current subsection, "Joint <name>".
      void
      add_parameters(dealii::ParameterHandler &prm);

      /// @throws ExcParameter with paths that start with "Joint <name>".
      void
      check() const;

      /// Whether it has a pin and a bushing; entries for other joints do not
      /// count.
      bool
      is_revolute() const
      {
        return type == JointType::revolute;
      }

      /// Whether the pin is smaller than the bore and may be off its centre,
      /// so that the radii matter to the motion.
      bool
      has_gap() const
      {
        return is_revolute() && model != JointModel::ideal;
      }

      /// Whether the pin presses on the bushing by a contact force law; else
      /// both are rigid.
      bool
      has_contact_law() const
      {
        return is_revolute() && model == JointModel::clearance;
      }

      /// c = R_j - R_i [m].
      double
      clearance() const
      {
        return bushing_radius - pin_radius;
      }

      /// Whether the dynamics asks the elastic bushing for its contact force.
      bool
      needs_support() const
      {
        return has_contact_law() && contact_force_law.is<FiniteElementLaw>();
      }
    };
  } // namespace Multibody
} // namespace Tribody

#endif

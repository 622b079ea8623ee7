// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_joints_joint_parameters_h
#define tribody_multibody_joints_joint_parameters_h

#include <tribody/base/material.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  namespace Multibody
  {
    /**
     * A joint between two bodies: revolute (ideal, or with clearance),
     * translational, rigid, or a point on a line. Entries of other types are
     * ignored.
     */
    struct JointParameters
    {
      std::string name;
      /// "revolute", "translational", "rigid" or "point on line".
      std::string type = "revolute";

      /// Centre of the pin, "<body>.<marker>".
      std::string pin_marker = "ground.O";
      /// Centre of the bushing, "<body>.<marker>".
      std::string bushing_marker = "ground.O";
      /// "ideal", "clearance", "massless link" or "impact". IntermittentMotion
      /// also uses "following": "impact" while the pin follows the bore.
      std::string model = "ideal";
      /// Pin radius R_i [m].
      double pin_radius = 9.525e-3;
      /// Bushing radius R_j [m].
      double bushing_radius = 9.535e-3;
      /// Name of the pin's material.
      std::string pin_material_name = "steel";
      /// Name of the bushing's material.
      std::string bushing_material_name = "steel";
      /// The materials themselves. Whoever reads the names fills them in.
      Material pin_material;
      Material bushing_material;
      /// One of contact_force_law_names().
      std::string contact_force_law = "Lankarani-Nikravesh";
      /// "deepest penetration" or "scalar clearance".
      std::string worn_contact_geometry = "deepest penetration";
      /// Stiffness k [N/m] and damping b [N s/m] of the spring-damper.
      double contact_stiffness = 0.;
      double contact_damping   = 0.;
      /// Elastic foundation: length L and thickness h [m], and modulus M [Pa];
      /// 0: that of the bushing's material.
      double foundation_length    = 20e-3;
      double foundation_thickness = 5e-3;
      double foundation_modulus   = 0.;
      /// Restitution coefficient e_r [-], in (0, 1].
      double restitution_coefficient = 0.8;
      /// Floor of the approach speed at which a contact began [m/s].
      double minimum_approach_speed = 10e-3;
      /// Approach speed [m/s] below which a pin does not bounce any more
      /// (model "impact").
      double capture_speed = 1e-3;
      /// One of friction_law_names().
      std::string friction_law = "Coulomb regularised";
      /// Friction coefficient [-].
      double friction_coefficient = 0.15;
      /// Speed v_0 in tanh(v_t/v_0) [m/s].
      double friction_regularisation_speed = 1e-3;
      /// Speeds [m/s] below which there is no friction and above which there
      /// is all of it (Ambrosio).
      double friction_lower_speed = 0.1e-3;
      double friction_upper_speed = 1e-3;
      /// Static friction coefficient [-] and the speed v_s [m/s] over which it
      /// falls (Stribeck, LuGre).
      double static_friction_coefficient = 0.2;
      double stribeck_speed              = 10e-3;
      /// sigma_2 [s/m] (Stribeck, LuGre).
      double viscous_friction = 0.;
      /// sigma_0 [1/m] and sigma_1 [s/m] (LuGre).
      double bristle_stiffness = 1e5;
      double bristle_damping   = 10.;
      /// Damping of the pin's sideways swing in the bore [N s/m].
      double tangential_damping = 0.;

      /// Markers of a joint that is not revolute, "<body>.<marker>".
      std::string first_marker  = "ground.O";
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

      bool
      is_revolute() const
      {
        return type == "revolute";
      }

      bool
      has_clearance() const
      {
        return is_revolute() && model == "clearance";
      }

      /// Whether the dynamics asks the elastic bushing for its contact force.
      bool
      needs_support() const
      {
        return has_clearance() && contact_force_law == "finite element";
      }

      /// Whether the radii of pin and bushing matter to the motion.
      bool
      has_gap() const
      {
        return is_revolute() && model != "ideal";
      }
    };
  } // namespace Multibody
} // namespace Tribody

#endif

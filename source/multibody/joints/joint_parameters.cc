// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/parameters.h>
#include <tribody/multibody/joints/joint_parameters.h>

namespace Tribody
{
  namespace Multibody
  {
    namespace
    {
      // One function per group of entries, in the order of the manual.
      void
      add_markers_and_radii(dealii::ParameterHandler &prm, JointParameters &p)
      {
        Parameters::add_text(prm,
                             "Pin marker",
                             p.pin_marker,
                             "Revolute joint: centre of the pin, "
                             "'<body>.<marker>'.");
        Parameters::add_text(prm,
                             "Bushing marker",
                             p.bushing_marker,
                             "Revolute joint: centre of the bushing, "
                             "'<body>.<marker>'. Angles of contact and wear "
                             "are counted in this body's frame.");
        Parameters::add_choice(
          prm,
          "Model",
          p.model,
          "Revolute joint: 'ideal' keeps the two centres together; with "
          "'clearance' the pin moves freely in the bushing until it touches "
          "it, and contact and friction forces act then. The others are rigid "
          "and for comparison; they cannot wear a bushing. 'massless link' "
          "keeps the centres at the distance of the clearance, without "
          "friction, and the reaction is the force along that link. 'impact': "
          "the pin flies freely; where it hits the bore, the velocities jump "
          "by momentum balance with the restitution coefficient (and the "
          "friction coefficient unless the friction law is 'none'); when it "
          "hits more slowly than the capture speed, it follows the bore, "
          "without friction, until the force would pull.");
        Parameters::add_quantity(
          prm, "Pin radius", p.pin_radius, "m", "Radius R_i of the pin.", "mm");
        Parameters::add_quantity(prm,
                                 "Bushing radius",
                                 p.bushing_radius,
                                 "m",
                                 "Radius R_j of the bore. The clearance is "
                                 "R_j - R_i.",
                                 "mm");
        Parameters::add_text(prm,
                             "Pin material",
                             p.pin_material_name,
                             "Name of the pin's material.");
        Parameters::add_text(prm,
                             "Bushing material",
                             p.bushing_material_name,
                             "Name of the bushing's material.");
      }



      void
      add_contact_law(dealii::ParameterHandler &prm, JointParameters &p)
      {
        Parameters::add_choice(
          prm,
          "Contact force law",
          p.contact_force_law,
          "Normal force in contact; delta is the penetration, delta'_minus the "
          "approach speed at which the contact began. 'Hertz': F_N = K "
          "delta^1.5. 'Lankarani-Nikravesh', 'Hunt-Crossley' and 'Flores': the "
          "same times 1 + d delta'/delta'_minus, which takes energy out of an "
          "impact, with d = 3/4 (1 - e_r^2), d = 3/2 (1 - e_r) and d = 8/5 (1 "
          "- e_r)/e_r; the last one is made for any e_r, the others for e_r "
          "near 1. 'spring-damper': F_N = k delta + b delta' >= 0. 'elastic "
          "foundation': the bore is lined with springs (Winkler), p = M/h "
          "times the indentation, integrated over the arc of contact; its "
          "losses are those of Lankarani and Nikravesh. 'finite element': the "
          "contact of the pin with the elastic, worn bushing itself, which the "
          "joint's entry in 'Bushings' describes, solved at every step of the "
          "integration, times 1 + 3/4 (1 - e_r^2) delta'/delta'_minus; forces "
          "of the dynamics and pressures of the wear are one model then.");
        Parameters::add_choice(
          prm,
          "Radii of contact stiffness",
          p.radii_combination,
          "What R is in the constant K of 'Hertz', 'Lankarani-Nikravesh', "
          "'Hunt-Crossley' and 'Flores', K = 4/(3 (h_i + h_j)) sqrt(R_i R_j/R) "
          "with h = (1 - nu^2)/E of pin and bushing. 'sum': R = R_i + R_j, as "
          "printed in Mukras et al. (2010), eq. 10, whose results it "
          "reproduces. 'difference': R = R_j - R_i, the radius of the bore "
          "counted negative, as Lankarani and Nikravesh and Flores have it for "
          "a pin in a bore; K is larger by sqrt((R_j + R_i)/(R_j - R_i)), 6 "
          "times for a clearance of 5 % of the radius. Both are of spheres; "
          "'elastic foundation' and 'finite element' know the length of the "
          "joint. K is printed, and in summary.json in N/m^1.5.");
        Parameters::add_choice(
          prm,
          "Worn contact geometry",
          p.worn_contact_geometry,
          "What delta and the direction of contact are in a worn joint. "
          "'deepest penetration': the deepest overlap of the pin with the worn "
          "bore and the normal there. 'scalar clearance': the clearance c in "
          "the direction of the pin's eccentricity e, delta = |e| - c, and "
          "that direction (eq. 28 of Mukras et al., 2010). As long as pin and "
          "bore are round they are the same.");
      }



      void
      add_contact_constants(dealii::ParameterHandler &prm, JointParameters &p)
      {
        Parameters::add_quantity(
          prm,
          "Restitution coefficient",
          p.restitution_coefficient,
          "",
          "e_r of all laws with losses but 'spring-damper', between 0 and 1 "
          "(no loss), and of the model 'impact', which takes it as it is. "
          "Otherwise it is the laws' parameter: for values below 0.9 a free "
          "impact leaves noticeably faster than e_r says; under 'Flores' it "
          "leaves at e_r within 0.05.");
        Parameters::add_quantity(prm,
                                 "Contact stiffness",
                                 p.contact_stiffness,
                                 "N/m",
                                 "k of 'spring-damper', which requires it.");
        Parameters::add_quantity(
          prm,
          "Contact damping",
          p.contact_damping,
          "N s/m",
          "b of 'spring-damper'. A mass m leaves an impact with exp(-2 zeta "
          "acos(zeta)/sqrt(1 - zeta^2)) of its speed, zeta = b/(2 sqrt(k m)).");
        Parameters::add_quantity(
          prm,
          "Foundation length",
          p.foundation_length,
          "m",
          "L of 'elastic foundation': the joint's length along its axis.",
          "mm");
        Parameters::add_quantity(
          prm,
          "Foundation thickness",
          p.foundation_thickness,
          "m",
          "h of 'elastic foundation': thickness of the layer, above 0.",
          "mm");
        Parameters::add_quantity(
          prm,
          "Foundation modulus",
          p.foundation_modulus,
          "Pa",
          "M of 'elastic foundation'. 0 takes that of a thin layer of the "
          "bushing's material which is bonded to its back, (1 - nu) E/((1 + "
          "nu) (1 - 2 nu)).",
          "GPa");
      }



      void
      add_approach_speeds(dealii::ParameterHandler &prm, JointParameters &p)
      {
        Parameters::add_quantity(
          prm,
          "Capture speed",
          p.capture_speed,
          "m/s",
          "Model 'impact': approach speed below which the pin does not bounce "
          "any more but follows the bore. Without it the impacts, each weaker "
          "than the one before, would have no end.",
          "mm/s");
        Parameters::add_quantity(
          prm,
          "Minimum approach speed",
          p.minimum_approach_speed,
          "m/s",
          "Floor of delta'_minus. It is also its value for a motion that "
          "starts in contact. Without a floor a contact that begins gently "
          "would be damped without bound.",
          "mm/s");
      }



      void
      add_friction(dealii::ParameterHandler &prm, JointParameters &p)
      {
        Parameters::add_choice(
          prm,
          "Friction law",
          p.friction_law,
          "Friction F_mu against the sliding v_t of the two surfaces at the "
          "contact. 'Coulomb regularised': mu F_N tanh(v_t/v_0). 'Ambrosio': "
          "none below the lower speed, mu F_N above the upper one, linear in "
          "between. 'Stribeck': g tanh(v_t/v_0) + sigma_2 v_t, times F_N, with "
          "g = mu + (mu_s - mu) exp(-(v_t/v_s)^2). 'LuGre': sigma_0 z + "
          "sigma_1 z' + sigma_2 v_t, times F_N, with bristles that bend by z "
          "and slip, z' = v_t - sigma_0 |v_t|/g z; a new contact begins with "
          "z = 0.");
        Parameters::add_quantity(
          prm,
          "Friction coefficient",
          p.friction_coefficient,
          "",
          "mu of all friction laws (kinetic, where there is a static one), and "
          "of the model 'impact'.");
        Parameters::add_quantity(prm,
                                 "Friction regularisation speed",
                                 p.friction_regularisation_speed,
                                 "m/s",
                                 "v_0 of 'Coulomb regularised' and "
                                 "'Stribeck': below this sliding speed "
                                 "friction falls to zero smoothly.",
                                 "mm/s");
        Parameters::add_quantity(
          prm,
          "Tangential damping",
          p.tangential_damping,
          "N s/m",
          "Damping of the pin's sideways swing in the bore while it is in "
          "contact. The contact laws damp the normal direction only.");
      }



      void
      add_further_friction(dealii::ParameterHandler &prm, JointParameters &p)
      {
        Parameters::add_quantity(prm,
                                 "Friction lower speed",
                                 p.friction_lower_speed,
                                 "m/s",
                                 "'Ambrosio': no friction below it.",
                                 "mm/s");
        Parameters::add_quantity(prm,
                                 "Friction upper speed",
                                 p.friction_upper_speed,
                                 "m/s",
                                 "'Ambrosio': full friction above it.",
                                 "mm/s");
        Parameters::add_quantity(
          prm,
          "Static friction coefficient",
          p.static_friction_coefficient,
          "",
          "mu_s of 'Stribeck' and 'LuGre', at least the friction coefficient.");
        Parameters::add_quantity(prm,
                                 "Stribeck speed",
                                 p.stribeck_speed,
                                 "m/s",
                                 "v_s of 'Stribeck' and 'LuGre': over about "
                                 "this sliding speed friction falls from "
                                 "mu_s to mu.",
                                 "mm/s");
        Parameters::add_quantity(prm,
                                 "Viscous friction",
                                 p.viscous_friction,
                                 "s/m",
                                 "sigma_2 of 'Stribeck' and 'LuGre', per "
                                 "normal force.");
        Parameters::add_quantity(
          prm,
          "Bristle stiffness",
          p.bristle_stiffness,
          "m^-1",
          "sigma_0 of 'LuGre', per normal force: friction builds up over a "
          "displacement of about mu/sigma_0.");
        Parameters::add_quantity(prm,
                                 "Bristle damping",
                                 p.bristle_damping,
                                 "s/m",
                                 "sigma_1 of 'LuGre', per normal force.");
      }



      void
      add_other_types(dealii::ParameterHandler &prm, JointParameters &p)
      {
        Parameters::add_text(prm,
                             "First marker",
                             p.first_marker,
                             "Other joints than revolute: '<body>.<marker>'; a "
                             "point of the axis, if there is one.");
        Parameters::add_text(prm,
                             "Second marker",
                             p.second_marker,
                             "Other joints than revolute: the point that stays "
                             "on the axis of the first body, or of a rigid "
                             "joint where the first marker is, "
                             "'<body>.<marker>'.");
        Parameters::add_quantity(prm,
                                 "Axis",
                                 p.axis_angle,
                                 "rad",
                                 "Translational joint and point on line: "
                                 "direction of the axis in the first body's "
                                 "frame.",
                                 "deg");
        Parameters::add_quantity(prm,
                                 "Relative angle",
                                 p.relative_angle,
                                 "rad",
                                 "Translational and rigid joint: angle of the "
                                 "second body relative to the first, which "
                                 "stays the same.",
                                 "deg");
      }
    } // namespace



    void
    JointParameters::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_choice(prm,
                             "Type",
                             type,
                             "'revolute': a pin turns in a bushing. "
                             "'translational': a body slides along an axis of "
                             "another one without turning. 'rigid': two bodies "
                             "are welded together. 'point on line': a point of "
                             "a body slides along an axis of another one, and "
                             "both may turn. Entries that belong to other "
                             "types are ignored.");
      add_markers_and_radii(prm, *this);
      add_contact_law(prm, *this);
      add_contact_constants(prm, *this);
      add_approach_speeds(prm, *this);
      add_friction(prm, *this);
      add_further_friction(prm, *this);
      add_other_types(prm, *this);
    }
  } // namespace Multibody
} // namespace Tribody

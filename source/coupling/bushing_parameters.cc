#include <deal.II/base/parameter_handler.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/coupling/bushing_parameters.h>
#include <tribody/multibody/joint_parameters.h>

namespace Tribody
{
  namespace Coupling
  {
    void
    BushingParameters::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_quantity(prm,
                               "Axial length",
                               axial_length,
                               "m",
                               "Length of the bushing along the axis of the "
                               "joint, positive.",
                               "mm");
      Parameters::add_quantity(prm,
                               "Outer radius",
                               outer_radius,
                               "m",
                               "Radius of the rim, which is held without "
                               "moving; larger than the joint's bushing "
                               "radius.",
                               "mm");
      Parameters::add_choice(
        prm,
        "Plane state",
        plane_state,
        {"plane strain", "plane stress"},
        "Plane strain for a bushing that is long, or held, "
        "along its axis; plane stress for a thin one.");
      Parameters::add_choice(
        prm,
        "Pressure model",
        pressure_model,
        {"finite element", "infinite plate", "Winkler layer"},
        "How the bushing gives way to the pin: 'finite element' is the meshed "
        "ring; 'infinite plate' the hole in a plate without an end (with an "
        "elastic pin of the same material: Persson's closed form), in which "
        "the outer radius only concerns the pin's place; 'Winkler layer' a "
        "layer as thick as the wall that yields to the pressure of each place "
        "alone, u = p t (1+nu)(1-2nu)/(E(1-nu)) in plane strain. The last two "
        "are there to be compared with; everything else, and the stresses in "
        "the VTU files, is computed as ever.");
      Parameters::add_choice(
        prm,
        "Pin",
        pin,
        {"automatic", "rigid", "elastic"},
        "Whether the pin deforms in the contact: 'elastic' gives it the "
        "elasticity of a disc of the joint's pin material; 'automatic' does so "
        "unless its Young's modulus is more than 100 times the bushing's, and "
        "the log says which. The pin's place is then the mean place of its "
        "cross section.");
      Parameters::add_quantity(prm,
                               "Pin hole radius",
                               pin_hole_radius,
                               "m",
                               "Radius of the hole in a hollow pin, free of "
                               "forces; 0: a solid pin. It matters if the pin "
                               "is elastic.",
                               "mm");
      Parameters::add_integer(prm,
                              "Element degree",
                              element_degree,
                              "Polynomial degree of displacement and "
                              "geometry.",
                              1,
                              3);
      Parameters::add_quantity(prm,
                               "Wear coefficient",
                               wear_coefficient,
                               "Pa^-1",
                               "Archard's k: worn volume per normal force and "
                               "sliding distance, not negative.",
                               "mm^3/(N m)");
      Parameters::add_quantity(prm,
                               "Stop at maximum depth",
                               limits.max_depth,
                               "m",
                               "The run ends when the wear is this deep "
                               "somewhere; 0: never.",
                               "mm");
      Parameters::add_quantity(prm,
                               "Stop at clearance",
                               limits.clearance,
                               "m",
                               "The run ends when the clearance between pin "
                               "and worn bore has this value somewhere; 0: "
                               "never.",
                               "mm");
      Parameters::add_quantity(prm,
                               "Stop at worn volume",
                               limits.volume,
                               "m^3",
                               "The run ends when this volume is worn away; "
                               "0: never.",
                               "mm^3");
      Parameters::add_quantity(prm,
                               "Stop at worn mass",
                               limits.mass,
                               "kg",
                               "The run ends when this mass is worn away; 0: "
                               "never.",
                               "g");
      Parameters::add_text(prm,
                           "Comparison source",
                           comparison.source,
                           "Where the two comparison values come from and what "
                           "they are worth. They are shown beside the result "
                           "and used for nothing else; empty: none.");
      Parameters::add_quantity(prm,
                               "Comparison maximum depth",
                               comparison.max_wear_depth,
                               "m",
                               "A maximum wear depth to show beside the "
                               "result; 0: none.",
                               "mm");
      Parameters::add_quantity(prm,
                               "Comparison worn mass",
                               comparison.worn_mass,
                               "kg",
                               "A worn mass to show beside the result; 0: "
                               "none.",
                               "g");
      prm.enter_subsection("Mesh");
      mesh.add_parameters(prm);
      prm.leave_subsection();
      prm.enter_subsection("Contact solver");
      contact_solver.add_parameters(prm);
      prm.leave_subsection();
    }



    void
    BushingParameters::check(const Multibody::JointParameters &joint) const
    {
      const std::string path = "Bushing " + name + "/";
      AssertThrow(axial_length > 0.,
                  ExcParameter(path + "Axial length",
                               Units::to_string(axial_length, "m", "mm") +
                                 " must be positive"));
      AssertThrow(
        outer_radius > joint.bushing_radius,
        ExcParameter(path + "Outer radius",
                     Units::to_string(outer_radius, "m", "mm") +
                       " must be larger than the bushing radius of "
                       "the joint, " +
                       Units::to_string(joint.bushing_radius, "m", "mm")));
      AssertThrow(
        pin_hole_radius >= 0. && pin_hole_radius < joint.pin_radius,
        ExcParameter(path + "Pin hole radius",
                     Units::to_string(pin_hole_radius, "m", "mm") +
                       " is not between 0 and the pin radius of the "
                       "joint, " +
                       Units::to_string(joint.pin_radius, "m", "mm")));
      AssertThrow(
        wear_coefficient >= 0.,
        ExcParameter(path + "Wear coefficient",
                     Units::to_string(wear_coefficient, "Pa^-1", "mm^3/(N m)") +
                       " must not be negative"));
      for (const auto &[limit, name_of_limit] :
           {std::make_pair(limits.max_depth, "Stop at maximum depth"),
            std::make_pair(limits.clearance, "Stop at clearance"),
            std::make_pair(limits.volume, "Stop at worn volume"),
            std::make_pair(limits.mass, "Stop at worn mass")})
        AssertThrow(limit >= 0.,
                    ExcParameter(path + name_of_limit,
                                 "must not be negative; 0 means no limit"));
      mesh.check(path + "Mesh");
      contact_solver.check(path + "Contact solver");
    }



    bool
    BushingParameters::pin_is_elastic(
      const Multibody::JointParameters &joint) const
    {
      return pin == "elastic" ||
             (pin == "automatic" &&
              joint.pin_material.youngs_modulus <=
                100. * joint.bushing_material.youngs_modulus);
    }
  } // namespace Coupling
} // namespace Tribody

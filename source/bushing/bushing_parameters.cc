// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/tria.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/parameters.h>
#include <tribody/base/units.h>
#include <tribody/bushing/bushing_mesh.h>
#include <tribody/bushing/bushing_parameters.h>
#include <tribody/multibody/joints/joint_parameters.h>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      // One function per group of entries, in the order of the manual.
      void
      add_ring(dealii::ParameterHandler &prm, BushingParameters &p)
      {
        Parameters::add_quantity(prm,
                                 "Axial length",
                                 p.axial_length,
                                 "m",
                                 "Length of the bushing along the axis of the "
                                 "joint, positive.",
                                 "mm");
        Parameters::add_quantity(prm,
                                 "Outer radius",
                                 p.outer_radius,
                                 "m",
                                 "Radius of the rim, larger than the joint's "
                                 "bushing radius, at most 1000 times as "
                                 "large.",
                                 "mm");
        p.rim_shape.add_parameters(prm);
        p.rim_support.add_parameters(prm);
        Parameters::add_choice(
          prm,
          "Plane state",
          p.plane_state,
          "Plane strain for a bushing that is long, or held, "
          "along its axis; plane stress for a thin one.");
        Parameters::add_choice(
          prm,
          "Pressure model",
          p.pressure_model,
          "How the bushing gives way to the pin: 'finite element' is the "
          "meshed "
          "ring; 'infinite plate' the hole in a plate without an end (with an "
          "elastic pin of the same material: Persson's closed form), in which "
          "the outer radius only concerns the pin's place; 'Winkler layer' a "
          "layer as thick as the wall that yields to the pressure of each "
          "place "
          "alone, u = p t (1+nu)(1-2nu)/(E(1-nu)) in plane strain. The last "
          "two "
          "are there to be compared with; everything else, and the stresses in "
          "the VTU files, is computed as ever.");
      }



      void
      add_pin(dealii::ParameterHandler &prm, BushingParameters &p)
      {
        Parameters::add_choice(
          prm,
          "Pin",
          p.pin,
          "Whether the pin deforms in the contact: 'elastic' gives it the "
          "elasticity of a disc of the joint's pin material; 'automatic' does "
          "so "
          "unless its Young's modulus is more than 100 times the bushing's, "
          "and "
          "the log says which. The pin's place is then the mean place of its "
          "cross section.");
        Parameters::add_quantity(
          prm,
          "Pin hole radius",
          p.pin_hole_radius,
          "m",
          "Radius of the hole in a hollow pin, free of "
          "forces; 0: a solid pin. It matters if the pin "
          "is elastic.",
          "mm");
      }



      void
      add_elements(dealii::ParameterHandler &prm, BushingParameters &p)
      {
        Parameters::add_integer(prm,
                                "Element degree",
                                p.element_degree,
                                "Polynomial degree of displacement and "
                                "geometry.",
                                1,
                                3);
        Parameters::add_choice(
          prm,
          "Stiffness solver",
          p.stiffness_solver,
          "How displacements are found from forces. 'direct': every rank has "
          "the "
          "whole mesh and factorises its stiffness, the fastest as long as "
          "that "
          "fits its memory. 'multigrid': the ranks share the cells, and "
          "conjugate gradients with algebraic multigrid find every "
          "displacement "
          "to 1e-12 of the force. A ring is shared best if powers of two "
          "divide "
          "its bore cells and radial cells; cells of a refined sector stay on "
          "the rank that had them. The coarser mesh of 'Wear/Mesh error "
          "estimate' is solved directly, and so is what 'Mesh/Nodes across "
          "contact' looks at: every rank has all of it.");
      }



      // As Parameters::add_quantity(), with the spellings of data sheets.
      void
      add_wear_coefficient(dealii::ParameterHandler &prm,
                           const std::string        &name,
                           double                   &value,
                           const std::string        &documentation)
      {
        prm.declare_entry(name,
                          Units::to_string(value, "Pa^-1", "mm^3/(N m)"),
                          dealii::Patterns::Anything(),
                          documentation);
        prm.add_action(name, [&value](const std::string &text) {
          value = Wear::coefficient_from_string(text);
        });
      }



      void
      add_wear(dealii::ParameterHandler &prm, BushingParameters &p)
      {
        add_wear_coefficient(
          prm,
          "Wear coefficient",
          p.wear_coefficient,
          "Archard's k of the bushing, not negative: local wear depth per "
          "contact pressure and sliding distance, dh = k p ds at each place "
          "of the bore. The worn volume is k F s where the contact is narrow, "
          "and more where it is wide, since pressures that point to both "
          "sides do not add up to the force F: up to 4/pi = 1.27 times for a "
          "worn-in contact over half the bore. The results show both. Read as "
          "data sheets spell it: '5e-4 mm^3/(N m)', '5e-4 mm3/Nm', '26 x 1e-8 "
          "mm3/Nm', '13e-10 in3 min/(ft lb hr)' (lb is a force), '2 um/km at 1 "
          "MPa' (a depth per distance at a pressure).");
        Parameters::add_text(
          prm,
          "Wear coefficient table",
          p.wear_coefficient_table,
          "File with k(p, v, T) of the bushing instead of the 'Wear "
          "coefficient', relative to this one; empty: none. CSV with the "
          "header 'pressure [MPa], speed [m/s], temperature [degC], wear "
          "coefficient [mm^3/(N m)]', in any units of UDUNITS-2: each local "
          "pressure with each speed and temperature, rising, or one or two of "
          "the three columns. Linear between, constant beyond them.");
        Parameters::add_choice(
          prm,
          "Wear coefficient basis",
          p.wear_coefficient_basis,
          "What the 'Wear coefficient' was measured as. 'local': depth per "
          "local pressure and distance, as k above; so are coefficients of "
          "flat specimens. 'projected pressure': depth of a worn-in bushing "
          "per F/(2 R L) and distance. 'bushing volume': volume of a worn-in "
          "bushing per F and distance. The last two are 4/pi as large as k, "
          "and are divided by it.");
        add_wear_coefficient(
          prm,
          "Pin wear coefficient",
          p.pin_wear_coefficient,
          "Archard's k of the pin, local as that of the bushing and spelt "
          "alike, not negative; 0: the pin does not wear. The pin wears in "
          "its own frame, which turns in the bushing.");
        Parameters::add_text(
          prm,
          "Wear coefficient factor",
          p.wear_coefficient_factor,
          "What the wear coefficient of the bushing is multiplied by: a number "
          "or an expression of the contact pressure p in Pa, the sliding speed "
          "v in m/s, the distance s in m that the joint has slid before, and "
          "the temperature T in K of the contact, which 'Heat' computes; for "
          "example '(p/1e6)^0.5' or 'exp((T - 293.15)/40)'. Not negative, and "
          "smooth in p.");
        Parameters::add_text(prm,
                             "Pin wear coefficient factor",
                             p.pin_wear_coefficient_factor,
                             "The same for the wear coefficient of the pin.");
        Parameters::add_quantity(
          prm,
          "Running-in factor",
          p.running_in_factor,
          "",
          "f_0: how many times as fast fresh surfaces wear. The wear "
          "coefficients of bushing and pin are multiplied by 1 + (f_0 - 1) "
          "exp(-s/s_0) with the distance s that the joint has slid before. Not "
          "negative; 1: no running-in.");
        Parameters::add_quantity(prm,
                                 "Running-in distance",
                                 p.running_in_distance,
                                 "m",
                                 "s_0: sliding distance over which running-in "
                                 "fades; 0: no running-in.");
      }



      void
      add_limits(dealii::ParameterHandler &prm, BushingParameters &p)
      {
        for (std::size_t i = 0; i < p.limits.size(); ++i)
          {
            const JointLimit &limit = joint_limits()[i];
            Parameters::add_quantity(prm,
                                     limit.parameter(),
                                     p.limits[i],
                                     limit.si_unit,
                                     limit.documentation,
                                     limit.shown_unit);
          }
      }



      void
      add_comparison(dealii::ParameterHandler &prm, BushingParameters &p)
      {
        Parameters::add_text(
          prm,
          "Comparison source",
          p.comparison.source,
          "Where the two comparison values come from and what "
          "they are worth. They are shown beside the result "
          "and used for nothing else; empty: none.");
        Parameters::add_quantity(prm,
                                 "Comparison maximum depth",
                                 p.comparison.max_wear_depth,
                                 "m",
                                 "A maximum wear depth to show beside the "
                                 "result; 0: none.",
                                 "mm");
        Parameters::add_quantity(prm,
                                 "Comparison worn mass",
                                 p.comparison.worn_mass,
                                 "kg",
                                 "A worn mass to show beside the result; 0: "
                                 "none.",
                                 "g");
      }
    } // namespace



    void
    BushingParameters::add_parameters(dealii::ParameterHandler &prm)
    {
      Parameters::add_text(
        prm,
        "Duty cycle file",
        duty_cycle_file,
        "A table (CSV) of the loads over a cycle, from a rig or another "
        "program; then there is no mechanism, and the forces do not follow the "
        "wear. Columns with units: 'time', 'force_x' and 'force_y' of the pin "
        "on the bushing in the bushing's axes, or 'force' and 'force_angle', "
        "and 'pin_angle', that of the pin in the bushing; or a duty cycle of "
        "this program. Relative to the directory of the parameter file.");
      add_ring(prm, *this);
      add_pin(prm, *this);
      add_elements(prm, *this);
      add_wear(prm, *this);
      add_limits(prm, *this);
      add_comparison(prm, *this);
      prm.enter_subsection("Heat");
      heat.add_parameters(prm);
      prm.leave_subsection();
      prm.enter_subsection("Mesh");
      mesh.add_parameters(prm);
      mesh_file.add_parameters(prm);
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
        pin_hole_radius >= 0. && pin_hole_radius < joint.pin_radius,
        ExcParameter(path + "Pin hole radius",
                     Units::to_string(pin_hole_radius, "m", "mm") +
                       " is not between 0 and the pin radius of the "
                       "joint, " +
                       Units::to_string(joint.pin_radius, "m", "mm")));
      for (const auto &[k, name_of_k] :
           {std::make_pair(wear_coefficient, "Wear coefficient"),
            std::make_pair(pin_wear_coefficient, "Pin wear coefficient")})
        AssertThrow(k >= 0.,
                    ExcParameter(path + name_of_k,
                                 Units::to_string(k, "Pa^-1", "mm^3/(N m)") +
                                   " must not be negative"));
      AssertThrow(running_in_factor >= 0.,
                  ExcParameter(path + "Running-in factor",
                               Units::to_string(running_in_factor, "", "") +
                                 " must not be negative; 1 means no "
                                 "running-in"));
      AssertThrow(running_in_distance >= 0.,
                  ExcParameter(path + "Running-in distance",
                               Units::to_string(running_in_distance, "m", "m") +
                                 " must not be negative; 0 means no "
                                 "running-in"));
      AssertThrow(running_in_factor == 1. || running_in_distance > 0.,
                  ExcParameter(path + "Running-in distance",
                               "must be given and positive: 'Running-in "
                               "factor' is " +
                                 Units::to_string(running_in_factor, "", "") +
                                 " and not 1"));
      check_table();
      // They name the parameter if it cannot be understood.
      wear_law();
      pin_wear_law();
      check_limits(joint);
      check_heat(joint);
      rim_support.check("Bushing " + name);
      check_housing(joint);
      mesh.check(path + "Mesh");
      check_mesh(joint);
      contact_solver.check(path + "Contact solver");
    }



    void
    BushingParameters::check_table() const
    {
      if (wear_coefficient_table.empty())
        return;
      AssertThrow(wear_coefficient == 0.,
                  ExcParameter("Bushing " + name + "/Wear coefficient table",
                               "the table and 'Wear coefficient', which is " +
                                 Units::to_string(wear_coefficient,
                                                  "Pa^-1",
                                                  "mm^3/(N m)") +
                                 ", exclude each other; leave one of them out, "
                                 "or set the coefficient to 0"));
      AssertThrow(wear_coefficient_basis == Wear::CoefficientBasis::local,
                  ExcParameter("Bushing " + name + "/Wear coefficient basis",
                               "a table has Archard's k over the local "
                               "pressure, so that the basis is 'local', not '" +
                                 name_of(wear_coefficient_basis) + "'"));
    }



    void
    BushingParameters::check_limits(
      const Multibody::JointParameters &joint) const
    {
      for (std::size_t i = 0; i < limits.size(); ++i)
        {
          const JointLimit &limit  = joint_limits()[i];
          const double      unworn = limit.unworn_value(joint);
          AssertThrow(limits[i] >= 0.,
                      ExcParameter("Bushing " + name + "/" + limit.parameter(),
                                   "must not be negative; 0 means no limit"));
          AssertThrow(
            limits[i] == 0. || limits[i] > unworn,
            ExcParameter(
              "Bushing " + name + "/" + limit.parameter(),
              Units::to_string(limits[i], limit.si_unit, limit.shown_unit) +
                " is passed before any wear: the " + limit.quantity +
                " of the new joint is " +
                Units::to_string(unworn, limit.si_unit, limit.shown_unit, 6) +
                ". Set a larger limit, or 0 for none"));
        }
    }



    void
    BushingParameters::check_heat(const Multibody::JointParameters &joint) const
    {
      const std::string path = "Bushing " + name;
      heat.check(path + "/Heat", joint.bushing_material);
      if (heat.is_on())
        {
          AssertThrow(name_of(joint.friction_law) != "none",
                      ExcParameter(path + "/Heat/Temperature",
                                   "is 'steady', but 'Joint " + name +
                                     "/Friction law' is 'none': without "
                                     "friction there is no heat"));
          AssertThrow(joint.friction_coefficient > 0.,
                      ExcParameter(path + "/Heat/Temperature",
                                   "is 'steady', but 'Joint " + name +
                                     "/Friction coefficient' is 0: without "
                                     "friction there is no heat"));
          AssertThrow(!shares_mesh(),
                      ExcParameter(path + "/Heat/Temperature",
                                   "'steady' needs 'Stiffness solver = "
                                   "direct', but it is '" +
                                     name_of(stiffness_solver) + "'"));
          AssertThrow(
            !rim_support.is_housing() ||
              joint.bushing_material.thermal_expansion == 0.,
            ExcParameter(path + "/Heat/Temperature",
                         "the expansion of a ring that lies in a 'housing' "
                         "with a gap is not computed; choose another 'Outer "
                         "support', or set 'Thermal expansion' of the material "
                         "'" +
                           joint.bushing_material.name + "' to 0"));
          return;
        }
      const auto check_factor = [&](const bool         depends,
                                    const std::string &entry) {
        AssertThrow(!depends,
                    ExcParameter(path + "/" + entry,
                                 "depends on the temperature, which nobody "
                                 "computes; write 'set Temperature = steady' "
                                 "in the subsection 'Heat' of the bushing"));
      };
      const std::string of_bushing = "Wear coefficient factor",
                        of_pin     = "Pin wear coefficient factor";
      check_factor(make_wear_law(1., wear_coefficient_factor, of_bushing)
                     .depends_on_temperature(),
                   of_bushing);
      check_factor(pin_wear_law().depends_on_temperature(), of_pin);
      check_factor(wear_law().depends_on_temperature(),
                   "Wear coefficient table");
    }



    void
    BushingParameters::check_housing(
      const Multibody::JointParameters &joint) const
    {
      if (!rim_support.is_housing())
        return;
      const std::string parameter = "Bushing " + name + "/Outer support";
      AssertThrow(
        !mesh_file.is_given() && rim_shape.is_concentric_circle(),
        ExcParameter(parameter,
                     "'housing' needs a rim that is a circle around "
                     "the bore, without 'Outer centre', 'Outer shape' "
                     "or a mesh file"));
      AssertThrow(pressure_model == PressureModel::finite_element,
                  ExcParameter(parameter,
                               "'housing' needs 'Pressure model = finite "
                               "element', but it is '" +
                                 name_of(pressure_model) +
                                 "', which knows nothing of the rim"));
      AssertThrow(stiffness_solver == StiffnessSolver::direct,
                  ExcParameter(parameter,
                               "'housing' needs 'Stiffness solver = direct', "
                               "but it is '" +
                                 name_of(stiffness_solver) + "'"));
      AssertThrow(!joint.needs_support(),
                  ExcParameter(parameter,
                               "'housing' cannot be combined with the contact "
                               "force law 'finite element' of the joint or "
                               "'Wear/Scheme = coupled': without a force on "
                               "it, the place of the ring in its housing is "
                               "not known"));
    }



    void
    BushingParameters::check_mesh(const Multibody::JointParameters &joint) const
    {
      if (!mesh_file.is_given())
        {
          AssertThrow(
            outer_radius > joint.bushing_radius,
            ExcParameter("Bushing " + name + "/Outer radius",
                         Units::to_string(outer_radius, "m", "mm") +
                           " must be larger than the bushing radius of "
                           "the joint, " +
                           Units::to_string(joint.bushing_radius, "m", "mm")));
          rim_shape.check("Bushing " + name,
                          joint.bushing_radius,
                          outer_radius);
        }
      AssertThrow(!mesh_file.is_given() || mesh.n_contact_nodes == 0,
                  ExcParameter("Bushing " + name + "/Mesh/Nodes across contact",
                               "the cells of a mesh file are what they are; "
                               "divide them by 'File refinements' or 'Sector "
                               "refinements'"));
      // A file must be read to know whether it is one, a sector be refined to
      // know whether there is anything in it.
      if (mesh_file.is_given() || mesh.n_sector_refinements > 0)
        make_bushing_mesh(*this, joint.bushing_radius);
    }



    Wear::WearLaw
    BushingParameters::wear_law() const
    {
      const std::string factor = "Wear coefficient factor";
      if (wear_coefficient_table.empty())
        return make_wear_law(Wear::local_coefficient(wear_coefficient,
                                                     wear_coefficient_basis),
                             wear_coefficient_factor,
                             factor);
      try
        {
          const Wear::CoefficientTable table(wear_coefficient_table);
          Wear::WearLaw                law =
            make_wear_law(table.largest(), wear_coefficient_factor, factor);
          law.factors.emplace_back(table);
          return law;
        }
      catch (const ExcInput &exception)
        {
          throw ExcParameter("Bushing " + name + "/Wear coefficient table",
                             message_of(exception));
        }
    }



    bool
    BushingParameters::cells_are_alike() const
    {
      return !mesh_file.is_given() && rim_shape.is_concentric_circle() &&
             mesh.n_sector_refinements == 0;
    }



    Wear::WearLaw
    BushingParameters::pin_wear_law() const
    {
      return make_wear_law(pin_wear_coefficient,
                           pin_wear_coefficient_factor,
                           "Pin wear coefficient factor");
    }



    Wear::WearLaw
    BushingParameters::make_wear_law(const double       coefficient,
                                     const std::string &factor,
                                     const std::string &parameter) const
    {
      Wear::WearLaw                law{{coefficient}, {}};
      const Wear::FactorExpression expression("Bushing " + name + "/" +
                                                parameter,
                                              factor);
      if (!expression.is_one())
        law.factors.emplace_back(expression);
      if (running_in_factor != 1. && running_in_distance > 0.)
        law.factors.emplace_back(
          Wear::RunningIn{running_in_factor, running_in_distance});
      return law;
    }



    bool
    BushingParameters::pin_is_elastic(
      const Multibody::JointParameters &joint) const
    {
      return pin == PinModel::elastic ||
             (pin == PinModel::automatic &&
              joint.pin_material.youngs_modulus <=
                100. * joint.bushing_material.youngs_modulus);
    }
  } // namespace Coupling
} // namespace Tribody

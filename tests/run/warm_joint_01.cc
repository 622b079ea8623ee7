// SPDX-License-Identifier: LGPL-2.1-or-later

// Friction heats the bushing of a shaft that turns under a constant force. On
// a round ring, what is not spread evenly around the bore has no part in means
// around it, so that these have closed forms wherever the contact is, as long
// as little is worn:
// - power mu F_N v with F = F_N sqrt(1 + mu^2) (1e-3: friction is smooth at
//   rest);
// - with its rim at ambient temperature the ring is warmer in the mean by
//   Q/(2 pi lambda L) (1/2 - a^2/(b^2 - a^2) ln(b/a)) (the mesh: 1e-4);
// - pin and bore come nearer by the expansion of a ring in a rigid housing
//   under T ~ ln(b/r), see elasticity/thermal_01, and by that of the pin;
// - a shaft takes G (T_c - T_a), and all where the rim is insulated (to the
//   tolerance of the temperature);
// - pin and bore touch as if the pin had grown before it was built in;
// - friction that falls with the temperature heats less: mu(T_c) (the motion
//   is renewed when that changes by 'Dynamics update', 1 %);
// - half the modulus by a 'Modulus factor' is half the modulus, and a wear
//   coefficient that depends on the temperature one that is as large there, to
//   what the temperature changes while the contact grows;
// - load cases with other surroundings: the mean over the time.
// - a bore with a finer sector closes as much (the mean is one over length);
// - loads from a file heat as the motion does that they are of;
// - what was hot in an earlier load case is told.
// A state that is restored goes on with the same bits. What has no clearance
// any more, or gets warmer without end, is told.

#include <deal.II/base/mpi.h>

#include "run_lines.h"
#include <tribody/base/exceptions.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

using namespace Tribody;

namespace
{
  Coupling::CaseParameters
  read(const std::string &heat,
       const std::string &lines,
       const std::string &machine)
  {
    const std::string cycles = lines.find("in sequence") == std::string::npos
                                 ? "set Cycles = 100\n"
                                 : "";
    return read_lines("warm_joint_01",
                      machine,
                      cycles +
                        "subsection Joint bearing\n"
                        "  set Friction law = Coulomb regularised\n"
                        "  set Friction coefficient = 0.1\n"
                        "  set Bushing radius = 9.575 mm\n"
                        "end\n"
                        "subsection Material PTFE\n"
                        "  set Thermal conductivity = 0.25 W/(m K)\n"
                        "end\n"
                        "subsection Bushing bearing\n"
                        "  set Pressure model = finite element\n"
                        "  subsection Heat\n"
                        "    set Temperature = steady\n" +
                        heat + "  end\nend\n" + lines);
  }



  Coupling::RunResults
  run(const std::string &heat,
      const std::string &lines   = "",
      const std::string &machine = "loaded_shaft.prm")
  {
    return run_silently(read(heat, lines, machine));
  }



  const Coupling::Warmth &
  warmth(const Coupling::RunResults &results)
  {
    return results.state.joints[0].warmth;
  }



  constexpr double a = 9.575e-3, b = 15.875e-3, lambda = 0.25, L = 8.6e-3,
                   ambient  = 293.15;
  const double normal_force = 120. / std::sqrt(1.01), speed = a * M_PI;



  double
  mean_rise(const double power)
  {
    return power / (2. * M_PI * lambda * L) *
           (0.5 - a * a / (b * b - a * a) * std::log(b / a));
  }



  // Inwards, of the bore in plane strain.
  double
  closing_of_ring(const double power, const double expansion)
  {
    double       nu    = 0.38;
    const double alpha = (1. + nu) * expansion;
    nu /= 1. - nu;
    const double scale = power / (2. * M_PI * lambda * L);
    const double moment =
      scale * ((b * b - a * a) / 4. - a * a / 2. * std::log(b / a));
    const double B = -(1. + nu) * alpha / b * moment /
                     ((1. - nu) / (1. + nu) * b / (a * a) + 1. / b);
    return -((1. - nu) / (1. + nu) * B / a + B / a);
  }



  double
  relative(const double value, const double known)
  {
    return std::abs(value / known - 1.);
  }



  std::ostream &
  out()
  {
    static std::ostringstream nowhere;
    return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0
             ? std::cout
             : nowhere;
  }



  void
  test_means()
  {
    const double pin_expansion = 1.2e-5, expansion = 1.3e-4;
    const auto   results =
      run("",
          "subsection Material PTFE\n  set Thermal expansion = 1.3e-4 K^-1\n"
          "end\nsubsection Material steel\n"
          "  set Thermal expansion = 1.2e-5 K^-1\nend\n");
    const Coupling::Warmth &warm  = warmth(results);
    const double            known = 0.1 * normal_force * speed;
    out() << "power " << known << " W: right to 0.1 % "
          << (relative(warm.power, known) < 1e-3) << std::endl;
    out() << "mean rise " << mean_rise(warm.power) << " K: right to 0.1 % "
          << (relative(warm.mean_temperature - ambient, mean_rise(warm.power)) <
              1e-3)
          << "; contact warmer than evenly heated bore ("
          << mean_rise(warm.power) /
               (0.5 - a * a / (b * b - a * a) * std::log(b / a)) *
               std::log(b / a)
          << " K) "
          << (warm.contact_temperature - ambient >
              warm.power / (2. * M_PI * lambda * L) * std::log(b / a))
          << std::endl;
    const double closing =
      closing_of_ring(warm.power, expansion) +
      pin_expansion * 9.525e-3 * (warm.contact_temperature - ambient);
    out() << "closing of the ring "
          << 1e6 * closing_of_ring(warm.power, expansion)
          << " um; with the pin right to 0.5 % "
          << (relative(warm.closing, closing) < 5e-3) << std::endl;
  }



  void
  test_shaft()
  {
    const Coupling::Warmth warm =
      warmth(run("    set Shaft conductance = 0.01 W/K\n"
                 "    set Temperature tolerance = 1e-3 K\n"));
    out() << "shaft: takes what it should "
          << (relative(warm.shaft_power,
                       0.01 * (warm.contact_temperature - ambient)) < 1e-4)
          << ", and the ring the rest "
          << (relative(warm.mean_temperature - ambient,
                       mean_rise(warm.power - warm.shaft_power)) < 1e-3)
          << std::endl;
    const Coupling::Warmth insulated =
      warmth(run("    set Shaft conductance = 0.01 W/K\n"
                 "    set Rim = insulated\n"));
    out() << "insulated: all through the shaft "
          << (std::abs(insulated.max_temperature - ambient -
                       insulated.power / 0.01) < 0.1)
          << std::endl;
    // Through the whole rim.
    const Coupling::Warmth resisted =
      warmth(run("    set Rim = heat transfer\n"
                 "    set Thermal resistance = 12 K/W\n"));
    out() << "resistance: as much more "
          << (relative(resisted.mean_temperature - ambient,
                       mean_rise(resisted.power) + 12. * resisted.power) < 1e-3)
          << std::endl;
  }



  void
  test_closing()
  {
    // All through the shaft: 35.9 K, in which the pin grows by 17 um.
    const std::string heat =
                        "    set Shaft conductance = 0.01 W/K\n"
                        "    set Rim = insulated\n"
                        "    set Temperature tolerance = 1e-4 K\n",
                      expansion =
                        "subsection Material steel\n"
                        "  set Thermal expansion = 5e-5 K^-1\nend\n";
    const auto         warm = run(heat, expansion);
    const auto         cold = run(heat);
    std::ostringstream radius;
    radius << std::setprecision(15)
           << "subsection Joint bearing\n  set Pin radius = "
           << 9.525e-3 + warmth(warm).closing << " m\nend\n";
    const auto   thick    = run(heat, radius.str());
    const double pressure = warm.state.joints[0].contact.max_pressure;
    out() << "closing in the contact: as a pin that is thicker, to 0.1 % "
          << (relative(pressure, thick.state.joints[0].contact.max_pressure) <
              1e-3)
          << ", and not as the cold one "
          << (relative(pressure, cold.state.joints[0].contact.max_pressure) >
              0.03)
          << std::endl;
  }



  void
  test_friction()
  {
    const auto results =
      run("    set Friction factor = 1 - 0.01*(T - 293.15)\n");
    const Coupling::Warmth &warm = warmth(results);
    const double mu = 0.1 * (1. - 0.01 * (warm.contact_temperature - ambient));
    const double known = mu * 120. / std::sqrt(1. + mu * mu) * speed;
    out() << "friction factor: right to 1 % "
          << (relative(warm.power, known) < 0.01) << ", and far from cold "
          << (warm.power < 0.9 * 0.1 * normal_force * speed) << std::endl;
  }



  void
  test_modulus_and_wear()
  {
    const auto halved = run("    set Modulus factor = 0.5\n");
    const auto softer = run("",
                            "subsection Material PTFE\n"
                            "  set Young's modulus = 0.0695 GPa\nend\n");
    out() << "half the modulus: the same depth to 1e-6 "
          << (relative(halved.bushings[0].bushing.max_wear_depth,
                       softer.bushings[0].bushing.max_wear_depth) < 1e-6)
          << std::endl;

    const std::string factor =
      "subsection Bushing bearing\n  set Wear coefficient factor = ";
    const auto         warm = run("", factor + "exp((T - 293.15)/100)\nend\n");
    std::ostringstream number;
    number << std::setprecision(15)
           << std::exp((warmth(warm).contact_temperature - 293.15) / 100.);
    const auto as_large = run("", factor + number.str() + "\nend\n");
    out() << "k(T): as with that k to 2 % "
          << (relative(warm.bushings[0].bushing.max_wear_depth,
                       as_large.bushings[0].bushing.max_wear_depth) < 0.02)
          << ", and k more than 1.3 times as large "
          << (std::stod(number.str()) > 1.3) << std::endl;
  }



  void
  test_surroundings()
  {
    const auto results = run("",
                             "set Load cases = day, night\n"
                             "subsection Load case day\n"
                             "  set Share = 0.25\n"
                             "  set Ambient temperature = 40 degC\nend\n"
                             "subsection Load case night\n"
                             "  set Share = 0.75\n"
                             "  set Ambient temperature = 0 degC\nend\n");
    out() << "surroundings: " << warmth(results).ambient_temperature - 273.15
          << " degC in the mean" << std::endl;
  }



  void
  test_meshes()
  {
    const std::string expansion =
      "subsection Material PTFE\n  set Thermal expansion = 1.3e-4 K^-1\nend\n";
    const double even = warmth(run("", expansion)).closing;
    out() << "a finer sector:";
    for (const char *sector : {"-60 deg, 60 deg", "120 deg, 240 deg"})
      out() << " closing to 1 % "
            << (relative(warmth(run("",
                                    expansion +
                                      "subsection Bushing bearing\n"
                                      "  subsection Mesh\n"
                                      "    set Sector refinements = 2\n"
                                      "    set Refined sector = " +
                                      std::string(sector) + "\n  end\nend\n"))
                           .closing,
                         even) < 0.01);
    out() << std::endl;
  }



  void
  test_given_loads()
  {
    const double moved = warmth(run("")).power;
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        std::ofstream file("warm_joint_01.csv");
        file << "time [s], force [N], force_angle [deg], pin_angle [deg]\n"
             << std::setprecision(15);
        for (unsigned int i = 0; i <= 8; ++i)
          file << 0.25 * i << ',' << normal_force << ",0," << 45 * i << '\n';
      }
    MPI_Barrier(MPI_COMM_WORLD);
    const double given = warmth(run("",
                                    "subsection Bushing bearing\n"
                                    "  set Duty cycle file = "
                                    "warm_joint_01.csv\nend\n",
                                    "loaded_bushing.prm"))
                           .power;
    out() << "given loads: power as of the motion to 0.1 % "
          << (relative(given, moved) < 1e-3) << std::endl;
  }



  void
  test_sequence()
  {
    const auto results =
      run("",
          "set Load cases = rough, smooth\n"
          "set Order of load cases = in sequence\n"
          "subsection Load case rough\n  set Cycles = 50\nend\n"
          "subsection Load case smooth\n  set Cycles = 50\n"
          "  subsection Joint bearing\n"
          "    set Friction coefficient = 1e-4\n  end\nend\n");
    out() << "in sequence: in the end "
          << std::round(warmth(results).max_temperature - ambient)
          << " K warmer, at most more than 50 K "
          << (results.state.joints[0].totals.max_temperature > ambient + 50.)
          << ", power of the last " << (warmth(results).power < 1e-3)
          << std::endl;
  }



  void
  test_restored()
  {
    const Coupling::CaseParameters parameters =
      read("    set Modulus factor = 1 - 0.01*(T - 293.15)\n",
           "subsection Material PTFE\n  set Thermal expansion = 5e-5 K^-1\n"
           "end\n",
           "loaded_shaft.prm");
    std::ostringstream       screen;
    Console                  console(screen);
    Coupling::WearSimulation first(parameters, console, MPI_COMM_WORLD),
      second(parameters, console, MPI_COMM_WORLD);
    first.start();
    first.advance(parameters.cycles);
    second.restore(first.state());
    for (Coupling::WearSimulation *simulation : {&first, &second})
      while (!simulation->is_over())
        simulation->advance(parameters.cycles);
    out() << "restored: the same bits "
          << (first.state().joints[0].depth == second.state().joints[0].depth &&
              first.state().joints[0].warmth.contact_temperature ==
                second.state().joints[0].warmth.contact_temperature)
          << std::endl;
  }



  void
  test_failure(const std::string &heat, const std::string &lines)
  {
    try
      {
        run(heat, lines);
        out() << "no error" << std::endl;
      }
    catch (const ExcRun &exception)
      {
        out() << message_of(exception) << std::endl;
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  out() << std::setprecision(4);
  test_means();
  test_shaft();
  test_closing();
  test_friction();
  test_modulus_and_wear();
  test_surroundings();
  test_meshes();
  test_given_loads();
  test_sequence();
  test_restored();
  test_failure("",
               "subsection Joint bearing\n  set Bushing radius = 9.535 mm\n"
               "end\nsubsection Material PTFE\n"
               "  set Thermal expansion = 5e-4 K^-1\nend\n");
  // In a housing with a gap the pin has no more room in its bore than without.
  test_failure("",
               "subsection Joint bearing\n  set Bushing radius = 9.535 mm\n"
               "end\nsubsection Material steel\n"
               "  set Thermal expansion = 1.2e-4 K^-1\nend\n"
               "subsection Bushing bearing\n  set Outer support = housing\n"
               "  set Housing gap = 0.1 mm\nend\n");
  test_failure("    set Friction factor = exp((T - 293.15)/5)\n", "");
}

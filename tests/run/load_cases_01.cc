// SPDX-License-Identifier: LGPL-2.1-or-later

// A bushing that wears under two load cases, 120 N and 60 N for 200 m of
// sliding each, with an angle between them: mixed, or one after the other in
// both orders. Known: the depths of a rigid pin in a Winkler bore, integrated
// apart with 720 nodes and 300 explicit steps of each case; they are printed to
// four digits, that is 0.05 %. Wear steps leave 0.1 %, the mesh less, and 200 m
// are met by whole cycles to 0.05 %. The order matters where the loads do not
// point one way.
// - One case in two halves is the whole one: shares add up.
// - In one direction the life under both is that of the rule of
//   Palmgren and Miner, 1/G = sum t_i / (T G_i), to the error of the steps
//   (0.1 %): there the pressure model is of no account either.
// - A spectrum of one case is the run without load cases, bit for bit.
// - Twice the wear coefficient in half the cycles: the same wear.
// - Hours and sliding distance add up.

#include <deal.II/base/mpi.h>

#include "run_lines.h"

#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

using namespace Tribody;

namespace
{
  // A case that includes the loaded shaft, with these lines.
  Coupling::RunResults
  run(const std::string &lines)
  {
    return run_silently(read_lines("load_cases_01", "loaded_shaft.prm", lines));
  }



  // A force [N] in a direction [deg].
  std::string
  force(const double size, const double angle)
  {
    const double       phi = angle * M_PI / 180.;
    std::ostringstream text;
    text << std::setprecision(15)
         << "subsection Force load\n  set Vector = " << size * std::cos(phi)
         << " N, " << size * std::sin(phi) << " N\nend\n";
    return text.str();
  }



  std::string
  load_case(const std::string &name,
            const std::string &duty,
            const std::string &what_differs)
  {
    return "subsection Load case " + name + "\n  set " + duty + "\n" +
           what_differs + "end\n";
  }



  double
  depth(const Coupling::RunResults &results)
  {
    return results.bushings[0].bushing.max_wear_depth;
  }



  void
  print(const std::string &what, const double error, const double bound)
  {
    std::cout << what << " to " << 100. * bound
              << " %: " << (std::abs(error) <= bound) << std::endl;
  }



  // Depths [mm] of: mixed, heavy first, light first.
  void
  compare_orders(const double angle, const std::array<double, 3> &known)
  {
    const std::string cases =
      load_case("heavy", "Cycles = 3340", force(120., 0.)) +
      load_case("light", "Cycles = 3340", force(60., angle));
    const std::string sequence = "set Order of load cases = in sequence\n";
    const std::array<double, 3> depths = {
      {depth(run("set Load cases = heavy, light\nset Cycles = 6680\n" + cases)),
       depth(run("set Load cases = heavy, light\n" + sequence + cases)),
       depth(run("set Load cases = light, heavy\n" + sequence + cases))}};
    std::cout << angle << " degrees" << std::endl;
    const std::array<const char *, 3> orders = {
      {"  mixed", "  heavy first", "  light first"}};
    for (unsigned int i = 0; i < 3; ++i)
      print(orders[i], 1e3 * depths[i] / known[i] - 1., 2.5e-3);
  }



  void
  compare_sums()
  {
    const Coupling::RunResults plain = run("set Cycles = 6680\n");
    const Coupling::RunResults one =
      run("set Load cases = only\nset Cycles = 6680\n" +
          load_case("only", "Share = 1", ""));
    std::cout << "One case is the run without: " << (depth(one) == depth(plain))
              << std::endl;
    const Coupling::RunResults halves =
      run("set Load cases = a, b\nset Cycles = 6680\n" +
          load_case("a", "Cycles = 1", "") + load_case("b", "Cycles = 1", ""));
    print("Two halves", depth(halves) / depth(plain) - 1., 1e-6);
    const Coupling::RunResults twice = run(
      "set Load cases = dirty\nset Cycles = 3340\n" +
      load_case("dirty", "Cycles = 1", "  set Wear coefficient factor = 2\n"));
    print("Twice the wear in half the cycles",
          depth(twice) / depth(plain) - 1.,
          1e-6);
    const double time = halves.state.operating_time;
    print("Hours", time / (6680. * 2.) - 1., 1e-12);
    print("Sliding",
          halves.state.joints[0].totals.sliding_distance /
              plain.state.joints[0].totals.sliding_distance -
            1.,
          1e-12);
  }



  double
  life(const std::string &lines)
  {
    return run(
             "set Cycles = 100000\nsubsection Bushing bearing\n  set Stop at "
             "maximum depth = 0.1 mm\nend\n" +
             lines)
      .state.operating_time;
  }



  // SKF's rule, with the light case at twice the speed.
  void
  compare_lives()
  {
    const std::string light =
      force(60., 0.) + "subsection Driver motor\n  set Speed = 60 rpm\nend\n";
    const double of_heavy = life(""), of_light = life(light);
    const double of_both = life("set Load cases = heavy, light\n" +
                                load_case("heavy", "Share = 0.3", "") +
                                load_case("light", "Share = 0.7", light));
    print("Life by the rule of sums",
          of_both * (0.3 / of_heavy + 0.7 / of_light) - 1.,
          2e-3);
  }
} // namespace



int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  compare_orders(0., {{0.1440, 0.1440, 0.1440}});
  compare_orders(30., {{0.1396, 0.1393, 0.1396}});
  compare_orders(60., {{0.1236, 0.1214, 0.1274}});
  compare_orders(90., {{0.1035, 0.0969, 0.1114}});
  compare_orders(180., {{0.0969, 0.0969, 0.0969}});
  compare_sums();
  compare_lives();
  return 0;
}

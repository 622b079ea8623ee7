// SPDX-License-Identifier: LGPL-2.1-or-later

// Wear coefficients from a table. Known:
// - k = (1 + 2 p)(3 - v) with p in MPa and v in m/s is bilinear, so that a
// table
//   of it gives it everywhere within; beyond, it is that of the edge.
// - The derivative with respect to the pressure is 2 (3 - v), and zero beyond
//   the edge; that of the area removed is what central differences give (their
//   step of 1e-6 leaves 1e-9).
// - Order of columns and rows, units and a column that is left out do not
//   matter.
// - What is no table is refused with its line.

#include <tribody/base/exceptions.h>
#include <tribody/wear/wear_law.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

using namespace Tribody;
using namespace Tribody::Wear;

CoefficientTable
read(const std::string &text)
{
  std::ofstream("table.csv") << text;
  return CoefficientTable("table.csv");
}

// In units of 1e-15 Pa^-1 = 1e-6 mm^3/(N m).
double
exact(const double p, const double v)
{
  return (1. + 2. * p) * (3. - v);
}

const std::string bilinear =
  "pressure [MPa], speed [m/s], wear coefficient "
  "[mm^3/(N m)]\n"
  "1, 0, 9e-6\n1, 1, 6e-6\n"
  "2, 0, 15e-6\n2, 1, 10e-6\n"
  "5, 0, 33e-6\n5, 1, 22e-6\n";

void
test_values(const std::string &name, const CoefficientTable &table)
{
  double value_error = 0., slope_error = 0.;
  for (const double p : {0.1, 1., 1.3, 2.7, 4.9, 7.})
    for (const double v : {0., 0.3, 0.9, 2.})
      {
        const double      p_in  = std::min(std::max(p, 1.), 5.);
        const double      v_in  = std::min(v, 1.);
        const FactorValue f     = table.evaluate(p * 1e6, {0.01, v, 0.});
        const double      k     = table.largest() * f.value / 1e-15;
        const double      slope = table.largest() * f.d_pressure / 1e-15 * 1e6;
        value_error = std::max(value_error, std::abs(k - exact(p_in, v_in)));
        // At a point itself it has two values.
        if (p != 1.)
          slope_error =
            std::max(slope_error,
                     std::abs(slope - (p == p_in ? 2. * (3. - v_in) : 0.)));
      }
  std::cout << name << ": largest " << table.largest() / 1e-15
            << "e-15 /Pa, values right to 1e-12: " << (value_error < 1e-12)
            << ", derivatives: " << (slope_error < 1e-12) << std::endl;
}

// k = (1 + 2 p)(3 - v)(1 + T/100) with T in degrees Celsius, and T alone.
void
test_temperature()
{
  const CoefficientTable table = read(
    "temperature [degC], pressure [MPa], speed [m/s], wear coefficient "
    "[mm^3/(N m)]\n"
    "0, 1, 0, 9e-6\n0, 1, 1, 6e-6\n0, 2, 0, 15e-6\n0, 2, 1, 10e-6\n"
    "100, 1, 0, 18e-6\n100, 1, 1, 12e-6\n100, 2, 0, 30e-6\n"
    "100, 2, 1, 20e-6\n");
  const CoefficientTable alone = read(
    "temperature [K], wear coefficient [Pa^-1]\n300, 1e-15\n400, "
    "2e-15\n");
  double error = 0.;
  for (const double T : {-10., 0., 35., 80., 120.})
    {
      const double  T_in = std::min(std::max(T, 0.), 100.);
      const Sliding sliding{0.01, 0.3, 0., 1., T + 273.15};
      error = std::max(error,
                       std::abs(table.largest() *
                                  table.evaluate(1.5e6, sliding).value / 1e-15 -
                                exact(1.5, 0.3) * (1. + T_in / 100.)));
    }
  std::cout << "temperature: values right to 1e-11: " << (error < 1e-11)
            << ", alone at 350 K: "
            << alone.largest() *
                 alone.evaluate(1e6, {0.01, 0.3, 0., 1., 350.}).value / 1e-15
            << "e-15 /Pa; depend on it: " << table.depends_on_temperature()
            << alone.depends_on_temperature()
            << read(bilinear).depends_on_temperature() << std::endl;
}

void
test_law()
{
  const CoefficientTable table = read(bilinear);
  const WearLaw          law{{table.largest()}, {table}};
  const Sliding          sliding{0.01, 0.3, 0.};
  const Eigen::VectorXd  weights = Eigen::VectorXd::Constant(5, 1e-3);
  Eigen::VectorXd        forces(5);
  forces << 0., 500., 1500., 3000., 8000.;
  constexpr double      step = 1e-6;
  const Eigen::VectorXd difference =
    (law.area_increments((1. + step) * forces, weights, sliding) -
     law.area_increments((1. - step) * forces, weights, sliding)) /
    (2. * step);
  const Eigen::VectorXd slopes =
    law.area_derivatives(forces, weights, sliding).cwiseProduct(forces);
  std::cout << "law: derivative right to 1e-8: "
            << ((slopes - difference).lpNorm<Eigen::Infinity>() <
                1e-8 * slopes.maxCoeff())
            << ", area at 1.5 MPa "
            << law.area_increments(forces, weights, sliding)[2] /
                 (exact(1.5, 0.3) * 1e-15 * 1500. * 0.01)
            << " of the exact one" << std::endl;
}

void
test_one_column()
{
  const CoefficientTable of_pressure =
    read("pressure [bar]; wear coefficient [um/km/MPa]\n10;9\n20;15\n");
  const CoefficientTable of_speed =
    read("speed [mm/s], wear coefficient [1/Pa]\n0, 9e-15\n1000, 6e-15\n");
  for (const double x : {0., 0.5, 1.5, 9.})
    {
      const FactorValue p = of_pressure.evaluate(x * 1e6, {0.01, 7., 0.});
      const FactorValue v = of_speed.evaluate(7e6, {0.01, x, 0.});
      std::cout << "k at " << x << " MPa "
                << p.value * of_pressure.largest() / 1e-15 << ", at " << x
                << " m/s " << v.value * of_speed.largest() / 1e-15
                << ", derivatives "
                << p.d_pressure * of_pressure.largest() / 1e-21 << ' '
                << v.d_pressure << std::endl;
    }
}

void
test_bad()
{
  const std::string head =
    "pressure [MPa], speed [m/s], wear coefficient [mm^3/(N m)]\n";
  const std::string p_only = "pressure [MPa], wear coefficient [mm^3/(N m)]\n";
  const std::vector<std::string> tables = {
    "",
    p_only,
    p_only + "1, 2e-6\n",
    p_only + "1, 2e-6\n1, 3e-6\n",
    p_only + "1, 2e-6\n2, 3e-6\n2, 4e-6\n",
    p_only + "2, 2e-6\n1, 3e-6\n",
    p_only + "1, 2e-6\n2, -3e-6\n",
    p_only + "-1, 2e-6\n2, 3e-6\n",
    p_only + "1, 2e-6\n2, many\n",
    p_only + "1, 2e-6\n2, nan\n",
    p_only + "1, 2e-6\n2,\n",
    p_only + "1, 2e-6\n2\n",
    p_only + "1, 0\n2, 0\n",
    "pressure, wear coefficient [mm^3/(N m)]\n1, 2e-6\n2, 3e-6\n",
    "pressure [N], wear coefficient [mm^3/(N m)]\n1, 2e-6\n2, 3e-6\n",
    "pressure [MPa], wear coefficient [mm^3]\n1, 2e-6\n2, 3e-6\n",
    "pressure [MPa], k [mm^3/(N m)]\n1, 2e-6\n2, 3e-6\n",
    "wear coefficient [mm^3/(N m)]\n2e-6\n3e-6\n",
    "pressure [MPa], temperature [K], wear coefficient [mm^3/(N m)]\n"
    "1, 300, 2e-6\n2, 300, 3e-6\n",
    head + "1, 0, 2e-6\n1, 1, 3e-6\n2, 0, 4e-6\n",
    head + "1, 0, 2e-6\n2, 1, 3e-6\n",
    head + "1, 0, 2e-6\n2, 0, 3e-6\n"};
  for (const std::string &table : tables)
    try
      {
        read(table);
        std::cout << "ACCEPTED: " << table << std::endl;
      }
    catch (const ExcInput &exception)
      {
        std::cout << message_of(exception) << std::endl;
      }
}

int
main()
{
  test_values("bilinear", read(bilinear));
  test_values("speed first",
              read("speed [m/s]\twear coefficient [um/(km MPa)]\tpressure "
                   "[MPa]\n"
                   "0\t9\t1\n0\t15\t2\n0\t33\t5\n1\t6\t1\n1\t10\t2\n1\t22\t5"
                   "\n"));
  test_temperature();
  test_law();
  test_one_column();
  test_bad();
}

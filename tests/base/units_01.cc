// SPDX-License-Identifier: LGPL-2.1-or-later

// Units: values as they stand in a data sheet, against factors known by
// definition (1 rpm = 2 pi/60 rad/s, 1 mm^3/(N m) = 1e-9 m^2/N = 1e-9/Pa), what
// is refused, and that what is written reads back.

#include <tribody/base/exceptions.h>
#include <tribody/base/units.h>

#include <cmath>
#include <iostream>
#include <sstream>
#include <utility>
#include <vector>

using namespace Tribody;

void
check(const std::string &text, const std::string &unit, const double expected)
{
  const double value = Units::from_string(text, unit);
  const double error =
    std::abs(value - expected) / (expected == 0. ? 1. : std::abs(expected));
  std::cout << text << " -> " << unit << ": "
            << (error < 1e-14 ? "right" : "WRONG") << std::endl;
}

void
refuse(const std::string &text, const std::string &unit)
{
  try
    {
      Units::from_string(text, unit);
      std::cout << "ACCEPTED: " << text << std::endl;
    }
  catch (const ExcInput &exception)
    {
      exception.print_info(std::cout);
    }
}

int
main()
{
  check("9.525 mm", "m", 9.525e-3);
  check("  -90 N ", "N", -90.);
  check("0.139 GPa", "Pa", 0.139e9);
  check("5.05e-4 mm^3/(N m)", "Pa^-1", 5.05e-13);
  check("30 rpm", "rad/s", M_PI);
  check("180 deg", "rad", M_PI);
  check("90 degree", "rad", M_PI / 2);
  check("1 rad", "rad", 1.);
  check("2.16 g/cm^3", "kg/m^3", 2160.);
  check("204e-6 kg m^2", "kg m^2", 204e-6);
  check("525.4 N/m", "N/m", 525.4);
  check("1 kg/s", "N s/m", 1.);
  check("0.15", "", 0.15);
  check("+2e-3 m", "m", 2e-3);
  check("7.84e3 kg m-3", "kg/m^3", 7840.);
  check("3 N m/(s**-1 rad)", "N m s/rad", 3.);
  check("0 m", "m", 0.);
  check("20 degC", "K", 293.15);
  check("7e-15 1/Pa", "Pa^-1", 7e-15);
  check("1e5 1 / mm", "m^-1", 1e8);
  check("0.5 rev/s", "rad/s", M_PI);
  check("1 lbm", "kg", 0.45359237);

  refuse("9.525", "m");
  refuse("9.525 kg", "m");
  refuse("30 Hz", "rad/s");
  refuse("30 rad/s", "s^-1");
  refuse("9.525 furlongz", "m");
  refuse("wide", "m");
  refuse("nan m", "m");
  refuse("1e999 m", "m");
  refuse("0.15 m", "");
  refuse("", "m");
  refuse("9 .525 mm", "m");
  refuse("9,525 mm", "m");
  refuse("9 1/8 in", "m");
  refuse("45 Grad", "rad");

  // The reciprocal of the wanted unit, of radians too, which UDUNITS takes for
  // the number 1; a power of them too many.
  for (const auto &[text, unit] :
       std::vector<std::pair<std::string, std::string>>{
         {"0.139 GPa^-1", "Pa"},
         {"5.05e-4 N m/mm^3", "Pa^-1"},
         {"525.4 m/N", "N/m"},
         {"2 kg^-1", "kg"},
         {"0 kg^-1", "kg"},
         {"5 (s)^-1", "s"},
         {"5 rad^-1", "rad"},
         {"5 sr", "rad"},
         {"3 N m rad", "N m/rad"},
         {"3 rad^-1 s^-1", "rad/s"}})
    refuse(text, unit);
  // Numbers that UDUNITS would multiply with, or take for exponents.
  for (const char *text : {"1'000 g",
                           "1\"000 g",
                           "1\u00b0000 g",
                           "1_000 g",
                           "1 000 g",
                           "1.000,5 g",
                           "1e-3-2 g",
                           "2..5 g",
                           "0x10 g",
                           "1 g 5",
                           "1 kg/(100 g) kg",
                           "inf kg",
                           "-inf kg",
                           "+-5 kg",
                           "5 lg(re 1 kg)",
                           "5 lg(re kg)",
                           "5 kg @ 3",
                           "5 s since 2000-01-01",
                           "",
                           "5 "})
    refuse(text, "kg");
  refuse("5 %", "");
  refuse("20 degC", "kg");
  // Too large and too small, before and behind the unit.
  for (const char *text :
       {"1e308 Gg", "1e38 Gg", "1e-38 ng", "1e-320 kg", "1e-999 kg", "1e41 kg"})
    refuse(text, "kg");
  refuse("1e200", "");
  // Logarithms in each other fill any buffer.
  std::string nested = "kg";
  for (unsigned int i = 0; i < 60; ++i)
    nested = "lg(re " + nested + ")";
  refuse("0.5 " + nested, "kg");
  refuse("0.5 lg(re lg(re kg))", "kg");

  // What is written reads back to a few roundings of the conversion.
  for (const double value : {9.535e-3, 1. / 3., 5.05e-13, -0.})
    {
      const std::string text = Units::to_string(value, "m", "mm");
      std::cout << text << ": reads back "
                << (std::abs(Units::from_string(text, "m") - value) <=
                        1e-14 * std::abs(value)
                      ? "right"
                      : "WRONG")
                << std::endl;
    }
}

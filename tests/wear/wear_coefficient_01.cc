// SPDX-License-Identifier: LGPL-2.1-or-later

// Wear coefficients as data sheets print them. Known:
// - 1e-10 in^3 min/(ft lbf h) = 2.0144e-8 mm^3/(N m), from 1 in = 25.4 mm,
//   1 lb = 0.45359237 kg and 9.80665 m/s^2.
// - RTP prints its wear factors in both systems, rounded in each: 13 and 26
//   and so on. They agree if numbers that round to the one are converted to
//   such that round to the other.
// - What has no meaning as a coefficient is refused, with what would be right.
// - A worn-in bushing loses 4/pi k F s and gets 4/pi k F s/(2 R L) deep.

#include <tribody/base/exceptions.h>
#include <tribody/wear/wear_coefficient.h>

#include <cmath>
#include <iostream>
#include <utility>
#include <vector>

using namespace Tribody;
using namespace Tribody::Wear;

constexpr double inch = 25.4e-3, pound_force = 0.45359237 * 9.80665;
// 1e-10 in^3 min/(ft lbf h) [Pa^-1].
constexpr double us_unit =
  1e-10 * inch * inch * inch / 60. / (12. * inch * pound_force);

// Numbers are rounded, multiplied and divided a few times.
void
check(const std::string &text, const double expected)
{
  std::cout << text << ": ";
  try
    {
      const double error = coefficient_from_string(text) / expected - 1.;
      std::cout << (std::abs(error) < 1e-14 ? "right" : "WRONG") << std::endl;
    }
  catch (const ExcInput &exception)
    {
      std::cout << message_of(exception) << std::endl;
    }
}

void
test_printed_pairs()
{
  std::cout << "1e-10 in3 min/(ft lb hr) in 1e-8 mm3/(N m): "
            << std::lround(coefficient_from_string("1e-10 in3 min/(ft lb hr)") /
                           1e-17 * 1e4)
            << "e-4" << std::endl;
  for (const auto &[us, metric] :
       std::vector<std::pair<std::string, std::string>>{{"13", "26"},
                                                        {"132", "265"},
                                                        {"61", "122"},
                                                        {"228", "459"},
                                                        {"4", "8"},
                                                        {"40", "81"},
                                                        {"106", "213"}})
    {
      const double in_metric =
        coefficient_from_string(us + " 1e-10 in3 min/(ft lb hr)");
      const double printed = coefficient_from_string(metric + " 1e-8 mm3/Nm");
      const double half =
        0.5 * (coefficient_from_string("1e-8 mm3/Nm") +
               coefficient_from_string("1e-10 in3-min/ft-lb-hr"));
      std::cout << us << " and " << metric << ": "
                << (std::abs(in_metric - printed) <= half ? "agree" : "DIFFER")
                << std::endl;
    }
}

void
test_spellings()
{
  for (const char *text : {"5.05e-4 mm^3/(N m)",
                           "5.05e-13 Pa^-1",
                           "5.05e-13 m2/N",
                           "5.05e-4 mm3/J",
                           "0.505 um/(MPa m)",
                           "505 um/km/MPa",
                           "5.05e-4 mm3 N-1 m-1",
                           "5.05e-4 mm3/Nm",
                           "5.05e-4mm3/Nm",
                           "5.05e-4 mm^3/Nm",
                           "5.05e-4 mm3/N m",
                           "5.05e-4 mm3/N-m",
                           "5.05e-4 mm^3/(N-m)",
                           "5.05e-4 mm3/N.m",
                           "5.05e-4 mm3/N*m",
                           "5.05e-4 mm**3/(Nm)",
                           "5.05e-4 mm\u00b3/Nm",
                           "5.05e-4 mm\u00b3/(N\u00b7m)",
                           "5.05e-4 mm\u00b3\u00b7N\u207b\u00b9\u00b7m\u207b"
                           "\u00b9",
                           "5.05e-7 cm3/Nm",
                           "5.05e-13 m3/Nm",
                           "5.05e-13 m\u00b3/Nm",
                           "0.505 mm3/Nkm",
                           "0.505 mm3/kNm",
                           "505 um/km MPa",
                           "505 1e-6 mm3/Nm",
                           "505 x 1e-6 mm3/Nm",
                           "505x1e-6mm3/Nm",
                           "505 * 1e-6 mm3/Nm",
                           "505 X 1E-6 mm3/Nm",
                           "505 10^-6 mm3/Nm",
                           "505 x 10^-6 mm3/Nm",
                           "505 x 10**-6 mm3/Nm",
                           "505 x 10-6 mm3/Nm",
                           "505 \u00d7 10\u207b\u2076 mm\u00b3/Nm",
                           "505\u00b710\u207b\u2076 mm\u00b3/(N\u00b7m)",
                           "5.05 \u00d7 10\u207b\u00b9\u00b3 m\u00b2/N",
                           "505 \u00d7 10\u22126 mm\u00b3/Nm",
                           "5.05e2 x 1e-6 mm3/Nm",
                           "505 um/km at 1 MPa",
                           "505 \u00b5m/km at 1 MPa",
                           "  1.01 mm/km at 2 N/mm^2",
                           "50.5 um/km at 1 bar"})
    check(text, 5.05e-13);
  check("1e-6 mm3/Nm", 1e-15);
  check("10^-6 mm3/Nm", 1e-15);
  check("10\u207b\u2076 mm\u00b3/Nm", 1e-15);
  check("-5e-4 mm3/Nm", -5e-13);
  check("26 1e-8 mm3/Nm", 26e-17);
  for (const char *text : {"13e-10 in3 min/(ft lb hr)",
                           "13e-10 in^3-min/ft-lb-hr",
                           "13e-10 in3-min/ft-lb-hr",
                           "13e-10 in3 min/ft lb h",
                           "13e-10 in3.min/ft.lb.hr",
                           "13e-10 in.3-min/ft-lbs-hrs",
                           "13e-10 in^3 min/(ft lbf hr)",
                           "13e-10 in\u00b3\u00b7min/(ft\u00b7lb\u00b7h)",
                           "13 x 1e-10 in3-min/ft-lb-hr",
                           "13 1e-10 in^3-min/ft-lb-hr",
                           "13 \u00d7 10\u207b\u00b9\u2070 "
                           "in\u00b3-min/ft-lb-hr"})
    check(text, 13. * us_unit);
}

void
test_bad_spellings()
{
  for (const std::string &text : {std::string("5e-4"),
                                  std::string("fast"),
                                  std::string(""),
                                  std::string("5e-4 mm3/Nq"),
                                  std::string("5e-4 mm3/N"),
                                  std::string("5e-4 mm2/Nm"),
                                  std::string("5e-4 Nm/mm3"),
                                  std::string("5e-4 mm3/kg m"),
                                  std::string("5e-4 in3 min/(ft lb)"),
                                  std::string("5e-4 mm3//Nm"),
                                  std::string("5e-4 mm3/"),
                                  std::string("5,05 mm3/Nm"),
                                  std::string("5 000 mm3/Nm"),
                                  std::string("5 2e-4 mm3/Nm"),
                                  std::string("5 10-4 mm3/Nm"),
                                  std::string("10-4 mm3/Nm"),
                                  std::string("5 x mm3/Nm"),
                                  std::string("5 x 1e-4"),
                                  std::string("5 x 1e-4 x 1e-3 mm3/Nm"),
                                  std::string("5 x 1e-999 mm3/Nm"),
                                  std::string("1e-6 mm3/Nm at 1 MPa"),
                                  std::string("2 um/km at 0 MPa"),
                                  std::string("2 um/km at -1 MPa"),
                                  std::string("2 um/km at 1 N"),
                                  std::string("2 um/km at "),
                                  std::string("2 um/km"),
                                  std::string("2 um at 1 MPa"),
                                  std::string("2 um/h at 1 MPa"),
                                  "5 mm3/" + std::string(100000, '(')})
    try
      {
        coefficient_from_string(text);
        std::cout << "ACCEPTED: " << text << std::endl;
      }
    catch (const ExcInput &exception)
      {
        std::cout << message_of(exception) << std::endl;
      }
}

int
main()
{
  test_printed_pairs();
  test_spellings();
  test_bad_spellings();

  for (const CoefficientBasis basis : {CoefficientBasis::local,
                                       CoefficientBasis::projected_pressure,
                                       CoefficientBasis::bushing_volume})
    {
      const double ratio    = 5.05e-13 / local_coefficient(5.05e-13, basis);
      const double expected = basis == CoefficientBasis::local ? 1. : 4. / M_PI;
      std::cout << name_of(basis) << ": k/k_local "
                << (std::abs(ratio / expected - 1.) < 1e-15 ? "right" : "WRONG")
                << std::endl;
    }
}

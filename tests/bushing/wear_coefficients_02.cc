// SPDX-License-Identifier: LGPL-2.1-or-later

// The wear coefficient that parameters ask for. Known: a data sheet's spelling
// is the coefficient that UDUNITS-2 reads from the plain one; on another basis
// Archard's k is pi/4 of what is given, to rounding; that of the pin has none.

#include <deal.II/base/parameter_handler.h>

#include <tribody/bushing/bushing_parameters.h>

#include <cmath>
#include <iostream>
#include <string>

using namespace Tribody::Coupling;

BushingParameters
read(const std::string &text)
{
  BushingParameters        bushing;
  dealii::ParameterHandler prm;
  bushing.add_parameters(prm);
  prm.parse_input_from_string(text);
  return bushing;
}

double
local(const std::string &coefficient, const std::string &basis)
{
  return read("set Wear coefficient = " + coefficient +
              "\nset Wear coefficient basis = " + basis)
    .wear_law()
    .archard.wear_coefficient;
}

int
main()
{
  const double plain = read("set Wear coefficient = 26e-8 mm^3/(N m)")
                         .wear_law()
                         .archard.wear_coefficient;
  for (const std::string coefficient :
       {"26e-8 mm^3/(N m)", "26 x 1e-8 mm3/Nm", "0.26 um/km at 1 MPa"})
    {
      std::cout << coefficient << ": local "
                << (std::abs(local(coefficient, "local") / plain - 1.) < 1e-15);
      for (const std::string basis : {"projected pressure", "bushing volume"})
        std::cout << ", " << basis << ' '
                  << (std::abs(local(coefficient, "local") /
                                 local(coefficient, basis) * M_PI / 4. -
                               1.) < 1e-15);
      std::cout << std::endl;
    }
  const BushingParameters bushing = read(
    "set Pin wear coefficient = 26 1e-8 mm3/Nm\n"
    "set Wear coefficient basis = bushing volume");
  std::cout << "pin: "
            << (bushing.pin_wear_law().archard.wear_coefficient == plain)
            << std::endl;
}

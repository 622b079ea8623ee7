// SPDX-License-Identifier: LGPL-2.1-or-later

// The wear laws that the parameters of a bushing ask for. Known: a factor that
// is the number one, however it is written, is none, so that the law is
// Archard's with a constant coefficient; any other is one, and so is
// running-in.

#include <tribody/bushing/bushing_parameters.h>

#include <iostream>

int
main()
{
  using namespace Tribody::Coupling;
  for (const std::string factor : {"1", "1.0", "10e-1", "2", "1 + 0*p"})
    {
      BushingParameters bushing;
      bushing.wear_coefficient_factor = factor;
      std::cout << "factor " << factor << ": bushing constant "
                << bushing.wear_law().is_constant() << ", pin constant "
                << bushing.pin_wear_law().is_constant();
      bushing.running_in_factor   = 3.;
      bushing.running_in_distance = 10.;
      std::cout << ", with running-in " << bushing.wear_law().is_constant()
                << ' ' << bushing.pin_wear_law().is_constant() << std::endl;
    }
}

// SPDX-License-Identifier: LGPL-2.1-or-later

// Expressions of named variables. Known:
// - A number is a constant however it is written, and only 1 is one; what looks
//   like a number with something behind it is not.
// - The values of expressions, from their formulas.
// - Commas stand between arguments of functions only, and a single '=' gives
//   nothing: 0,5*t is not 5*t.
// - What cannot be parsed is named with its parameter and the variables that it
//   may have; a place without a value with the names and units of its
//   coordinates.
// - The words of the parser do not reach the screen.

#include <tribody/base/expression.h>

#include <cmath>
#include <iostream>
#include <sstream>

using namespace Tribody;

int
main()
{
  std::ostringstream    words;
  std::streambuf *const to_screen = std::cerr.rdbuf(words.rdbuf());

  const ExpressionVariables<1> time{{{"t"}},
                                    {{"s"}},
                                    "the time t in seconds",
                                    "'t^2'"};
  for (const std::string text : {"1",
                                 "1.0",
                                 " 1 ",
                                 "100e-2",
                                 "0.5",
                                 "-3",
                                 "1 + 0*t",
                                 "pi/pi",
                                 "1 x",
                                 "",
                                 "0,5*t",
                                 "t,1",
                                 "2*(0,5)*t",
                                 "sin(0,5)*t",
                                 "max(t, 1) + min(0.5, if(t < 1, 2, 3))",
                                 "t = 5",
                                 "if(t == 2, 1, 0) + (t <= 2) + (t != 2)"})
    {
      std::cout << "'" << text << "': ";
      try
        {
          const Expression<1> expression("Force/Time function", text, time);
          std::cout << "constant " << expression.is_constant() << ", one "
                    << expression.is_one() << ", at 2 s "
                    << expression.value(dealii::Point<1>(2.)) << std::endl;
        }
      catch (const ExcParameter &exception)
        {
          exception.print_info(std::cout);
        }
    }

  const ExpressionVariables<4> variables{{{"p", "v", "s", "T"}},
                                         {{"Pa", "m/s", "m", "K"}},
                                         "p, v, s and T",
                                         "'p'"};
  const auto                   at =
    [](const double p, const double v, const double s, const double T) {
      dealii::Point<4> place;
      place[0] = p;
      place[1] = v;
      place[2] = s;
      place[3] = T;
      return place;
    };
  const Expression<4> product("Factor", "p*v^2 + sin(pi/2)*s + T", variables);
  std::cout << "four variables: " << product.value(at(2., 3., 4., 0.5)) << ", "
            << product.value(at(2., 3., 4., 300.)) << "; has T "
            << product.contains("T") << ", has i " << product.contains("i")
            << std::endl;
  const Expression<4> pole("Factor", "1/(p - 1)", variables);
  const auto          place = at(1., 0.25, 1234567., std::nan(""));
  std::cout << "no value: " << !std::isfinite(pole.value(place)) << ", "
            << message_of(pole.error_at(place, "is not a finite number"))
            << std::endl;
  const Expression<4> five(5.);
  std::cout << "given constant: " << five.is_constant() << ' '
            << five.value(place) << std::endl;

  std::cerr.rdbuf(to_screen);
  std::cout << "to the screen: '" << words.str() << "'" << std::endl;
}

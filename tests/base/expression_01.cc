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

  const ExpressionVariables<3> place{{{"p", "v", "s"}},
                                     {{"Pa", "m/s", "m"}},
                                     "p, v and s",
                                     "'p'"};
  const Expression<3>          product("Factor", "p*v^2 + sin(pi/2)*s", place);
  std::cout << "three variables: "
            << product.value(dealii::Point<3>(2., 3., 4.)) << std::endl;
  const Expression<3>    pole("Factor", "1/(p - 1)", place);
  const dealii::Point<3> at(1., 0.25, 1234567.);
  std::cout << "no value: " << !std::isfinite(pole.value(at)) << ", "
            << message_of(pole.error_at(at, "is not a finite number"))
            << std::endl;
  const Expression<3> five(5.);
  std::cout << "given constant: " << five.is_constant() << ' ' << five.value(at)
            << std::endl;

  std::cerr.rdbuf(to_screen);
  std::cout << "to the screen: '" << words.str() << "'" << std::endl;
}

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>

#include <boost/algorithm/string/join.hpp>

#include <tribody/base/expression.h>
#include <tribody/base/significant_digits.h>

#include <iostream>
#include <sstream>

namespace Tribody
{
  template <int n_variables>
  struct Expression<n_variables>::Parser
  {
    dealii::FunctionParser<n_variables> function;
  };



  namespace
  {
    bool
    read_number(const std::string &text, double &number)
    {
      std::istringstream stream(text);
      return stream >> number && (stream >> std::ws).eof();
    }



    // deal.II writes the parser's words to the screen and then throws.
    template <int n_variables>
    bool
    parse(const std::string                      &text,
          const ExpressionVariables<n_variables> &variables,
          dealii::FunctionParser<n_variables>    &function)
    {
      std::ostringstream    words;
      std::streambuf *const to_screen  = std::cerr.rdbuf(words.rdbuf());
      bool                  is_correct = true;
      try
        {
          function.initialize(boost::algorithm::join(variables.names, ","),
                              text,
                              {{"pi", dealii::numbers::PI}});
          // The first evaluation builds the parser of this thread.
          dealii::Point<n_variables> place;
          for (unsigned int i = 0; i < n_variables; ++i)
            place[i] = 1.;
          function.value(place);
        }
      catch (const std::exception &)
        {
          is_correct = false;
        }
      std::cerr.rdbuf(to_screen);
      return is_correct;
    }
  } // namespace



  template <int n_variables>
  Expression<n_variables>::Expression(const double constant)
    : constant(constant)
  {}



  template <int n_variables>
  Expression<n_variables>::Expression(
    const std::string                      &path,
    const std::string                      &text,
    const ExpressionVariables<n_variables> &variables)
    : path(path)
    , variables(variables)
  {
    if (read_number(text, constant))
      return;
    AssertThrow(text.find("rand") == std::string::npos,
                ExcParameter(path,
                             "'" + text +
                               "' asks for random numbers: the same file would "
                               "give other results each time. A sum of sines "
                               "of several frequencies may do"));
    const auto made = std::make_shared<Parser>();
    AssertThrow(
      parse(text, variables, made->function),
      ExcParameter(path,
                   "'" + text + "' is not an expression of " +
                     variables.description + ". Write for example " +
                     variables.examples +
                     "; known are + - * / ^, sin, cos, tan, exp, log, sqrt, "
                     "abs, min, max, if and the constant pi"));
    parser = made;
  }



  template <int n_variables>
  double
  Expression<n_variables>::value(const dealii::Point<n_variables> &place) const
  {
    return parser ? parser->function.value(place) : constant;
  }



  template <int n_variables>
  ExcRun
  Expression<n_variables>::error_at(const dealii::Point<n_variables> &place,
                                    const std::string &problem) const
  {
    std::string where;
    for (unsigned int i = 0; i < n_variables; ++i)
      where += (i > 0 ? ", " : "") + variables.names[i] + " = " +
               significant_digits(place[i], 6) + " " + variables.units[i];
    return ExcRun(path + " " + problem + " at " + where);
  }



  template class Expression<1>;
  template class Expression<3>;
} // namespace Tribody

// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>

#include <boost/algorithm/string/join.hpp>

#include <tribody/base/expression.h>
#include <tribody/base/in_quotes.h>
#include <tribody/base/significant_digits.h>

#include <cctype>
#include <cmath>
#include <iostream>
#include <sstream>
#include <vector>

namespace Tribody
{
  // deal.II's functions have up to three variables, and the time, which is the
  // fourth one here.
  template <int n_variables>
  struct Expression<n_variables>::Parser
  {
    static constexpr int  n_coordinates = n_variables < 4 ? n_variables : 3;
    static constexpr bool has_time      = n_variables > n_coordinates;

    dealii::FunctionParser<n_coordinates> function;

    double
    value(const dealii::Point<n_variables> &place)
    {
      dealii::Point<n_coordinates> coordinates;
      for (unsigned int i = 0; i < n_coordinates; ++i)
        coordinates[i] = place[i];
      if constexpr (has_time)
        function.set_time(place[n_coordinates]);
      return function.value(coordinates);
    }
  };



  namespace
  {
    bool
    read_number(const std::string &text, double &number)
    {
      std::istringstream stream(text);
      return stream >> number && (stream >> std::ws).eof();
    }



    // The parser takes the last of several expressions, "0,5*t" for "5*t".
    // Commas are for functions of several arguments.
    bool
    has_comma_outside_functions(const std::string &text)
    {
      std::vector<bool> is_call;
      for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '(')
          {
            const auto before = text.find_last_not_of(' ', i - 1);
            is_call.push_back(
              i > 0 && before != std::string::npos &&
              (std::isalnum(static_cast<unsigned char>(text[before])) != 0 ||
               text[before] == '_'));
          }
        else if (text[i] == ')' && !is_call.empty())
          is_call.pop_back();
        else if (text[i] == ',' && (is_call.empty() || !is_call.back()))
          return true;
      return false;
    }



    // "t = 0.5" would give the variable another value.
    bool
    has_assignment(const std::string &text)
    {
      for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '=')
          {
            if (i + 1 < text.size() && text[i + 1] == '=')
              ++i;
            else if (i == 0 ||
                     std::string("<>!").find(text[i - 1]) == std::string::npos)
              return true;
          }
      return false;
    }



    /// @throws ExcParameter for what the parser takes, but otherwise than
    /// meant.
    void
    check_meaning(const std::string &path, const std::string &text)
    {
      AssertThrow(
        text.find("rand") == std::string::npos,
        ExcParameter(path,
                     in_quotes(text) +
                       " asks for random numbers: the same file would "
                       "give other results each time. A sum of sines "
                       "of several frequencies may do"));
      AssertThrow(!has_comma_outside_functions(text),
                  ExcParameter(path,
                               in_quotes(text) +
                                 " are two expressions (a decimal comma?); "
                                 "write 0.5, not 0,5"));
      AssertThrow(!has_assignment(text),
                  ExcParameter(path,
                               in_quotes(text) +
                                 " has a single '='; write '==' to compare, "
                                 "and only what stands to the right of '=' to "
                                 "define"));
    }



    // deal.II writes the parser's words to the screen and then throws.
    template <int n_variables, typename Parser>
    bool
    parse(const std::string                      &text,
          const ExpressionVariables<n_variables> &variables,
          Parser                                 &parser)
    {
      std::ostringstream    words;
      std::streambuf *const to_screen  = std::cerr.rdbuf(words.rdbuf());
      bool                  is_correct = true;
      try
        {
          parser.function.initialize(boost::algorithm::join(variables.names,
                                                            ","),
                                     text,
                                     {{"pi", dealii::numbers::PI}},
                                     Parser::has_time);
          // The first evaluation builds the parser of this thread.
          dealii::Point<n_variables> place;
          for (unsigned int i = 0; i < n_variables; ++i)
            place[i] = 1.;
          parser.value(place);
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
    , text(text)
    , variables(variables)
  {
    if (read_number(text, constant))
      return;
    check_meaning(path, text);
    const auto made = std::make_shared<Parser>();
    AssertThrow(
      parse(text, variables, *made),
      ExcParameter(path,
                   in_quotes(text) + " is not an expression of " +
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
    return parser ? parser->value(place) : constant;
  }



  template <int n_variables>
  bool
  Expression<n_variables>::contains(const std::string &name) const
  {
    const auto is_part_of_word = [this](const std::size_t i) {
      return i < text.size() &&
             (std::isalnum(static_cast<unsigned char>(text[i])) != 0 ||
              text[i] == '_');
    };
    for (std::size_t i = text.find(name); i != std::string::npos;
         i             = text.find(name, i + 1))
      if ((i == 0 || !is_part_of_word(i - 1)) &&
          !is_part_of_word(i + name.size()))
        return true;
    return false;
  }



  template <int n_variables>
  ExcRun
  Expression<n_variables>::error_at(const dealii::Point<n_variables> &place,
                                    const std::string &problem) const
  {
    // What is not known, nothing depends on.
    std::string where;
    for (unsigned int i = 0; i < n_variables; ++i)
      if (std::isfinite(place[i]) || contains(variables.names[i]))
        where += (where.empty() ? "" : ", ") + variables.names[i] + " = " +
                 significant_digits(place[i], 6) + " " + variables.units[i];
    return ExcRun(path + " " + problem + " at " + where);
  }



  template class Expression<1>;
  template class Expression<4>;
} // namespace Tribody

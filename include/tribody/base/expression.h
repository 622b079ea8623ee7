// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_expression_h
#define tribody_base_expression_h

#include <deal.II/base/point.h>

#include <tribody/base/exceptions.h>

#include <array>
#include <memory>
#include <string>

namespace Tribody
{
  /// What an expression is a function of, with the words for messages.
  template <int n_variables>
  struct ExpressionVariables
  {
    /// Names in expressions, "t".
    std::array<std::string, n_variables> names;
    /// Their units, "s", for messages; an expression itself has numbers only.
    std::array<std::string, n_variables> units;
    /// "the time t in seconds".
    std::string description;
    /// "'sin(2*pi*t)' or 't^2'".
    std::string examples;
  };

  /**
   * A function of named variables that a user writes in a parameter file, for
   * deal.II's FunctionParser: "sin(2*pi*t)". A number alone, however written,
   * is known as a constant and evaluated without a parser.
   *
   * A plain value; copies share the parser. Instantiated for one and four
   * variables.
   */
  template <int n_variables>
  class Expression
  {
  public:
    /// The same everywhere.
    explicit Expression(const double constant);

    /// @param path the parameter that holds the @p text, for messages.
    /// @throws ExcParameter for what cannot be parsed.
    Expression(const std::string                      &path,
               const std::string                      &text,
               const ExpressionVariables<n_variables> &variables);

    /// At the @p place. Not a finite number where there is none.
    double
    value(const dealii::Point<n_variables> &place) const;

    /// Whether the text is a number, so that value() is the same everywhere.
    bool
    is_constant() const
    {
      return parser == nullptr;
    }

    /// Whether the text has the variable @p name.
    bool
    contains(const std::string &name) const;

    /// Whether it is the constant 1: a factor that need not be evaluated.
    bool
    is_one() const
    {
      return is_constant() && constant == 1.;
    }

    /// To be thrown: "<parameter> <problem> at t = 0.1 s".
    ExcRun
    error_at(const dealii::Point<n_variables> &place,
             const std::string                &problem) const;

  private:
    struct Parser;

    std::string                      path;
    std::string                      text;
    ExpressionVariables<n_variables> variables;
    double                           constant;
    std::shared_ptr<Parser>          parser;
  };
} // namespace Tribody

#endif

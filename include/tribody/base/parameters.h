// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_parameters_h
#define tribody_base_parameters_h

#include <deal.II/base/point.h>

#include <tribody/base/choice.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Tribody
{
  /// What the names of a list are: those of things, of letters, digits, '_',
  /// '-' and '+', or of markers, two of these with a dot between.
  enum class NameKind
  {
    thing,
    marker
  };

  /**
   * Declaration of single parameters in deal.II's ParameterHandler, bound to
   * a variable in SI units. The variable's value at the time of the call is
   * the default. For use in the add_parameters() function that stands next to
   * each parameter struct; the handler must not outlive the variable.
   */
  namespace Parameters
  {
    /**
     * A physical quantity, read by Units::from_string().
     *
     * @param si_unit the unit of @p value, empty for a pure number.
     * @param shown_unit the unit in which the default is printed; @p si_unit
     *   if empty.
     */
    void
    add_quantity(dealii::ParameterHandler &prm,
                 const std::string        &name,
                 double                   &value,
                 const std::string        &si_unit,
                 const std::string        &documentation,
                 const std::string        &shown_unit = "");

    /// A point or vector: two quantities separated by a comma.
    void
    add_point(dealii::ParameterHandler &prm,
              const std::string        &name,
              dealii::Point<2>         &value,
              const std::string        &si_unit,
              const std::string        &documentation,
              const std::string        &shown_unit = "");

    /// Named points, "O: 0 mm, 0 mm; A: 38.1 mm, 0 mm".
    void
    add_named_points(dealii::ParameterHandler                &prm,
                     const std::string                       &name,
                     std::map<std::string, dealii::Point<2>> &value,
                     const std::string                       &si_unit,
                     const std::string                       &documentation);

    /// Names separated by commas.
    void
    add_names(dealii::ParameterHandler &prm,
              const std::string        &name,
              std::vector<std::string> &value,
              const std::string        &documentation,
              const NameKind            kind = NameKind::thing);

    /// One of several @p words, at first @p default_word; @p action is called
    /// with any text that is given.
    void
    add_word(dealii::ParameterHandler                       &prm,
             const std::string                              &name,
             const std::string                              &default_word,
             const std::vector<std::string>                 &words,
             const std::string                              &documentation,
             const std::function<void(const std::string &)> &action);

    /// One of the names of an enumeration or of a LawChoice, see ChoiceNames.
    template <typename Choice>
    void
    add_choice(dealii::ParameterHandler &prm,
               const std::string        &name,
               Choice                   &value,
               const std::string        &documentation)
    {
      add_word(prm,
               name,
               name_of(value),
               words_of(choice_names(value)),
               documentation,
               [&value](const std::string &text) { set_choice(value, text); });
    }

    /// Free text, taken as it is.
    void
    add_text(dealii::ParameterHandler &prm,
             const std::string        &name,
             std::string              &value,
             const std::string        &documentation);

    /// A whole number in [@p minimum, @p maximum].
    void
    add_integer(dealii::ParameterHandler &prm,
                const std::string        &name,
                unsigned int             &value,
                const std::string        &documentation,
                const unsigned int        minimum,
                const unsigned int        maximum);
  } // namespace Parameters

  /// Split "a, b, c" into trimmed, non-empty names.
  std::vector<std::string>
  split_names(const std::string &text, const NameKind kind = NameKind::thing);
} // namespace Tribody

#endif

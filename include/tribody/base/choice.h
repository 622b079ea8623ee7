// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_choice_h
#define tribody_base_choice_h

#include <deal.II/base/exceptions.h>

#include <boost/algorithm/string/join.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/base/in_quotes.h>

#include <string>
#include <utility>
#include <vector>

namespace Tribody
{
  /**
   * All that can be chosen of one kind, each with its word in parameter files
   * and results. The function
   * @code
   * ChoiceNames<Kind> choice_names(const Kind);
   * @endcode
   * stands in the namespace of each enumeration that is a choice, right behind
   * it, and is the only place where its words are written. The argument says of
   * which kind; its value does not matter.
   */
  template <typename Choice>
  using ChoiceNames = std::vector<std::pair<Choice, std::string>>;

  /// The words for all that can be chosen.
  template <typename Choice>
  std::vector<std::string>
  words_of(const ChoiceNames<Choice> &choices)
  {
    std::vector<std::string> words;
    for (const auto &[choice, word] : choices)
      words.push_back(word);
    return words;
  }

  /// The word for @p wanted.
  template <typename Choice>
  std::string
  name_of(const Choice wanted)
  {
    for (const auto &[choice, word] : choice_names(wanted))
      if (choice == wanted)
        return word;
    Assert(false, dealii::ExcMessage("A choice has no name."));
    return "";
  }

  /// Choose what the @p word stands for. @throws ExcInput with all words if it
  /// is none of them.
  template <typename Choice>
  void
  set_choice(Choice &value, const std::string &word)
  {
    const ChoiceNames<Choice> choices = choice_names(value);
    for (const auto &[choice, name] : choices)
      if (name == word)
        {
          value = choice;
          return;
        }
    throw ExcInput(in_quotes(word) + " is not one of: " +
                   boost::algorithm::join(words_of(choices), " | "));
  }
} // namespace Tribody

#endif

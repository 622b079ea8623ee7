// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_base_law_choice_h
#define tribody_base_law_choice_h

#include <tribody/base/choice.h>

#include <array>
#include <type_traits>
#include <variant>

namespace Tribody
{
  /**
   * Which of the laws in a std::variant a parameter file asks for. Each law is
   * a struct with its word and its making,
   * @code
   * static constexpr const char *name = "Hertz";
   * static HertzLaw make(const JointParameters &joint);
   * @endcode
   * and what can be chosen, and how it is made, follow from the list of types.
   */
  template <typename Law>
  class LawChoice;

  /// The choice from the list @p Laws; it has one of them at all times.
  template <typename... Laws>
  class LawChoice<std::variant<Laws...>>
  {
  public:
    /// A law with its values, as make() returns it.
    using Law = std::variant<Laws...>;

    /// The choice of law @p L, one of the list.
    template <typename L>
    static constexpr LawChoice
    of()
    {
      static_assert((std::is_same_v<L, Laws> || ...), "Not one of the laws.");
      constexpr std::array<bool, sizeof...(Laws)> is_it = {
        {std::is_same_v<L, Laws>...}};
      std::size_t i = 0;
      while (!is_it[i])
        ++i;
      return LawChoice(i);
    }

    /// Whether law @p L is chosen.
    template <typename L>
    bool
    is() const
    {
      return *this == of<L>();
    }

    /// Whether the same law is chosen; values of a law do not matter.
    bool
    operator==(const LawChoice &other) const
    {
      return index == other.index;
    }

    /// The law with the values that @p parameters have for it.
    template <typename Parameters>
    Law
    make(const Parameters &parameters) const
    {
      using Maker = Law (*)(const Parameters &);
      constexpr std::array<Maker, sizeof...(Laws)> makers = {
        {&make_one<Laws, Parameters>...}};
      return makers[index](parameters);
    }

    /// Each law with its word, Law::name, in the order of the list.
    friend ChoiceNames<LawChoice>
    choice_names(const LawChoice)
    {
      return {{of<Laws>(), Laws::name}...};
    }

  private:
    constexpr explicit LawChoice(const std::size_t index)
      : index(index)
    {}

    template <typename L, typename Parameters>
    static Law
    make_one(const Parameters &parameters)
    {
      return L::make(parameters);
    }

    std::size_t index;
  };
} // namespace Tribody

#endif

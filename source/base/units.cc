// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/base/in_quotes.h>
#include <tribody/base/significant_digits.h>
#include <tribody/base/units.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <udunits2.h>

namespace Tribody
{
  namespace
  {
    using Unit       = std::unique_ptr<ut_unit, void (*)(ut_unit *)>;
    using UnitSystem = std::unique_ptr<ut_system, void (*)(ut_system *)>;

    // The grammar of UDUNITS nests without a limit of its own.
    constexpr std::size_t max_unit_length = 200;



    UnitSystem
    read_unit_system()
    {
      // UDUNITS writes its complaints to stderr unless told otherwise.
      ut_set_error_message_handler(ut_ignore);
      UnitSystem system(ut_read_xml(nullptr), ut_free_system);
      AssertThrow(system != nullptr,
                  ExcInput("UDUNITS-2 cannot read its unit database. Install "
                           "the package libudunits2-0 or set "
                           "UDUNITS2_XML_PATH."));
      // Everyday spellings that the database does not have.
      for (const auto &[symbol, name] :
           {std::make_pair("deg", "arc_degree"),
            std::make_pair("rev", "turn"),
            std::make_pair("lbm", "avoirdupois_pound")})
        {
          const Unit unit(ut_get_unit_by_name(system.get(), name), ut_free);
          ut_map_symbol_to_unit(symbol, UT_ASCII, unit.get());
        }
      return system;
    }

    ut_system *
    unit_system()
    {
      static const UnitSystem system = read_unit_system();
      return system.get();
    }

    Unit
    parse_unit(const std::string &text)
    {
      // German for a degree, not 1e9 radians.
      if (text.find("Grad") != std::string::npos)
        return {nullptr, ut_free};
      return Unit(ut_parse(unit_system(), text.c_str(), UT_ASCII), ut_free);
    }

    /// What a unit measures.
    struct Dimension
    {
      // Of the basic units. Radians, which UDUNITS takes for the number 1, are
      // one of them: "30 Hz" is not "30 rad/s", wrong by 2 pi.
      std::map<std::string, int> powers;
      // From a zero of its own, as degrees Celsius.
      bool is_shifted = false;
      // Logarithms and dates are no multiples of a unit.
      bool is_multiple = true;
    };



    void
    add_power(Dimension &dimension, const ut_unit *basic, const int power)
    {
      const char *symbol = ut_get_symbol(basic, UT_ASCII);
      if (symbol == nullptr)
        symbol = ut_get_name(basic, UT_ASCII);
      Assert(symbol != nullptr, dealii::ExcMessage("nameless basic unit"));
      dimension.powers[symbol] += power;
    }



    // ut_are_convertible() takes a unit for its reciprocal too, "0.139 GPa^-1"
    // for 7.2 GPa; the powers of the basic units do not.
    const ut_visitor &
    dimension_visitor()
    {
      static const ut_visitor visitor = {
        [](const ut_unit *unit, void *dimension) {
          add_power(*static_cast<Dimension *>(dimension), unit, 1);
          return UT_SUCCESS;
        },
        [](const ut_unit *,
           int                   count,
           const ut_unit *const *basic_units,
           const int            *powers,
           void                 *dimension) {
          for (int i = 0; i < count; ++i)
            add_power(*static_cast<Dimension *>(dimension),
                      basic_units[i],
                      powers[i]);
          return UT_SUCCESS;
        },
        [](const ut_unit *,
           double,
           const ut_unit *underlying,
           double         offset,
           void          *dimension) {
          if (offset != 0.)
            static_cast<Dimension *>(dimension)->is_shifted = true;
          return ut_accept_visitor(underlying, &dimension_visitor(), dimension);
        },
        [](const ut_unit *, const ut_unit *, double, void *dimension) {
          static_cast<Dimension *>(dimension)->is_multiple = false;
          return UT_SUCCESS;
        },
        [](const ut_unit *, double, const ut_unit *, void *dimension) {
          static_cast<Dimension *>(dimension)->is_multiple = false;
          return UT_SUCCESS;
        }};
      return visitor;
    }



    Dimension
    dimension_of(const ut_unit *unit)
    {
      Dimension dimension;
      ut_accept_visitor(unit, &dimension_visitor(), &dimension);
      return dimension;
    }



    // Digits of a unit are exponents, behind a letter, a bracket or '^', with a
    // sign perhaps. UDUNITS would multiply with others: "9 .525 mm" is not
    // 4.7 mm; and "1'000 g" not 1 g times the 0th power of an arcminute.
    // Only the 1 of "1/Pa" may be there.
    bool
    has_number(const std::string &unit)
    {
      const auto is_digit = [](const char c) { return c >= '0' && c <= '9'; };
      const bool is_reciprocal =
        !unit.empty() && unit[0] == '1' &&
        unit.find_first_not_of(' ', 1) == unit.find('/');
      for (std::size_t i = is_reciprocal ? 1 : 0; i < unit.size(); ++i)
        {
          if (!is_digit(unit[i]) || (i > 0 && is_digit(unit[i - 1])))
            continue;
          std::size_t before = i;
          if (before > 0 &&
              (unit[before - 1] == '-' || unit[before - 1] == '+'))
            --before;
          if (before == 0)
            return true;
          const char c = unit[before - 1];
          if (std::isalpha(static_cast<unsigned char>(c)) == 0 && c != '^' &&
              c != ')' && !(before > 1 && unit.substr(before - 2, 2) == "**"))
            return true;
        }
      return !unit.empty() &&
             std::string(".,+-").find(unit[0]) != std::string::npos;
    }



    // A text that begins with a number: the number, and what is left.
    struct NumberAndRest
    {
      double      value;
      std::string number, rest;
    };



    // Larger and smaller numbers are slips, and their products overflow.
    bool
    is_of_usual_size(const double value)
    {
      return value == 0. || (std::abs(value) < 1e40 && std::abs(value) > 1e-40);
    }



    NumberAndRest
    split(const std::string &text, const std::string &example_of_one)
    {
      // from_chars() knows no language, no hexadecimal digits and no plus.
      const std::size_t begin =
        text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0;
      double     value = 0.;
      const auto result =
        std::from_chars(text.data() + begin, text.data() + text.size(), value);
      AssertThrow(result.ec != std::errc::invalid_argument &&
                    (result.ec == std::errc::result_out_of_range ||
                     std::isfinite(value)),
                  ExcInput(in_quotes(text) +
                           " does not start with a finite "
                           "number; write for example " +
                           example_of_one));
      const std::string number = text.substr(0, result.ptr - text.data());
      // Not every library says that a number has become zero.
      const bool is_nothing =
        value == 0. && number.substr(0, number.find_first_of("eE"))
                           .find_first_of("123456789") != std::string::npos;
      AssertThrow(result.ec != std::errc::result_out_of_range && !is_nothing &&
                    is_of_usual_size(value),
                  ExcInput(in_quotes(text) +
                           " starts with a number that is too large or too "
                           "small; numbers may be from 1e-40 to 1e40, or 0"));
      return {value,
              number,
              boost::algorithm::trim_copy(text.substr(number.size()))};
    }



    std::string
    example(const std::string &number, const std::string &si_unit)
    {
      constexpr std::size_t max_length = 20;
      return "'" + (number.size() <= max_length ? number : "1") +
             (si_unit.empty() ? "" : " " + si_unit) + "'";
    }

    // Convert with UDUNITS' own converter, which knows offsets and scales.
    double
    convert(const double value, const ut_unit *from, const ut_unit *to)
    {
      const std::unique_ptr<cv_converter, void (*)(cv_converter *)> converter(
        ut_get_converter(const_cast<ut_unit *>(from),
                         const_cast<ut_unit *>(to)),
        cv_free);
      return cv_convert_double(converter.get(), value);
    }



    // The unit that @p text names. @throws ExcInput unless it measures what
    // @p target does.
    Unit
    unit_like(const std::string &text,
              const ut_unit     *target,
              const std::string &usual)
    {
      Unit unit = text.size() > max_unit_length ? Unit(nullptr, ut_free)
                                                : parse_unit(text);
      AssertThrow(unit != nullptr,
                  ExcInput(in_quotes(text) +
                           " is not a unit that UDUNITS-2 "
                           "knows; write for example " +
                           usual));
      const Dimension dimension = dimension_of(unit.get());
      const Dimension wanted    = dimension_of(target);
      AssertThrow(dimension.is_multiple,
                  ExcInput(in_quotes(text) +
                           " is a logarithm or a date, not a multiple of a "
                           "unit; write for example " +
                           usual));
      AssertThrow(dimension.powers == wanted.powers,
                  ExcInput(in_quotes(text) +
                           " has the wrong dimension; a unit "
                           "such as in " +
                           usual + " is needed"));
      const std::map<std::string, int> temperature = {{"K", 1}};
      AssertThrow(!dimension.is_shifted || wanted.powers == temperature,
                  ExcInput(in_quotes(text) +
                           " has a zero of its own; a unit "
                           "such as in " +
                           usual + " is needed"));
      return unit;
    }
  } // namespace



  double
  Units::from_string(const std::string &text,
                     const std::string &si_unit,
                     const std::string &usual_unit)
  {
    const std::string shown_unit = usual_unit.empty() ? si_unit : usual_unit;
    const std::string trimmed    = boost::algorithm::trim_copy(text);
    const auto [value, number, unit_text] =
      split(trimmed, example("1", shown_unit));

    AssertThrow(!has_number(unit_text),
                ExcInput(in_quotes(trimmed) +
                         " has more than one number before its unit (a blank "
                         "inside the number, or a decimal comma, or a mark "
                         "between thousands?); write for example " +
                         example("1.5", shown_unit)));

    if (si_unit.empty())
      {
        AssertThrow(unit_text.empty(),
                    ExcInput(in_quotes(trimmed) +
                             " must be a number without a "
                             "unit, for example " +
                             example(number, "")));
        return value;
      }

    AssertThrow(!unit_text.empty(),
                ExcInput(in_quotes(trimmed) +
                         " has no unit; write for example " +
                         example(number, shown_unit)));
    const Unit target = parse_unit(si_unit);
    Assert(target != nullptr, dealii::ExcMessage("bad unit: " + si_unit));
    const Unit unit =
      unit_like(unit_text, target.get(), example(number, shown_unit));

    const double result = convert(value, unit.get(), target.get());
    AssertThrow(std::isfinite(result) && is_of_usual_size(result) &&
                  (result != 0. || value == 0.),
                ExcInput(in_quotes(trimmed) +
                         " is too large or too small; in " + si_unit +
                         " it may be from 1e-40 to 1e40, or 0"));
    return result;
  }



  std::vector<double>
  Units::list_from_string(const std::string &text,
                          const std::string &si_unit,
                          const std::string &usual_unit)
  {
    std::vector<std::string> parts;
    boost::algorithm::split(parts, text, boost::algorithm::is_any_of(","));

    std::vector<double> values;
    for (const std::string &part : parts)
      values.push_back(from_string(part, si_unit, usual_unit));
    return values;
  }



  namespace
  {
    double
    in_unit(const double       value,
            const std::string &si_unit,
            const std::string &shown_unit)
    {
      return si_unit.empty() || shown_unit == si_unit
               ? value
               : convert(value,
                         parse_unit(si_unit).get(),
                         parse_unit(shown_unit).get());
    }
  } // namespace



  std::string
  Units::to_string(const double       value,
                   const std::string &si_unit,
                   const std::string &shown_unit)
  {
    // The fewest digits that read back as the same number, but for the last
    // two: those are the rounding of the conversion.
    std::ostringstream out;
    out.precision(std::numeric_limits<double>::digits10 - 1);
    out << in_unit(value, si_unit, shown_unit);
    if (!si_unit.empty())
      out << ' ' << shown_unit;
    return out.str();
  }



  std::string
  Units::to_string(const double       value,
                   const std::string &si_unit,
                   const std::string &shown_unit,
                   const int          n_digits)
  {
    return significant_digits(in_unit(value, si_unit, shown_unit), n_digits) +
           (si_unit.empty() ? "" : " " + shown_unit);
  }
} // namespace Tribody

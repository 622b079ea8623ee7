// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/numbers.h>

#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/base/in_quotes.h>
#include <tribody/base/units.h>
#include <tribody/wear/wear_coefficient.h>

#include <algorithm>
#include <optional>
#include <regex>
#include <utility>

namespace Tribody
{
  namespace Wear
  {
    namespace
    {
      const std::string si_unit    = "Pa^-1";
      const std::string usual_unit = "mm^3/(N m)";

      // Regular expressions recurse; no coefficient is longer.
      constexpr std::size_t max_length = 200;



      // Signs beyond ASCII in the ways in which they are typed.
      std::string
      in_ascii(std::string text)
      {
        for (const auto &[sign, typed] :
             {std::make_pair("\u00d7", "x"),  std::make_pair("\u00b7", " "),
              std::make_pair("\u22c5", " "),  std::make_pair("\u00a0", " "),
              std::make_pair("\u202f", " "),  std::make_pair("\u2212", "-"),
              std::make_pair("\u2013", "-"),  std::make_pair("\u00b5", "u"),
              std::make_pair("\u03bc", "u"),  std::make_pair("\u207b", "^-"),
              std::make_pair("\u2070", "^0"), std::make_pair("\u00b9", "^1"),
              std::make_pair("\u00b2", "^2"), std::make_pair("\u00b3", "^3"),
              std::make_pair("\u2074", "^4"), std::make_pair("\u2075", "^5"),
              std::make_pair("\u2076", "^6"), std::make_pair("\u2077", "^7"),
              std::make_pair("\u2078", "^8"), std::make_pair("\u2079", "^9")})
          boost::algorithm::replace_all(text, sign, typed);
        // One exponent of several superscripts.
        boost::algorithm::replace_all(text, "^-^", "^-");
        return std::regex_replace(text,
                                  std::regex(R"((\^-?\d)\^(\d))"),
                                  "$1$2");
      }



      // "26 x 1e-8 ..." -> "26e-8 ...", so that the number is rounded once. The
      // power may have lost its superscript: "26 x 10-8 ...".
      std::string
      with_one_number(const std::string &text)
      {
        static const std::regex product(
          R"(([-+]?[0-9.]+)(?:[eE]([-+]?\d{1,3}))?)"
          R"((?:(?: *[xX*] *| +)(?:1[eE]|10 ?(?:\^|\*\*))| *[xX*] *10(?=[-+])))"
          R"(([-+]?\d{1,3})(?![\d.])(.*))");
        static const std::regex power(
          R"(10(?:\^|\*\*)([-+]?\d{1,3})(?![\d.])(.*))");
        std::smatch match;
        if (std::regex_match(text, match, product))
          {
            const int exponent =
              (match[2].matched ? std::stoi(match.str(2)) : 0) +
              std::stoi(match.str(3));
            return match.str(1) + "e" + std::to_string(exponent) + match.str(4);
          }
        if (std::regex_match(text, match, power))
          return "1e" + match.str(1) + match.str(2);
        return text;
      }



      // Behind the only slash stands what divides, in brackets or not.
      std::string
      with_one_divisor(const std::string &unit)
      {
        const std::size_t slash = unit.find('/');
        if (std::count(unit.begin(), unit.end(), '/') != 1)
          return unit;
        const std::string divisor =
          boost::algorithm::trim_copy(unit.substr(slash + 1));
        const bool is_one_factor =
          divisor.find_first_of(" *") == std::string::npos;
        const bool has_brackets = boost::algorithm::starts_with(divisor, "(") &&
                                  divisor.find(')') == divisor.size() - 1;
        if (is_one_factor || has_brackets)
          return unit;
        return unit.substr(0, slash + 1) + "(" + divisor + ")";
      }



      std::string
      plain_unit(std::string unit)
      {
        for (const auto &[pattern, replacement] :
             {// The abbreviation of inch, "in.3".
              std::make_pair(R"(\bin\.(?=\^?\d))", "in"),
              // A sign of multiplication, not of an exponent.
              std::make_pair(R"(([\w)])[-.](?=[A-Za-z(]))", "$1 "),
              std::make_pair(R"(\b([kM]?N)([mck]?m)\b)", "$1 $2"),
              std::make_pair(R"(\blbs?\b)", "lbf"),
              std::make_pair(R"(\bhrs\b)", "hr")})
          unit = std::regex_replace(unit, std::regex(pattern), replacement);
        return with_one_divisor(unit);
      }



      // "2 um/km at 1 MPa"; nothing if it is not written like that.
      std::optional<double>
      from_depth_rate(const std::string &text)
      {
        const std::string at    = " at ";
        const std::size_t place = text.find(at);
        if (place == std::string::npos)
          return {};
        const std::string rate =
          boost::algorithm::trim_copy(text.substr(0, place));
        const std::string pressure =
          boost::algorithm::trim_copy(text.substr(place + at.size()));
        const double value = Units::from_string(pressure, "Pa", "MPa");
        AssertThrow(value > 0.,
                    ExcInput("the pressure " + in_quotes(pressure) +
                             " must be positive"));
        return Units::from_string(rate, "m/m", "um/km") / value;
      }



      // What Units::from_string() reads; otherwise @p problem is what it says.
      std::optional<double>
      from_plain_string(const std::string &text, std::string &problem)
      {
        try
          {
            return Units::from_string(text, si_unit, usual_unit);
          }
        catch (const ExcInput &exception)
          {
            problem = message_of(exception);
            return {};
          }
      }
    } // namespace



    std::string
    plain_spelling(const std::string &text)
    {
      if (text.size() > max_length)
        return text;
      static const std::regex number_and_unit(
        R"(([-+]?[0-9.]+(?:[eE][-+]?\d+)?)(.*))");
      const std::string ascii =
        with_one_number(boost::algorithm::trim_copy(in_ascii(text)));
      std::smatch match;
      if (!std::regex_match(ascii, match, number_and_unit))
        return text;
      return match.str(1) + plain_unit(match.str(2));
    }



    double
    coefficient_from_string(const std::string &text)
    {
      std::string problem;
      if (const auto value = from_plain_string(text, problem))
        return *value;
      try
        {
          if (text.size() <= max_length)
            {
              if (const auto value = from_depth_rate(in_ascii(text)))
                return *value;
              if (const auto value =
                    from_plain_string(plain_spelling(text), problem))
                return *value;
            }
        }
      catch (const ExcInput &exception)
        {
          problem = message_of(exception);
        }
      throw ExcInput(problem +
                     ". Spellings of data sheets: '5e-4 mm3/Nm', '26 x 1e-8 "
                     "mm3/Nm', '13e-10 in3 min/(ft lb hr)', '2 um/km at 1 "
                     "MPa'");
    }



    double
    local_coefficient(const double coefficient, const CoefficientBasis basis)
    {
      return basis == CoefficientBasis::local
               ? coefficient
               : coefficient / (4. / dealii::numbers::PI);
    }
  } // namespace Wear
} // namespace Tribody

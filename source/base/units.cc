// SPDX-License-Identifier: LGPL-2.1-or-later

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <tribody/base/exceptions.h>
#include <tribody/base/units.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <sstream>
#include <udunits2.h>

namespace Tribody
{
  namespace
  {
    using Unit       = std::unique_ptr<ut_unit, void (*)(ut_unit *)>;
    using UnitSystem = std::unique_ptr<ut_system, void (*)(ut_system *)>;

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
      // Everyday spelling that the database does not have.
      const Unit degree(ut_get_unit_by_name(system.get(), "arc_degree"),
                        ut_free);
      ut_map_symbol_to_unit("deg", UT_ASCII, degree.get());
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
      return Unit(ut_parse(unit_system(), text.c_str(), UT_ASCII), ut_free);
    }

    // Radians are dimensionless for UDUNITS, so "30 Hz" would pass for
    // "30 rad/s", wrong by 2 pi. Whether the definition of a unit contains the
    // radian tells them apart.
    bool
    counts_angle(const ut_unit *unit)
    {
      char      buffer[256];
      const int length =
        ut_format(unit, buffer, sizeof(buffer), UT_ASCII | UT_DEFINITION);
      return length > 0 &&
             std::string(buffer, length).find("rad") != std::string::npos;
    }

    std::string
    example(const std::string &number, const std::string &si_unit)
    {
      return "'" + number + (si_unit.empty() ? "" : " " + si_unit) + "'";
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
  } // namespace



  double
  Units::from_string(const std::string &text,
                     const std::string &si_unit,
                     const std::string &usual_unit)
  {
    const std::string shown_unit = usual_unit.empty() ? si_unit : usual_unit;
    const std::string trimmed    = boost::algorithm::trim_copy(text);

    char        *rest  = nullptr;
    const double value = std::strtod(trimmed.c_str(), &rest);
    AssertThrow(rest != trimmed.c_str() && std::isfinite(value),
                ExcInput("'" + trimmed +
                         "' does not start with a finite "
                         "number; write for example " +
                         example("1", shown_unit)));

    const std::string number(trimmed.c_str(), static_cast<const char *>(rest));
    const std::string unit_text =
      boost::algorithm::trim_copy(std::string(rest));

    // UDUNITS would multiply: "9 .525 mm" is not 4.7 mm.
    AssertThrow(unit_text.empty() ||
                  std::string("0123456789.,+-").find(unit_text[0]) ==
                    std::string::npos,
                ExcInput("'" + trimmed +
                         "' has more than one number before its unit (a blank "
                         "inside the number, or a decimal comma?); write for "
                         "example " +
                         example("1.5", shown_unit)));

    if (si_unit.empty())
      {
        AssertThrow(unit_text.empty(),
                    ExcInput("'" + trimmed +
                             "' must be a number without a "
                             "unit, for example " +
                             example(number, "")));
        return value;
      }

    AssertThrow(!unit_text.empty(),
                ExcInput("'" + trimmed + "' has no unit; write for example " +
                         example(number, shown_unit)));

    const Unit unit = parse_unit(unit_text);
    AssertThrow(unit != nullptr,
                ExcInput("'" + unit_text +
                         "' is not a unit that UDUNITS-2 "
                         "knows; write for example " +
                         example(number, shown_unit)));

    const Unit target = parse_unit(si_unit);
    Assert(target != nullptr, dealii::ExcMessage("bad unit: " + si_unit));
    AssertThrow(ut_are_convertible(unit.get(), target.get()) != 0 &&
                  counts_angle(unit.get()) == counts_angle(target.get()),
                ExcInput("'" + unit_text +
                         "' has the wrong dimension; a unit "
                         "such as in " +
                         example(number, shown_unit) + " is needed"));
    return convert(value, unit.get(), target.get());
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



  std::string
  Units::to_string(const double       value,
                   const std::string &si_unit,
                   const std::string &shown_unit)
  {
    double shown = value;
    if (!si_unit.empty() && shown_unit != si_unit)
      shown =
        convert(value, parse_unit(si_unit).get(), parse_unit(shown_unit).get());

    // The fewest digits that read back as the same number, but for the last
    // two: those are the rounding of the conversion.
    std::ostringstream out;
    out.precision(std::numeric_limits<double>::digits10 - 1);
    out << shown;
    if (!si_unit.empty())
      out << ' ' << shown_unit;
    return out.str();
  }
} // namespace Tribody

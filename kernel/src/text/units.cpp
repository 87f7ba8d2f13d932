#include "delos/text/units.h"

#include <cmath>

#include "delos/text/numbers.h"
#include "text/unit_system.h"

namespace delos {
namespace {

/// How messages speak of a dimension.
struct Quantity {
  const char* dimension;
  const char* noun;
  const char* example;
};

constexpr Quantity kQuantities[] = {
    {"1", "a pure number", "0.5"},
    {"m", "a length", "50 mm"},
    {"rad", "an angle", "60 deg"},
    {"s^-1", "a frequency", "100 Hz"},
    {"s", "a time", "5 ms"},
    {"px", "a number of pixels", "0.5 px"},
    {"m s^-1", "a speed", "2 m/s"},
    {"m s^-2", "an acceleration", "9.8 m/s^2"},
    {"rad s^-1", "a turn rate", "30 deg/s"},
    {"m^2", "an area", "4 mm^2"},
    {"kg", "a mass", "2 kg"},
};

const Quantity* known_quantity(const Dimension& dimension) {
  const std::string text = to_string(dimension);
  for (const Quantity& q : kQuantities)
    if (text == q.dimension) return &q;
  return nullptr;
}

/// "expected a length such as '50 mm'"
std::string expected(std::string_view si_unit) {
  const UnitLookup& wanted = find_unit(si_unit);
  const Quantity* known =
      wanted.unit ? known_quantity(wanted.unit->dimension) : nullptr;
  if (!known) return "expected a number in " + std::string(si_unit);
  return std::string("expected ") + known->noun + " such as '" + known->example + '\'';
}

std::string_view trimmed(std::string_view text) {
  constexpr const char* kBlank = " \t";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

}  // namespace

std::variant<double, std::string> parse_quantity(std::string_view text,
                                                 std::string_view si_unit) {
  text = trimmed(text);
  const std::string quoted = '\'' + std::string(text) + '\'';
  const NumberText number = scan_number(text);
  if (!number.problem.empty()) return number.problem;
  if (number.length == 0) return expected(si_unit) + ", not " + quoted;
  const std::string_view unit_text = trimmed(text.substr(number.length));
  if (unit_text.empty()) return number.value;

  // To UDUNITS they are minutes and seconds of arc.
  if (si_unit == "m" && (unit_text == "'" || unit_text == "\""))
    return quoted + " isn't a length; write '" +
           std::string(text.substr(0, number.length)) +
           (unit_text == "'" ? " ft'" : " in'");
  if (si_unit == "m" && unit_text.front() == '\'')
    return quoted + " mixes feet and inches; write one of them, such as '98 in'";

  const UnitLookup& given = find_unit(unit_text);
  if (!given.unit) return given.problem + "; " + expected(si_unit);
  const UnitLookup& wanted = find_unit(si_unit);
  if (!wanted.unit)
    return quoted + " has a unit; write the number alone, in " + std::string(si_unit);
  if (given.unit->dimension != wanted.unit->dimension) {
    const Quantity* is = known_quantity(given.unit->dimension);
    return quoted +
           (is ? std::string(" is ") + is->noun
               : " is in " + to_string(given.unit->dimension)) +
           "; " + expected(si_unit) +
           (si_unit == "m" && unit_text == "px"
                ? "; a focal length in pixels times the pitch is one in metres"
                : "");
  }

  double value;
  if (given.unit->exponent && wanted.unit->exponent) {
    value = scaled_decimal(text.substr(0, number.length),
                           *given.unit->exponent - *wanted.unit->exponent);
  } else {
    value =
        given.unit->scale * (number.value + given.unit->offset) / wanted.unit->scale -
        wanted.unit->offset;
  }
  if (!std::isfinite(value)) return quoted + " is beyond the range of a double";
  return value;
}

}  // namespace delos

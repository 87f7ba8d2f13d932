// Numbers in whatever unit a device's readings have.
#pragma once

#include <optional>
#include <variant>

#include "delos/text/units.h"
#include "document/reader.h"

namespace delos {

/// Which of them it is, only the plugin knows.
inline std::optional<double> read_in_any_unit(Reader& reader, const Place& at) {
  if (!reader.expect(at, Node::Kind::scalar, "a number")) return std::nullopt;
  for (const char* unit : {"1", "m", "rad", "px", "s", "m/s", "rad/s", "m/s^2"}) {
    const auto parsed = parse_quantity(at.node().text, unit);
    if (const auto* number = std::get_if<double>(&parsed)) return *number;
  }
  return reader.number(at, "1");  // which says what is wrong
}

}  // namespace delos

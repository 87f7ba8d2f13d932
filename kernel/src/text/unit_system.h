// What a unit's text means: its dimension, scale and offset. The only user of
// UDUNITS-2.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace delos {

/// Powers of base units: {{"m", 1}, {"s", -2}}. Unlike in UDUNITS, angles and pixels
/// are dimensions of their own, and a period isn't a frequency.
using Dimension = std::map<std::string, int>;

/// x of this unit is scale·(x + offset) in SI.
struct Unit {
  Dimension dimension;
  double scale = 1;
  double offset = 0;
  std::optional<int> exponent;  ///< set where the scale is 10^exponent
};

/// What came of a unit's text.
struct UnitLookup {
  std::optional<Unit> unit;
  std::string problem;  ///< where there is no unit: a sentence that says why
};

/// Look up a unit such as "mm", "m/s^2" or "%". Reads the UDUNITS database on first use
/// and remembers texts; safe to call from several threads.
[[nodiscard]] const UnitLookup& find_unit(std::string_view text);

/// "m s^-2"; "1" where there is no dimension.
[[nodiscard]] std::string to_string(const Dimension& dimension);

}  // namespace delos

#include "delos/text/format.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

#include "delos/text/number_text.h"

namespace delos {
namespace {

struct Prefix {
  const char* name;
  double size;    ///< SI units per prefixed unit
  double factor;  ///< its inverse, exact where it can be
};

constexpr std::array kPrefixes = {Prefix{"G", 1e9, 1e-9}, Prefix{"M", 1e6, 1e-6},
                                  Prefix{"k", 1e3, 1e-3}, Prefix{"", 1, 1},
                                  Prefix{"m", 1e-3, 1e3}, Prefix{"µ", 1e-6, 1e6},
                                  Prefix{"n", 1e-9, 1e9}};

/// Whether people use this prefix with this base unit: kilometres but no kiloseconds.
bool customary(const Prefix& prefix, std::string_view base) {
  if (prefix.size > 1) return base == "Hz" || (base == "m" && prefix.size == 1e3);
  if (prefix.size < 1) return base != "Hz";
  return true;
}

}  // namespace

DisplayUnit display_unit(double si, std::string_view unit) {
  if (unit == "1") return {};
  const std::string_view base = unit.substr(0, unit.find('/'));
  const std::string rest{unit.substr(base.size())};
  if (base == "rad") return {"deg" + rest, 180 / std::numbers::pi};

  const bool prefixed = base == "m" || base == "m^2" || base == "s" || base == "Hz";
  const bool square = base == "m^2";
  // A square's next unit is a million times smaller: thousandths are still handy.
  const double size = square ? std::sqrt(1e3 * std::abs(si)) : std::abs(si);
  if (!prefixed || !std::isfinite(si) || size == 0) return {std::string{unit}, 1};
  for (const Prefix& prefix : kPrefixes) {
    if (!customary(prefix, base) || size < prefix.size) continue;
    return {prefix.name + std::string{unit},
            square ? prefix.factor * prefix.factor : prefix.factor};
  }
  if (base == "Hz") return {std::string{unit}, 1};
  return {"n" + std::string{unit}, square ? 1e18 : 1e9};
}

std::string format_quantity(double si, std::string_view unit, int digits) {
  if (std::isnan(si)) return "undefined";
  if (std::isinf(si)) return si > 0 ? "∞" : "-∞";
  // The unit follows the rounded number, so that 0.9999 m is "1 m" and not "1000 mm".
  const DisplayUnit exact = display_unit(si, unit);
  const std::string first = rounded(si * exact.factor, digits);
  double kept = 0;
  std::from_chars(first.data(), first.data() + first.size(), kept);
  const DisplayUnit shown = display_unit(kept / exact.factor, unit);
  const std::string number =
      shown.name == exact.name ? first : rounded(si * shown.factor, digits);
  return shown.name.empty() ? number : number + " " + shown.name;
}

}  // namespace delos

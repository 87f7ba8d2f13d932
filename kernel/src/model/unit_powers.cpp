#include "model/unit_powers.h"

#include <cstdlib>

namespace delos {
namespace {

constexpr std::array<const char*, 3> kBases = {"m", "rad", "s"};

}  // namespace

UnitPowers::UnitPowers(std::string_view unit) {
  double sign = 1;
  while (!unit.empty()) {
    const std::size_t end = std::min(unit.find_first_of(" /"), unit.size());
    const std::string_view factor = unit.substr(0, end);
    const std::size_t hat = factor.find('^');
    const std::string_view base = factor.substr(0, hat);
    const double power =
        hat == std::string_view::npos
            ? 1
            : std::strtod(std::string(factor.substr(hat + 1)).c_str(), nullptr);
    const auto known = std::find(kBases.begin(), kBases.end(), base);
    if (known != kBases.end())
      this->power[static_cast<std::size_t>(known - kBases.begin())] += sign * power;
    if (end == unit.size()) break;
    sign = unit[end] == '/' ? -1 : 1;
    unit.remove_prefix(end + 1);
  }
}

std::optional<std::string> UnitPowers::text() const {
  if (lost) return std::nullopt;
  std::string above, below;
  const bool over =
      std::any_of(power.begin(), power.end(), [](double p) { return p > 0; });
  for (std::size_t i = 0; i < kBases.size(); ++i) {
    const double p = power[i];
    if (p != std::round(p)) return std::nullopt;
    if (p == 0) continue;
    // What is divided by stands behind a stroke, where there is something to divide.
    const bool divides = p < 0 && over && i == 2;
    const int shown = static_cast<int>(divides ? -p : p);
    std::string& side = divides ? below : above;
    side += (side.empty() ? "" : " ") + std::string(kBases[i]) +
            (shown == 1 ? "" : "^" + std::to_string(shown));
  }
  if (above.empty() && below.empty()) return "1";
  return below.empty() ? above : above + "/" + below;
}

}  // namespace delos

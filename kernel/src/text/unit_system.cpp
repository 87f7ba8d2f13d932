#include "text/unit_system.h"

#include <udunits2.h>

#include <cctype>
#include <cmath>
#include <iterator>
#include <mutex>
#include <vector>

#include "text/nearest.h"

namespace delos {
namespace {

/// Units that people mean where they mistype one.
const std::vector<std::string> kCommon = {
    "m",    "mm",   "cm",    "km",  "um",  "in",    "ft",    "rad",   "deg",
    "mrad", "s",    "ms",    "us",  "min", "Hz",    "kHz",   "MHz",   "px",
    "%",    "kg",   "g",     "m/s", "N",   "m/s^2", "rad/s", "deg/s", "rad/s^2",
    "m^2",  "mm^2", "deg^2", "K",   "Pa",  "V",     "A",     "T"};

/// Collects a unit's parts while UDUNITS walks over it.
struct Walk {
  Unit unit;
  bool linear = true;
};

std::string symbol_of(const ut_unit* unit) {
  const char* symbol = ut_get_symbol(unit, UT_ASCII);
  if (!symbol) symbol = ut_get_name(unit, UT_ASCII);
  return symbol ? symbol : "?";
}

ut_status visit_basic(const ut_unit* unit, void* walk) {
  static_cast<Walk*>(walk)->unit.dimension[symbol_of(unit)] += 1;
  return UT_SUCCESS;
}

ut_status visit_product(const ut_unit*, int count, const ut_unit* const* basic,
                        const int* powers, void* walk) {
  for (int i = 0; i < count; ++i)
    static_cast<Walk*>(walk)->unit.dimension[symbol_of(basic[i])] += powers[i];
  return UT_SUCCESS;
}

ut_status visit_not_linear(Walk& walk) {
  walk.linear = false;
  return UT_SUCCESS;
}

ut_status visit_timestamp(const ut_unit*, const ut_unit*, double, void* walk) {
  return visit_not_linear(*static_cast<Walk*>(walk));
}

ut_status visit_logarithmic(const ut_unit*, double, const ut_unit*, void* walk) {
  return visit_not_linear(*static_cast<Walk*>(walk));
}

ut_status visit_galilean(const ut_unit*, double scale, const ut_unit* underlying,
                         double offset, void* walk);

const ut_visitor kVisitor = {visit_basic, visit_product, visit_galilean,
                             visit_timestamp, visit_logarithmic};

ut_status visit_galilean(const ut_unit*, double scale, const ut_unit* underlying,
                         double offset, void* walk) {
  // A Galilean unit's underlying unit is never Galilean itself.
  auto& own = static_cast<Walk*>(walk)->unit;
  own.scale = scale;
  own.offset = offset;
  return ut_accept_visitor(underlying, &kVisitor, walk);
}

/// 10^exponent where that is what the scale means; products of prefixes are rounded.
std::optional<int> decimal_exponent(double scale) {
  if (!(scale > 0) || !std::isfinite(scale)) return std::nullopt;
  const int exponent = static_cast<int>(std::lround(std::log10(scale)));
  if (std::abs(scale / std::pow(10.0, exponent) - 1) > 1e-14) return std::nullopt;
  return exponent;
}

/// Factors of a unit, as in "m 2", are no part of how people write quantities; "1/s"
/// is.
bool has_stray_number(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!std::isdigit(static_cast<unsigned char>(text[i]))) continue;
    if (i == 0 && text.size() > 1 && text[0] == '1' &&
        (text[1] == '/' || text[1] == ' '))
      continue;
    if (i == 0 || std::isspace(static_cast<unsigned char>(text[i - 1])) ||
        text[i - 1] == '*' || text[i - 1] == '/' || text[i - 1] == '.')
      return true;
  }
  return false;
}

class UnitSystem {
 public:
  UnitSystem() {
    ut_set_error_message_handler(ut_ignore);
    system_ = ut_read_xml(nullptr);
    if (!system_) return;
    ut_unit* pixel = ut_new_base_unit(system_);
    ut_map_unit_to_symbol(pixel, "px", UT_ASCII);
    ut_map_symbol_to_unit("px", UT_ASCII, pixel);
    ut_map_name_to_unit("pixel", UT_ASCII, pixel);
    ut_map_name_to_unit("pixels", UT_ASCII, pixel);
    ut_free(pixel);
    if (ut_unit* degree = ut_get_unit_by_name(system_, "degree")) {
      ut_map_symbol_to_unit("deg", UT_ASCII, degree);
      ut_free(degree);
    }
  }

  const UnitLookup& find(std::string_view text) {
    const std::lock_guard lock(mutex_);
    const auto known = cache_.find(text);
    if (known != cache_.end()) return known->second;
    return cache_.emplace(std::string(text), look_up(std::string(text))).first->second;
  }

 private:
  UnitLookup look_up(const std::string& text) const {
    const auto refuse = [](std::string problem) {
      return UnitLookup{std::nullopt, std::move(problem)};
    };
    if (!system_)
      return refuse(
          "units can't be read: the UDUNITS database udunits2.xml isn't installed; "
          "write "
          "the number in SI without a unit");
    if (text == "1") return {Unit{{}, 1, 0, 0}, {}};
    ut_unit* parsed =
        has_stray_number(text) ? nullptr : ut_parse(system_, text.c_str(), UT_UTF8);
    if (!parsed) {
      const std::string meant = nearest(text, kCommon);
      return refuse("unknown unit '" + text + '\'' +
                    (meant.empty() ? "" : "; did you mean '" + meant + "'?"));
    }
    Walk walk;
    const ut_status status = ut_accept_visitor(parsed, &kVisitor, &walk);
    ut_free(parsed);
    if (status != UT_SUCCESS || !walk.linear)
      return refuse('\'' + text +
                    "' is a logarithmic unit or a date; write the value in SI");
    std::erase_if(walk.unit.dimension,
                  [](const auto& power) { return power.second == 0; });
    if (walk.unit.offset == 0) walk.unit.exponent = decimal_exponent(walk.unit.scale);
    return {std::move(walk.unit), {}};
  }

  ut_system* system_ = nullptr;
  std::mutex mutex_;
  std::map<std::string, UnitLookup, std::less<>> cache_;  // its nodes never move
};

}  // namespace

const UnitLookup& find_unit(std::string_view text) {
  // Never destroyed: units may be asked for by destructors of other statics.
  static auto& system = *new UnitSystem;
  return system.find(text);
}

std::string to_string(const Dimension& dimension) {
  std::string text;
  for (const auto& [symbol, power] : dimension) {
    if (!text.empty()) text += ' ';
    text += symbol;
    if (power != 1) text += '^' + std::to_string(power);
  }
  return text.empty() ? "1" : text;
}

}  // namespace delos

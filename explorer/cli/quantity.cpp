#include "quantity.h"

#include "command.h"
#include "delos/text/units.h"

namespace delos::cli {
namespace {

double quantity_on_line(const std::string& text, const char* unit, const char* option) {
  const auto value = parse_quantity(text, unit);
  if (const auto* problem = std::get_if<std::string>(&value))
    throw Failure{kUsage, std::string(option) + " '" + text + "': " + *problem};
  return std::get<double>(value);
}

}  // namespace

double quantity_above_0(const std::string& text, const char* unit, const char* option) {
  const double value = quantity_on_line(text, unit, option);
  if (value > 0) return value;
  throw Failure{kUsage, std::string(option) + " '" + text + "': must be above 0"};
}

double quantity_from_0(const std::string& text, const char* unit, const char* option) {
  if (text.empty()) return 0;
  const double value = quantity_on_line(text, unit, option);
  if (value >= 0) return value;
  throw Failure{kUsage, std::string(option) + " '" + text + "': must not be below 0"};
}

}  // namespace delos::cli

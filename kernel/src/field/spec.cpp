#include "delos/field/spec.h"

#include <cmath>

#include "delos/text/units.h"

namespace delos {
namespace {

constexpr const char* kExample =
    "write METRIC <= VALUE or METRIC >= VALUE, such as 'eigmax <= 1 mm' or "
    "'coverage >= 3'";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool meets(double value, Relation relation, double limit) {
  switch (relation) {
    case Relation::below:
      return value < limit;
    case Relation::at_most:
      return value <= limit;
    case Relation::at_least:
      return value >= limit;
    case Relation::above:
      return value > limit;
  }
  return false;
}

}  // namespace

std::variant<Spec, std::string> parse_spec(std::string_view text,
                                           const KnownMetrics& known) {
  const std::size_t sign = text.find_first_of("<>");
  if (sign == std::string_view::npos) return std::string(kExample);
  const bool or_equal = text.substr(sign + 1).starts_with('=');
  const std::string_view value = trimmed(text.substr(sign + (or_equal ? 2 : 1)));
  if (value.empty() || value.find_first_of("<>=") != std::string_view::npos)
    return std::string(kExample);
  const auto metric = parse_metric(trimmed(text.substr(0, sign)), known);
  if (const auto* problem = std::get_if<std::string>(&metric)) return *problem;

  Spec spec{std::string(trimmed(text)), std::get<Metric>(metric), {}, 0};
  spec.relation = text[sign] == '<' ? (or_equal ? Relation::at_most : Relation::below)
                                    : (or_equal ? Relation::at_least : Relation::above);
  const auto limit = parse_quantity(value, spec.metric.unit);
  if (const auto* problem = std::get_if<std::string>(&limit)) return *problem;
  spec.limit = std::get<double>(limit);
  return spec;
}

SpecShare share_meeting(const Field& field, const Spec& spec) {
  SpecShare share;
  double met = 0, all = 0;
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    if (!field.inside.empty() && field.inside[i]) continue;
    const double weight = field.weight.empty() ? 1 : field.weight[i];
    ++share.samples;
    all += weight;
    if (!std::isfinite(field.value[i]) ||
        !meets(field.value[i], spec.relation, spec.limit))
      continue;
    ++share.met;
    met += weight;
  }
  share.share = all > 0 ? met / all : 0;
  if (field.spread) share.share = share_meeting(*field.spread, spec).share;
  return share;
}

}  // namespace delos

#include "delos/model/metric.h"

#include <algorithm>
#include <map>

namespace delos {
namespace {

struct NamedKind {
  const char* name;
  MetricKind kind;
  bool larger_is_better;
};

constexpr NamedKind kKinds[] = {
    {"sigma_position", MetricKind::sigma_position, false},
    {"sigma_orientation", MetricKind::sigma_orientation, false},
    {"eigmax", MetricKind::eigmax, false},
    {"eiglen", MetricKind::eiglen, false},
    {"mle", MetricKind::mle, true},
    {"trace", MetricKind::trace, false},
    {"det", MetricKind::det, false},
    {"coverage", MetricKind::coverage, true},
    {"latency", MetricKind::latency, false},
};

bool has(const StateLayout& layout, MetricKind kind) {
  if (kind == MetricKind::sigma_position) return layout.pose != PoseState::orientation;
  if (kind == MetricKind::sigma_orientation) return layout.pose != PoseState::position;
  return true;
}

/// "m^-6 s^3": the inverse of the product of all states' units.
std::string likelihood_unit(const StateLayout& layout) {
  std::map<std::string, int> powers;
  for (const std::string& unit : layout.units()) {
    if (unit == "1") continue;
    const auto slash = unit.find('/');
    --powers[unit.substr(0, slash)];
    if (slash != std::string::npos) powers["s"] += unit.ends_with("^2") ? 2 : 1;
  }
  std::string text;
  for (const auto& [unit, power] : powers) {
    if (power == 0) continue;
    if (!text.empty()) text += ' ';
    text += unit + "^" + std::to_string(power);
  }
  return text.empty() ? "1" : text;
}

std::string unit_of(MetricKind kind, const StateLayout& layout) {
  const std::string block = layout.pose == PoseState::orientation ? "rad" : "m";
  switch (kind) {
    case MetricKind::sigma:
    case MetricKind::coverage:
      break;
    case MetricKind::sigma_position:
      return "m";
    case MetricKind::sigma_orientation:
      return "rad";
    case MetricKind::eigmax:
    case MetricKind::eiglen:
      return block;
    case MetricKind::mle:
      return likelihood_unit(layout);
    case MetricKind::trace:
      return block + "^2";
    case MetricKind::det:
      return block + "^6";
    case MetricKind::latency:
      return "s";
  }
  return "1";
}

}  // namespace

std::variant<Metric, std::string> parse_metric(std::string_view name,
                                               const StateLayout& layout) {
  for (const NamedKind& k : kKinds) {
    if (name != k.name || !has(layout, k.kind)) continue;
    return Metric{k.kind, 0, std::string(name), unit_of(k.kind, layout),
                  k.larger_is_better};
  }
  const std::vector<std::string> states = layout.names(), units = layout.units();
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (name == "sigma_" + states[i]) {
      return Metric{MetricKind::sigma, static_cast<int>(i), std::string(name), units[i],
                    false};
    }
  }
  std::string message = "unknown metric '" + std::string(name) + "'; this state has";
  for (const std::string& known : metric_names(layout)) message += " " + known;
  return message;
}

std::vector<std::string> metric_names(const StateLayout& layout) {
  std::vector<std::string> names;
  for (const std::string& state : layout.names()) names.push_back("sigma_" + state);
  for (const NamedKind& k : kKinds) {
    if (has(layout, k.kind)) names.emplace_back(k.name);
  }
  return names;
}

}  // namespace delos

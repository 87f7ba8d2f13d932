#include "delos/model/metric.h"

#include <algorithm>
#include <map>

#include "delos/model/metric_table.h"

namespace delos {
namespace {

bool has(const StateLayout& layout, MetricReads reads) {
  if (reads == MetricReads::position || reads == MetricReads::horizontal)
    return layout.positions() > 0;
  if (reads == MetricReads::orientation) return layout.turns() > 0;
  if (reads == MetricReads::block) return layout.block() > 0;
  return reads != MetricReads::one_state;  // named by their states
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

std::string unit_of(const MetricRow& row, const StateLayout& layout) {
  if (row.kind == MetricKind::mle) return likelihood_unit(layout);
  if (row.kind == MetricKind::footprint) return "m";
  if (row.reads == MetricReads::devices || row.reads == MetricReads::readings)
    return "1";
  if (row.reads == MetricReads::closed_loop) return "s";
  const bool turns = row.reads == MetricReads::orientation ||
                     (row.reads == MetricReads::block && layout.positions() == 0);
  const std::string unit = turns ? "rad" : "m";
  const int power =
      row.kind == MetricKind::det ? row.power * layout.block() : row.power;
  return power == 1 ? unit : unit + "^" + std::to_string(power);
}

}  // namespace

std::variant<Metric, std::string> parse_metric(std::string_view name,
                                               const KnownMetrics& known) {
  const StateLayout& layout = known.layout;
  for (const Metric& own : known.own)
    if (name == own.name) return own;
  for (const MetricRow& row : metric_table()) {
    if (name != row.name || !has(layout, row.reads)) continue;
    return Metric{
        row.kind, 0,      std::string(name), unit_of(row, layout), row.larger_is_better,
        true,     nullptr};
  }
  const std::vector<std::string> states = layout.names(), units = layout.units();
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (name == row_of(MetricKind::sigma).name + states[i]) {
      return Metric{MetricKind::sigma,
                    static_cast<int>(i),
                    std::string(name),
                    units[i],
                    row_of(MetricKind::sigma).larger_is_better,
                    true,
                    nullptr};
    }
  }
  std::string message = "unknown metric '" + std::string(name) + "'; this state has";
  for (const std::string& other : metric_names(known)) message += " " + other;
  return message;
}

std::vector<std::string> metric_names(const KnownMetrics& known) {
  const StateLayout& layout = known.layout;
  std::vector<std::string> names;
  for (const std::string& state : layout.names())
    names.push_back(row_of(MetricKind::sigma).name + state);
  for (const MetricRow& row : metric_table()) {
    if (has(layout, row.reads)) names.emplace_back(row.name);
  }
  for (const Metric& own : known.own) names.push_back(own.name);
  return names;
}

}  // namespace delos

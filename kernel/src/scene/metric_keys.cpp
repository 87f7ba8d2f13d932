#include "scene/metric_keys.h"

#include <algorithm>

#include "delos/model/metric_expression.h"
#include "delos/scene/definition.h"
#include "document/node_text.h"

namespace delos {
namespace {

using namespace shapes;
using Written = std::optional<Node>;

constexpr std::pair<const char*, bool> kBetterWords[] = {{"less", false},
                                                         {"more", true}};

constexpr std::array<Key<MetricEntry>, 3> kMetricKeys = {{
    member_key<&MetricEntry::expression>("expression", Need::required,
                                         "a formula of metrics, P[x, y] and x, y, z",
                                         text()),
    {"better", Need::optional, "which is better: less or more", choice<kBetterWords>(),
     [](Reader& r, const Place& p, MetricEntry& m) {
       if (const auto more = r.choice(p, kBetterWords)) m.larger_is_better = *more;
     },
     [](const MetricEntry& m) -> Written {
       return to_node(std::string(m.larger_is_better ? "more" : "less"));
     }},
    other_key<&MetricEntry::unit>("unit", Need::optional,
                                  "of its numbers, where the formula leaves it open",
                                  text()),
}};

/// Formulas and specifications must be able to say it, and to mean nothing else.
std::string name_problem(const std::string& name, const KnownMetrics& known) {
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  const bool is_word = !name.empty() && is_letter(name[0]) &&
                       std::all_of(name.begin(), name.end(), [&](char c) {
                         return is_letter(c) || (c >= '0' && c <= '9');
                       });
  if (!is_word) return "isn't a name: letters, digits and '_', a letter first";
  std::vector<std::string> taken = metric_names(known);
  taken.insert(taken.end(), {"x", "y", "z", "P", "pi"});
  if (std::find(taken.begin(), taken.end(), name) != taken.end())
    return "has a meaning already; take another name";
  return "";
}

/// What is wrong with a formula, where it is wrong.
void report(Reader& reader, const Place& metric, const ExpressionProblem& problem) {
  const Node& text = *metric.node().find("expression");
  reader.error_within(metric, mark_of(text, problem.at), "expression",
                      problem.sentence);
}

}  // namespace

Shape metric_shape() { return map<kMetricKeys>(); }

bool read_metrics(Reader& reader, const Place& at, bool states_known, Scene& out) {
  if (!reader.expect(at, Node::Kind::map, "a mapping of names to formulas"))
    return false;
  const Node& node = at.node();
  const std::size_t before = reader.findings.errors();
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const Place place(at, node.keys[i].text, node.items[i]);
    MetricEntry entry;
    entry.name = reader.key_name(at, i);
    if (!read_map(reader, place, kMetricKeys, entry)) continue;
    // Those behind a wrong one may read it.
    if (!states_known || reader.findings.errors() != before) continue;
    const KnownMetrics known = known_metrics(out);
    if (const std::string problem = name_problem(entry.name, known); !problem.empty()) {
      reader.error_within(at, node.keys[i].mark, entry.name, problem);
      continue;
    }
    const auto made = make_metric(entry.name, entry.expression, entry.larger_is_better,
                                  entry.unit, known);
    if (const auto* problem = std::get_if<ExpressionProblem>(&made))
      report(reader, place, *problem);
    else
      out.metrics.push_back(std::move(entry));
  }
  return reader.findings.errors() == before;
}

Node write_metrics(const std::vector<MetricEntry>& metrics) {
  Node map;
  map.kind = Node::Kind::map;
  for (const MetricEntry& entry : metrics) {
    map.keys.push_back({entry.name, {}});
    map.items.push_back(write_map(kMetricKeys, entry));
  }
  return map;
}

}  // namespace delos

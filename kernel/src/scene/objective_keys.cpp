#include <algorithm>

#include "delos/model/metric.h"
#include "delos/scene/definition.h"
#include "document/node_text.h"
#include "scene/search_keys.h"
#include "scene/words.h"

namespace delos {
namespace {

using namespace shapes;
using Written = std::optional<Node>;

constexpr std::pair<const char*, Reduction> kReductionWords[] = {
    {"mean", Reduction::mean},
    {"p_norm", Reduction::p_norm},
    {"soft_max", Reduction::soft_max},
    {"maximum", Reduction::maximum},
    {"percentile", Reduction::percentile},
    {"cvar", Reduction::cvar},
    {"fraction", Reduction::fraction}};

/// A term while it is read.
struct TermDraft {
  const Scene* scene = nullptr;
  ObjectiveTerm term;
  std::string reduction;  ///< the key that gave it
};

Metric metric_of(const TermDraft& draft) {
  const std::string& name =
      draft.term.metric.empty() ? draft.scene->metric : draft.term.metric;
  return std::get<Metric>(parse_metric(name, known_metrics(*draft.scene)));
}

void read_reduction(Reader& reader, const Place& at, TermDraft& out, bool maximize) {
  const auto reduction = reader.choice(at, kReductionWords);
  if (!reduction) return;
  if (!out.reduction.empty())
    reader.error(at, "the term is given by '" + out.reduction + "' already; keep one");
  out.reduction = maximize ? "maximize" : "minimize";
  out.term.reduction = *reduction;
  out.term.maximize = maximize;
}

void read_metric(Reader& reader, const Place& at, TermDraft& out) {
  if (auto name = read_metric_name(reader, at, *out.scene))
    out.term.metric = *std::move(name);
}

void read_limit(Reader& reader, const Place& at, TermDraft& out) {
  if (const auto value = reader.number(at, metric_of(out).unit))
    out.term.limit = *value;
}

/// More says no more than this does.
constexpr Bounds kWeight = {.least = 0, .greatest = 1e12, .above = true};

struct SetDraft {
  const Scene* scene = nullptr;
  WeightedSet set;
};

void read_set_name(Reader& reader, const Place& at, const Scene& scene,
                   std::string& out) {
  const auto name = reader.word(at);
  if (!name) return;
  std::vector<std::string> known;
  for (const SampleSet& set : scene.samples)
    if (!set.name.empty()) known.push_back(set.name);
  if (std::find(known.begin(), known.end(), *name) == known.end())
    reader.error(at, "there is no sample set '" + *name + '\'' +
                         (known.empty() ? "; no set of the scene has a name"
                                        : suggestion(*name, known)));
  out = *name;
}

constexpr std::array<Key<SetDraft>, 2> kSetKeys = {{
    {"set", Need::required, "name of a sample set", text(),
     [](Reader& r, const Place& p, SetDraft& d) {
       read_set_name(r, p, *d.scene, d.set.name);
     },
     [](const SetDraft& d) -> Written { return to_node(d.set.name); }},
    {"weight", Need::optional, "how much each of its samples counts",
     number("1", kWeight),
     [](Reader& r, const Place& p, SetDraft& d) {
       if (const auto v = r.number(p)) d.set.weight = *v;
     },
     [](const SetDraft& d) -> Written { return to_node(d.set.weight); }},
}};

void read_over(Reader& reader, const Place& at, TermDraft& out) {
  const auto read_one = [&](const Place& place) {
    SetDraft draft{out.scene, {}};
    if (place.node().kind == Node::Kind::scalar)
      read_set_name(reader, place, *out.scene, draft.set.name);
    else if (!read_map(reader, place, kSetKeys, draft))
      return;
    out.term.over.push_back(std::move(draft.set));
  };
  if (at.node().kind != Node::Kind::list) return read_one(at);
  for (std::size_t i = 0; i < at.node().items.size(); ++i)
    read_one(Place(at, std::to_string(i), at.node().items[i]));
}

Written write_reduction(const TermDraft& d, bool maximize) {
  if (d.term.maximize != maximize) return std::nullopt;
  return to_node(word_of(kReductionWords, d.term.reduction));
}

Shape set_shape() {
  return either([] { return std::vector{text(), map<kSetKeys>()}; });
}
std::vector<Shape> over_forms() { return {set_shape(), list(set_shape)}; }

constexpr std::array<Key<TermDraft>, 9> kTermKeys = {{
    {"minimize", Need::optional,
     "mean, p_norm, soft_max, maximum, percentile, cvar or fraction",
     choice<kReductionWords>(),
     [](Reader& r, const Place& p, TermDraft& d) { read_reduction(r, p, d, false); },
     [](const TermDraft& d) { return write_reduction(d, false); }},
    {"maximize", Need::optional, "the same, of a metric of which more is better",
     choice<kReductionWords>(),
     [](Reader& r, const Place& p, TermDraft& d) { read_reduction(r, p, d, true); },
     [](const TermDraft& d) { return write_reduction(d, true); }},
    {"of", Need::optional, "the metric; default: the scene's", text(), read_metric,
     [](const TermDraft& d) -> Written {
       if (d.term.metric.empty()) return std::nullopt;
       return to_node(d.term.metric);
     }},
    {"weight", Need::optional, "of this term in the sum", number("1", kWeight),
     [](Reader& r, const Place& p, TermDraft& d) {
       if (const auto v = r.number(p)) d.term.weight = *v;
     },
     [](const TermDraft& d) -> Written { return to_node(d.term.weight); }},
    {"p", Need::optional, "power of p_norm, at least 1", number("1", between(1, 1e3)),
     [](Reader& r, const Place& p, TermDraft& d) {
       if (const auto v = r.number(p)) d.term.power = *v;
     },
     [](const TermDraft& d) -> Written { return to_node(d.term.power); }},
    {"sharpness", Need::optional, "of soft_max, above 0",
     number("1", {.least = 0, .greatest = 1e4, .above = true}),
     [](Reader& r, const Place& p, TermDraft& d) {
       if (const auto v = r.number(p)) d.term.sharpness = *v;
     },
     [](const TermDraft& d) -> Written { return to_node(d.term.sharpness); }},
    {"level", Need::optional, "of percentile and cvar, between 0 and 1",
     number("1", {.least = 0, .greatest = 1, .above = true, .below = true}),
     [](Reader& r, const Place& p, TermDraft& d) {
       if (const auto v = r.number(p)) d.term.level = *v;
     },
     [](const TermDraft& d) -> Written { return to_node(d.term.level); }},
    {"limit", Need::optional, "of fraction: what a sample should keep to",
     number(nullptr), read_limit,
     [](const TermDraft& d) -> Written { return to_node(d.term.limit); }},
    {"over", Need::optional, "sample sets that count, with weights; default: all alike",
     either(over_forms), read_over,
     [](const TermDraft& d) -> Written {
       if (d.term.over.empty()) return std::nullopt;
       std::vector<Node> list;
       for (const WeightedSet& set : d.term.over)
         list.push_back(write_map(kSetKeys, SetDraft{nullptr, set}));
       return to_node(std::move(list));
     }},
}};

/// What only the keys together tell.
void check_term(Reader& reader, const Place& at, const TermDraft& draft) {
  if (draft.reduction.empty()) {
    reader.error(at, "says neither what to minimize nor what to maximize");
    return;
  }
  const Metric metric = metric_of(draft);
  const bool fraction = draft.term.reduction == Reduction::fraction;
  const Node* reduction = at.node().find(draft.reduction);
  if (!fraction && metric.larger_is_better != draft.term.maximize)
    reader.error_within(at, reduction->mark, draft.reduction,
                        metric.larger_is_better
                            ? "more " + metric.name + " is better: maximize it"
                            : "less " + metric.name + " is better: minimize it");
  const bool of_costs = draft.term.reduction == Reduction::p_norm ||
                        draft.term.reduction == Reduction::soft_max;
  if (of_costs && metric.larger_is_better)
    reader.error_within(at, reduction->mark, draft.reduction,
                        std::string(word_of(kReductionWords, draft.term.reduction)) +
                            " weighs what is large, but of " + metric.name +
                            " the least matters; use mean, cvar, percentile or "
                            "maximum, which is the least");
  if (fraction && draft.term.maximize)
    reader.error_within(at, reduction->mark, draft.reduction,
                        "fraction is the part of the samples that miss the limit: "
                        "minimize it");
  if (fraction && !at.node().find("limit"))
    reader.error_within(at, at.node().mark, "limit",
                        "missing: what a sample should keep to, in " +
                            (metric.unit == "1" ? "numbers" : metric.unit));
}

/// An objective while it is read: one term stands in it directly.
struct ObjectiveDraft {
  const Scene* scene = nullptr;
  Objective objective;
};

void read_terms(Reader& reader, const Place& at, ObjectiveDraft& out) {
  if (!reader.expect(at, Node::Kind::list, "a list of terms")) return;
  for (std::size_t i = 0; i < at.node().items.size(); ++i) {
    const Place place(at, std::to_string(i), at.node().items[i]);
    TermDraft draft{out.scene, {}, {}};
    const std::size_t before = reader.findings.errors();
    if (!read_map(reader, place, kTermKeys, draft)) continue;
    if (reader.findings.errors() == before) check_term(reader, place, draft);
    out.objective.terms.push_back(std::move(draft.term));
  }
}

constexpr std::array<Key<ObjectiveDraft>, 3> kObjectiveKeys = {{
    {"terms", Need::optional, "a list of terms, whose weighted sum is made small",
     list([] { return map<kTermKeys>(); }), read_terms,
     [](const ObjectiveDraft& d) -> Written {
       if (d.objective.terms.empty()) return std::nullopt;
       std::vector<Node> list;
       for (const ObjectiveTerm& term : d.objective.terms)
         list.push_back(write_map(kTermKeys, TermDraft{nullptr, term, {}}));
       return to_node(std::move(list));
     }},
    {"guess", Need::optional,
     "how good a guess stands in for what no device sees, metres and radians",
     number("m", above(0)),
     [](Reader& r, const Place& p, ObjectiveDraft& d) {
       if (const auto guess = r.number(p)) d.objective.guess = *guess;
     },
     [](const ObjectiveDraft& d) -> Written {
       if (d.objective.guess == 0) return std::nullopt;
       return to_node(d.objective.guess);
     }},
    {"robust", Need::optional, "failures and deviations that are withstood",
     map(robust_keys),
     [](Reader& r, const Place& p, ObjectiveDraft& d) {
       read_robust(r, p, *d.scene, d.objective.robust);
     },
     [](const ObjectiveDraft& d) { return write_robust(d.objective.robust); }},
}};

/// The keys of the only term stand beside `guess` and `robust`.
std::vector<KeyShape> single_term_keys() {
  std::vector<KeyShape> keys = keys_of<kTermKeys>();
  for (const KeyShape& key : keys_of<kObjectiveKeys>())
    if (std::string_view(key.name) != "terms") keys.push_back(key);
  return keys;
}

}  // namespace

std::vector<Shape> objective_forms() {
  return {map(single_term_keys), map<kObjectiveKeys>()};
}

std::optional<std::string> read_metric_name(Reader& reader, const Place& at,
                                            const Scene& scene) {
  auto name = reader.word(at);
  if (!name) return std::nullopt;
  const auto known = parse_metric(*name, known_metrics(scene));
  if (const auto* problem = std::get_if<std::string>(&known)) {
    reader.error(at, *problem);
    return std::nullopt;
  }
  return name;
}

void read_objective(Reader& reader, const Place& at, Scene& scene) {
  ObjectiveDraft draft{&scene, {}};
  const Node& node = at.node();
  if (node.kind == Node::Kind::map && !node.find("terms")) {
    Node term = node, rest = node;
    term.keys.clear();
    term.items.clear();
    rest.keys.clear();
    rest.items.clear();
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      const std::string& key = node.keys[i].text;
      Node& part = key == "guess" || key == "robust" ? rest : term;
      part.keys.push_back(node.keys[i]);
      part.items.push_back(node.items[i]);
    }
    const Node nothing;
    const Place root(nothing);
    read_map(reader, Place(root, "objective", rest), kObjectiveKeys, draft);
    TermDraft single{&scene, {}, {}};
    const Place place(root, "objective", term);
    const std::size_t before = reader.findings.errors();
    if (!term.items.empty()) {
      read_map(reader, place, kTermKeys, single);
      if (reader.findings.errors() == before) check_term(reader, place, single);
      draft.objective.terms.push_back(std::move(single.term));
    } else if (rest.items.empty()) {
      reader.error(at, "says neither what to minimize nor what to maximize");
    }
  } else if (!read_map(reader, at, kObjectiveKeys, draft)) {
    return;
  }
  scene.objective = std::move(draft.objective);
}

std::optional<Node> write_objective(const Scene& scene) {
  if (scene.objective == Objective{}) return std::nullopt;
  return write_map(kObjectiveKeys, ObjectiveDraft{nullptr, scene.objective});
}

}  // namespace delos

#include "document/node_text.h"
#include "scene/search_keys.h"
#include "scene/words.h"

namespace delos {
namespace {

using namespace shapes;
using Written = std::optional<Node>;

constexpr std::pair<const char*, DrawRule> kDrawRuleWords[] = {
    {"mean", DrawRule::mean}, {"worst", DrawRule::worst}};

/// What is withstood, while it is read.
struct RobustnessDraft {
  const Scene* scene = nullptr;
  Robustness robust;
};

void read_failures(Reader& reader, const Place& at, RobustnessDraft& out) {
  out.robust.failures = read_device_names(reader, at, *out.scene);
  if (out.scene->devices.size() == 1)
    reader.error(at, "of a single device none may fail; nothing would be left");
}

Written deviation(double value) {
  if (value == 0) return std::nullopt;
  return to_node(value);
}

constexpr Bounds kDrawn = above(0, "; leave out what isn't drawn");

constexpr std::array<Key<Robustness>, 2> kMountingKeys = {{
    other_key<&Robustness::place>(
        "at", Need::optional, "standard deviation of places along each axis, metres",
        number("m", kDrawn)),
    other_key<&Robustness::angle>(
        "angle", Need::optional,
        "standard deviation of a turn about each axis, radians", number("rad", kDrawn)),
}};

void read_mounting(Reader& reader, const Place& at, RobustnessDraft& out) {
  if (read_map(reader, at, kMountingKeys, out.robust) && at.node().items.empty())
    reader.error(at, "draws nothing; give at, angle or both");
}

constexpr std::array<Key<RobustnessDraft>, 6> kRobustKeys = {{
    {"failures", Need::optional,
     "devices of which any one may fail; * is any part of a name", names(),
     read_failures,
     [](const RobustnessDraft& d) -> Written {
       if (d.robust.failures.empty()) return std::nullopt;
       return names_node(d.robust.failures);
     }},
    {"mounting", Need::optional, "how far devices are off where they should be",
     map<kMountingKeys>(), read_mounting,
     [](const RobustnessDraft& d) -> Written {
       if (d.robust.place == 0 && d.robust.angle == 0) return std::nullopt;
       return write_map(kMountingKeys, d.robust);
     }},
    {"noise", Need::optional,
     "relative standard deviation of devices' noise: of its logarithm",
     number("1", kDrawn),
     [](Reader& r, const Place& p, RobustnessDraft& d) {
       if (const auto noise = r.number(p)) d.robust.noise = *noise;
     },
     [](const RobustnessDraft& d) { return deviation(d.robust.noise); }},
    {"draws", Need::optional, "how many draws of mounting and noise", integer(1, 10000),
     [](Reader& r, const Place& p, RobustnessDraft& d) {
       if (const auto n = r.integer(p)) d.robust.draws = *n;
     },
     [](const RobustnessDraft& d) -> Written {
       if (!d.robust.is_drawn()) return std::nullopt;
       return to_node(d.robust.draws);
     }},
    {"seed", Need::optional, "of the draws", integer(0),
     [](Reader& r, const Place& p, RobustnessDraft& d) {
       if (const auto n = r.integer(p)) d.robust.seed = *n;
     },
     [](const RobustnessDraft& d) -> Written {
       if (!d.robust.is_drawn()) return std::nullopt;
       return to_node(d.robust.seed);
     }},
    {"combine", Need::optional, "mean or worst of the draws", choice<kDrawRuleWords>(),
     [](Reader& r, const Place& p, RobustnessDraft& d) {
       if (const auto rule = r.choice(p, kDrawRuleWords)) d.robust.combine = *rule;
     },
     [](const RobustnessDraft& d) -> Written {
       if (!d.robust.is_drawn()) return std::nullopt;
       return to_node(word_of(kDrawRuleWords, d.robust.combine));
     }},
}};

}  // namespace

std::vector<KeyShape> robust_keys() { return keys_of<kRobustKeys>(); }

void read_robust(Reader& reader, const Place& at, const Scene& scene, Robustness& out) {
  const std::size_t before = reader.findings.errors();
  RobustnessDraft draft{&scene, {}};
  if (!read_map(reader, at, kRobustKeys, draft)) return;
  out = std::move(draft.robust);
  if (reader.findings.errors() != before) return;
  if (!out.is_drawn()) {
    for (const char* key : {"draws", "seed", "combine"})
      if (const Node* node = at.node().find(key))
        reader.error_within(at, node->mark, key,
                            "nothing is drawn; give mounting or noise");
  }
  if (at.node().items.empty())
    reader.error(at, "withstands nothing; give failures, mounting or noise");
}

std::optional<Node> write_robust(const Robustness& robust) {
  if (robust == Robustness{}) return std::nullopt;
  return write_map(kRobustKeys, RobustnessDraft{nullptr, robust});
}

}  // namespace delos

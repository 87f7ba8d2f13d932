#include "scene/motion_keys.h"

#include <algorithm>
#include <set>

#include "delos/text/units.h"
#include "delos/text/words.h"
#include "document/node_text.h"
#include "scene/motion_word_keys.h"
#include "scene/noise_check.h"
#include "scene/words.h"

namespace delos {
namespace {

using namespace shapes;

/// Types of motion: the order of a chain, or what A and Q are of.
constexpr int kOneUpdate = 0, kContinuous = -1;
constexpr std::pair<const char*, int> kMotionWords[] = {
    {"position", 1},
    {"position_velocity", 2},
    {"position_velocity_acceleration", 3},
    {"custom", kOneUpdate},
    {"continuous", kContinuous},
};

/// What the keys say, before they are put together.
struct MotionDraft {
  std::optional<int> type;  ///< of kMotionWords
  StateLayout layout;
  std::optional<std::vector<std::string>> names;
  std::optional<CoordinateMatrix> q;
  std::optional<Eigen::MatrixXd> A, Q;

  [[nodiscard]] bool is_chain() const { return type.value_or(0) > 0; }
};

/// SI unit of entry (i, j) of q: the product of two coordinates over s^(2k−1).
std::string q_unit(const StateLayout& layout, int i, int j) {
  const auto is_length = [&](int c) { return c < layout.positions(); };
  const std::string square = is_length(i) != is_length(j) ? "m rad"
                             : is_length(i)               ? "m^2"
                                                          : "rad^2";
  const int power = 2 * layout.order - 1;
  return square + (power == 1 ? "/s" : "/s^" + std::to_string(power));
}

void read_diagonal_q(Reader& reader, const Place& at, MotionDraft& draft) {
  const int d = draft.layout.coordinates();
  const std::size_t before = reader.findings.errors();
  CoordinateMatrix q = CoordinateMatrix::Zero(d, d);
  for (int i = 0; i < d; ++i) {
    const Place entry(at, std::to_string(i),
                      at.node().items[static_cast<std::size_t>(i)]);
    const auto value = reader.number(entry, q_unit(draft.layout, i, i));
    if (!value) continue;
    if (!(*value > 0))
      reader.error(entry, shortest(*value) +
                              " isn't above 0; the noise that drives the "
                              "motion must be positive");
    q(i, i) = *value;
  }
  if (reader.findings.errors() == before) draft.q = q;
}

void read_full_q(Reader& reader, const Place& at, MotionDraft& draft) {
  const int d = draft.layout.coordinates();
  const auto m = reader.matrix(
      at, [&](int i, int j) { return q_unit(draft.layout, i % d, j % d); });
  if (!m) return;
  if (m->rows() != d || m->cols() != d) {
    reader.error(at, "is " + std::to_string(m->rows()) + "×" +
                         std::to_string(m->cols()) + ", but the state has " +
                         std::to_string(d) + " coordinates");
    return;
  }
  if (check_positive_definite(reader, at, *m)) draft.q = *m;
}

void read_q(Reader& reader, const Place& at, MotionDraft& draft) {
  if (!draft.is_chain() || draft.layout.coordinates() == 0) return;
  if (!reader.expect(at, Node::Kind::list, "a list of numbers or of rows")) return;
  const auto& items = at.node().items;
  const auto d = static_cast<std::size_t>(draft.layout.coordinates());
  if (items.size() != d) {
    reader.error(at, "has " + std::to_string(items.size()) +
                         " members, but the state '" +
                         word_of(kPoseStateWords, draft.layout.pose) + "' has " +
                         std::to_string(d) + " coordinates");
    return;
  }
  if (items[0].kind == Node::Kind::list)
    read_full_q(reader, at, draft);
  else
    read_diagonal_q(reader, at, draft);
}

void read_names(Reader& reader, const Place& at, MotionDraft& draft) {
  if (!reader.expect(at, Node::Kind::list, "a list of names")) return;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < at.node().items.size(); ++i)
    names.push_back(
        reader.name(Place(at, std::to_string(i), at.node().items[i])).value_or(""));
  draft.names = std::move(names);
}

void read_square(Reader& reader, const Place& at, std::optional<Eigen::MatrixXd>& out) {
  auto m = reader.matrix(at, [](int, int) { return "1"; });
  if (!m) return;
  if (m->rows() != m->cols())
    reader.error(at, "is " + std::to_string(m->rows()) + "×" +
                         std::to_string(m->cols()) + ", but must be square");
  else if (m->rows() > kMaxState)
    reader.error(at, "has " + std::to_string(m->rows()) + " states; at most " +
                         std::to_string(kMaxState) + " are possible");
  else
    out = std::move(m);
}

/// One number a coordinate, or a symmetric matrix.
std::vector<Shape> q_forms() { return {numbers(nullptr, 1), matrix(nullptr)}; }

constexpr std::array<Key<MotionDraft>, 12> kMotionKeys = {{
    {"type", Need::required,
     "position, position_velocity, position_velocity_acceleration, custom or "
     "continuous",
     choice<kMotionWords>(),
     [](Reader& r, const Place& p, MotionDraft& d) {
       d.type = r.choice(p, kMotionWords);
       if (d.is_chain()) d.layout.order = *d.type;
     },
     [](const MotionDraft& d) -> std::optional<Node> {
       return to_node(word_of(kMotionWords, *d.type));
     }},
    {"state", Need::optional,
     "what is estimated: position, orientation, pose, planar, planar_pose or none",
     choice<kPoseStateWords>(),
     [](Reader& r, const Place& p, MotionDraft& d) {
       if (const auto pose = r.choice(p, kPoseStateWords)) d.layout.pose = *pose;
     },
     [](const MotionDraft& d) -> std::optional<Node> {
       return to_node(word_of(kPoseStateWords, d.layout.pose));
     }},
    {"order", Need::optional,
     "custom and continuous: blocks of coordinates, 1 to 3; default 1", integer(1, 3),
     [](Reader& r, const Place& p, MotionDraft& d) {
       const auto order = r.integer(p);
       if (order && !d.is_chain()) d.layout.order = *order;
     },
     [](const MotionDraft& d) -> std::optional<Node> {
       if (d.is_chain() || d.layout.coordinates() == 0) return std::nullopt;
       return to_node(d.layout.order);
     }},
    {"names", Need::optional,
     "custom and continuous: names of the states behind the blocks",
     list([] { return name(); }), read_names,
     [](const MotionDraft& d) -> std::optional<Node> {
       if (d.layout.extra.empty()) return std::nullopt;
       std::vector<Node> names;
       for (const std::string& name : d.layout.extra) names.push_back(to_node(name));
       return to_node(std::move(names));
     }},
    {"q", Need::optional,
     "spectral density of the driving noise: one number a coordinate, or a symmetric "
     "matrix",
     either(q_forms), read_q,
     [](const MotionDraft& d) -> std::optional<Node> {
       if (!d.q) return std::nullopt;
       if (d.q->isDiagonal(0)) return vector_node(d.q->diagonal());
       return matrix_node(*d.q);
     }},
    {"A", Need::optional,
     "custom: transition of one update; continuous: drift; n×n, SI", matrix("1"),
     [](Reader& r, const Place& p, MotionDraft& d) { read_square(r, p, d.A); },
     [](const MotionDraft& d) -> std::optional<Node> {
       if (!d.A) return std::nullopt;
       return matrix_node(*d.A);
     }},
    {"Q", Need::optional,
     "custom: process noise of one update; continuous: its spectral density; n×n, SI",
     matrix("1"),
     [](Reader& r, const Place& p, MotionDraft& d) { read_square(r, p, d.Q); },
     [](const MotionDraft& d) -> std::optional<Node> {
       if (!d.Q) return std::nullopt;
       return matrix_node(*d.Q);
     }},
    // Read together, by q_of_words().
    {"speed", Need::optional, "in words: how fast it moves, m/s",
     number("m/s", above(0))},
    {"acceleration", Need::optional, "in words: likewise of an accelerated one, m/s²",
     number("m/s^2", above(0))},
    {"vertical", Need::optional, "in words: root mean square of that along z",
     number(nullptr, above(0))},
    {"changes_within", Need::optional, "in words: the time in which that is forgotten",
     number("s", above(0))},
    // Read alone, by read_named_motion().
    {"named", Need::optional, "a motion of the library, instead of all the rest",
     choice_of(motion_names)},
}};

/// Say which keys belong to the other kind of motion, and which are missing.
void check_keys(Reader& reader, const Place& at, const MotionDraft& draft) {
  struct Rule {
    const char* key;
    bool custom;
    Need need;
  };
  constexpr Rule kRules[] = {{"order", true, Need::optional},
                             {"names", true, Need::optional},
                             {"A", true, Need::required},
                             {"Q", true, Need::required},
                             {"q", false, Need::required}};
  const bool custom = !draft.is_chain(), words = has_motion_words(at.node());
  if (custom && words)
    reader.error_within(at, at.node().mark, "type",
                        "words such as speed describe position, position_velocity and "
                        "position_velocity_acceleration only");
  for (const Rule& rule : kRules) {
    if (words && rule.key == std::string_view("q")) continue;
    const Node* node = at.node().find(rule.key);
    if (node && rule.custom != custom)
      reader.error_within(at, node->mark, rule.key,
                          custom ? word_of(kMotionWords, *draft.type) +
                                       std::string(" motion is described by A and Q "
                                                   "instead")
                                 : "only custom and continuous motion have it; q "
                                   "describes this type");
    if (!node && rule.custom == custom && rule.need == Need::required)
      reader.error_within(at, at.node().mark, rule.key,
                          "missing: this type of motion needs it");
  }
}

/// A state without a pose is described by matrices, and has no blocks.
void check_pose(Reader& reader, const Place& at, const MotionDraft& draft) {
  if (draft.layout.coordinates() > 0) return;
  if (draft.is_chain())
    reader.error_within(at, at.node().find("state")->mark, "state",
                        "is for custom and continuous motion; this type moves "
                        "coordinates of a pose");
  else if (const Node* node = at.node().find("order"))
    reader.error_within(at, node->mark, "order",
                        "is of blocks of coordinates, but this state has none");
}

void name_extra_states(Reader& reader, const Place& at, MotionDraft& draft) {
  const auto base = static_cast<std::size_t>(draft.layout.size());
  const std::size_t extra = static_cast<std::size_t>(draft.A->rows()) - base;
  std::vector<std::string> names;
  if (draft.names) {
    const Place place(at, "names", *at.node().find("names"));
    if (draft.names->size() != extra) {
      reader.error(place, "has " + std::to_string(draft.names->size()) +
                              " names, but " + std::to_string(extra) + " of the " +
                              std::to_string(draft.A->rows()) +
                              " states are behind the blocks of coordinates");
      return;
    }
    const std::vector<std::string> taken = draft.layout.names();
    std::set<std::string> seen(taken.begin(), taken.end());
    for (std::size_t i = 0; i < extra; ++i)
      if (!seen.insert((*draft.names)[i]).second)
        reader.error(Place(place, std::to_string(i), place.node().items[i]),
                     '\'' + (*draft.names)[i] + "' names another state already");
    names = *draft.names;
  } else {
    for (std::size_t i = 0; i < extra; ++i)
      names.push_back("extra" + std::to_string(i + 1));
  }
  draft.layout.extra = std::move(names);
}

void finish_custom(Reader& reader, const Place& at, MotionDraft& draft,
                   MotionModel& out) {
  if (draft.Q)
    check_positive_semidefinite(reader, Place(at, "Q", *at.node().find("Q")), *draft.Q);
  if (!draft.A || !draft.Q) return;
  if (draft.A->rows() != draft.Q->rows()) {
    reader.error(Place(at, "Q", *at.node().find("Q")),
                 "has " + std::to_string(draft.Q->rows()) + " rows, A has " +
                     std::to_string(draft.A->rows()));
    return;
  }
  if (draft.A->rows() < draft.layout.size()) {
    reader.error(
        Place(at, "A", *at.node().find("A")),
        "has " + delos::counted(static_cast<std::size_t>(draft.A->rows()), "state") +
            ", but " + std::to_string(draft.layout.order) + " × " +
            std::to_string(draft.layout.coordinates()) + " coordinates need at least " +
            std::to_string(draft.layout.size()));
    return;
  }
  name_extra_states(reader, at, draft);
  out.layout = draft.layout;
  if (*draft.type == kContinuous)
    out.dynamics = ContinuousMotion{*draft.A, *draft.Q};
  else
    out.dynamics = CustomMotion{*draft.A, *draft.Q};
}

}  // namespace

// A named motion says all, so that no key is required of every motion.
std::vector<KeyShape> motion_keys() {
  std::vector<KeyShape> keys = keys_of<kMotionKeys>();
  for (KeyShape& key : keys) key.required = false;
  return keys;
}
Shape motion_shape() { return map(motion_keys); }

void read_motion(Reader& reader, const Place& at, MotionModel& out) {
  if (at.node().find("named")) return read_named_motion(reader, at, out);
  MotionDraft draft;
  if (!read_map(reader, at, kMotionKeys, draft) || !draft.type) return;
  check_keys(reader, at, draft);
  check_pose(reader, at, draft);
  if (!draft.is_chain()) {
    finish_custom(reader, at, draft, out);
  } else {
    out.layout = draft.layout;
    if (has_motion_words(at.node())) draft.q = q_of_words(reader, at, draft.layout);
    if (draft.q) out.dynamics = ChainMotion{*draft.q};
  }
}

void read_motions(Reader& reader, const Place& at, std::vector<MotionEntry>& out) {
  if (!reader.expect(at, Node::Kind::map, "a mapping of names to motions")) return;
  const Node& node = at.node();
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    MotionEntry entry{reader.key_name(at, i), {}};
    const Place place(at, node.keys[i].text, node.items[i]);
    if (entry.name == "all")
      reader.error(place, "'all' means all of them; take another name");
    if (!reader.expect(place, Node::Kind::map, "a mapping")) continue;
    read_motion(reader, place, entry.motion);
    out.push_back(std::move(entry));
  }
}

Node write_motions(const std::vector<MotionEntry>& motions) {
  Node map;
  map.kind = Node::Kind::map;
  for (const MotionEntry& entry : motions) {
    map.keys.push_back({entry.name, {}});
    map.items.push_back(write_motion(entry.motion));
  }
  return map;
}

Node write_motion(const MotionModel& motion) {
  MotionDraft draft;
  draft.layout = motion.layout;
  const auto of_matrices = [&](int type, const auto& custom) {
    draft.type = type;
    draft.A = custom.A;
    draft.Q = custom.Q;
  };
  if (const auto* chain = std::get_if<ChainMotion>(&motion.dynamics)) {
    draft.type = motion.layout.order;
    draft.q = chain->q;
  } else if (const auto* custom = std::get_if<CustomMotion>(&motion.dynamics)) {
    of_matrices(kOneUpdate, *custom);
  } else {
    of_matrices(kContinuous, std::get<ContinuousMotion>(motion.dynamics));
  }
  return write_map(kMotionKeys, draft);
}

}  // namespace delos

#include <cmath>
#include <map>

#include "delos/scene/number.h"
#include "delos/text/units.h"
#include "document/node_text.h"
#include "scene/search_keys.h"
#include "scene/words.h"

namespace delos {
namespace {

using namespace shapes;
using Written = std::optional<Node>;

constexpr std::pair<const char*, ParamScale> kScaleWords[] = {
    {"uniform", ParamScale::linear}, {"log", ParamScale::log}};

/// A variable while it is read; a pattern makes several of it.
struct VariableDraft {
  Scene* scene = nullptr;
  std::vector<VariableEntry> entries;
  std::vector<SceneNumber> numbers;  ///< one an entry
};

struct FollowerDraft {
  Scene* scene = nullptr;
  Follower follower;
  double about = 0;
};

/// @returns false, with a finding, where there is no number of that path
bool check_number(Reader& reader, const Place& at, Scene& scene,
                  const std::string& path) {
  const auto found = find_number(scene, path, reader.plugins);
  const auto* problem = std::get_if<std::string>(&found);
  if (problem) reader.error(at, *problem);
  return !problem;
}

void read_path(Reader& reader, const Place& at, VariableDraft& out) {
  const auto pattern = reader.word(at);
  if (!pattern) return;
  const auto paths = expand_numbers(*out.scene, *pattern, reader.plugins);
  if (const auto* problem = std::get_if<std::string>(&paths)) {
    reader.error(at, *problem);
    return;
  }
  for (const std::string& path : std::get<0>(paths)) {
    const auto number =
        std::get<SceneNumber>(find_number(*out.scene, path, reader.plugins));
    out.entries.push_back({path, number.lower, number.upper, number.scale, {}});
    out.numbers.push_back(number);
  }
}

/// One number for all entries, or a list that repeats, as a vector's components do.
void read_bound(Reader& reader, const Place& at, VariableDraft& out,
                double VariableEntry::*bound) {
  const Node& node = at.node();
  if (node.kind == Node::Kind::list &&
      (node.items.empty() || out.entries.size() % node.items.size() != 0)) {
    if (!out.entries.empty())
      reader.error(at, "has " + std::to_string(node.items.size()) +
                           " numbers, but the path means " +
                           std::to_string(out.entries.size()));
    return;
  }
  for (std::size_t i = 0; i < out.entries.size(); ++i) {
    std::optional<double> value;
    if (node.kind == Node::Kind::list) {
      const std::size_t part = i % node.items.size();
      value = reader.number(Place(at, std::to_string(part), node.items[part]),
                            out.numbers[i].unit);
    } else {
      value = reader.number(at, out.numbers[i].unit);
    }
    if (!value) return;
    out.entries[i].*bound = *value;
  }
}

void add_follower(Reader& reader, const Place& at, VariableDraft& out,
                  Follower follower) {
  if (out.entries.empty()) return;
  if (out.entries.size() > 1) {
    reader.error(at, "the path means " + std::to_string(out.entries.size()) +
                         " numbers; write a variable for each that others follow");
    return;
  }
  out.entries.front().followers.push_back(std::move(follower));
}

void read_tie(Reader& reader, const Place& at, VariableDraft& out) {
  const auto read_one = [&](const Place& place) {
    const auto path = reader.word(place);
    if (path && check_number(reader, place, *out.scene, *path))
      add_follower(reader, place, out, {*path, 1, 0});
  };
  if (at.node().kind != Node::Kind::list) return read_one(at);
  for (std::size_t i = 0; i < at.node().items.size(); ++i)
    read_one(Place(at, std::to_string(i), at.node().items[i]));
}

template <double Follower::*kMember>
void read_member(Reader& reader, const Place& at, FollowerDraft& out) {
  if (const auto value = reader.number(at, "1")) out.follower.*kMember = *value;
}

constexpr Key<FollowerDraft> kFollowerPath = {
    "path",
    Need::required,
    "the number that follows",
    text(),
    [](Reader& r, const Place& p, FollowerDraft& d) {
      const auto path = r.word(p);
      if (path && check_number(r, p, *d.scene, *path)) d.follower.path = *path;
    },
    [](const FollowerDraft& d) -> Written { return to_node(d.follower.path); }};

constexpr std::array<Key<FollowerDraft>, 2> kMirrorKeys = {{
    kFollowerPath,
    {"about", Need::optional, "where the mirror stands, in SI", number("1"),
     [](Reader& r, const Place& p, FollowerDraft& d) {
       if (const auto about = r.number(p, "1")) d.about = *about;
     }},
}};

constexpr std::array<Key<FollowerDraft>, 3> kFollowKeys = {{
    kFollowerPath,
    {"factor", Need::optional, "what the variable is multiplied with", number("1"),
     read_member<&Follower::factor>,
     [](const FollowerDraft& d) -> Written { return to_node(d.follower.factor); }},
    {"offset", Need::optional, "what is added, in SI", number("1"),
     read_member<&Follower::offset>,
     [](const FollowerDraft& d) -> Written { return to_node(d.follower.offset); }},
}};

void read_mirror(Reader& reader, const Place& at, VariableDraft& out) {
  FollowerDraft draft{out.scene, {}, 0};
  if (at.node().kind == Node::Kind::scalar) {
    if (!check_number(reader, at, *out.scene, at.node().text)) return;
    draft.follower.path = at.node().text;
  } else if (!read_map(reader, at, kMirrorKeys, draft)) {
    return;
  }
  add_follower(reader, at, out, {draft.follower.path, -1, 2 * draft.about});
}

void read_follow(Reader& reader, const Place& at, VariableDraft& out) {
  if (!reader.expect(at, Node::Kind::list, "a list of {path, factor, offset}")) return;
  for (std::size_t i = 0; i < at.node().items.size(); ++i) {
    const Place place(at, std::to_string(i), at.node().items[i]);
    FollowerDraft draft{out.scene, {}, 0};
    if (read_map(reader, place, kFollowKeys, draft))
      add_follower(reader, place, out, std::move(draft.follower));
  }
}

Written write_follow(const VariableEntry& entry) {
  if (entry.followers.empty()) return std::nullopt;
  std::vector<Node> list;
  for (const Follower& f : entry.followers)
    list.push_back(write_map(kFollowKeys, FollowerDraft{nullptr, f, 0}));
  return to_node(std::move(list));
}

std::vector<Shape> bound_forms() { return {number(nullptr), numbers(nullptr, 1)}; }
std::vector<Shape> mirror_forms() { return {text(), map<kMirrorKeys>()}; }

constexpr std::array<Key<VariableDraft>, 7> kVariableKeys = {{
    {"path", Need::required,
     "a number of the scene, such as devices.s1.at.z; * stands for any part of a name",
     text(), read_path,
     [](const VariableDraft& d) -> Written { return to_node(d.entries.front().path); }},
    {"lower", Need::optional, "its least value", either(bound_forms),
     [](Reader& r, const Place& p, VariableDraft& d) {
       read_bound(r, p, d, &VariableEntry::lower);
     },
     [](const VariableDraft& d) -> Written {
       return to_node(d.entries.front().lower);
     }},
    {"upper", Need::optional, "its greatest value", either(bound_forms),
     [](Reader& r, const Place& p, VariableDraft& d) {
       read_bound(r, p, d, &VariableEntry::upper);
     },
     [](const VariableDraft& d) -> Written {
       return to_node(d.entries.front().upper);
     }},
    {"scale", Need::optional, "how a search steps: uniform or log",
     choice<kScaleWords>(),
     [](Reader& r, const Place& p, VariableDraft& d) {
       const auto scale = r.choice(p, kScaleWords);
       for (VariableEntry& entry : d.entries)
         if (scale) entry.scale = *scale;
     },
     [](const VariableDraft& d) -> Written {
       return to_node(word_of(kScaleWords, d.entries.front().scale));
     }},
    {"tie", Need::optional, "other numbers that take the same value", names(),
     read_tie},
    {"mirror", Need::optional, "a number that takes the mirrored value: path, about",
     either(mirror_forms), read_mirror},
    {"follow", Need::optional, "numbers that follow: path, factor, offset",
     list([] { return map<kFollowKeys>(); }), read_follow,
     [](const VariableDraft& d) -> Written { return write_follow(d.entries.front()); }},
}};

/// What only the bounds and the number together tell.
bool check_bounds(Reader& reader, const Place& at, VariableEntry& entry,
                  const SceneNumber& number) {
  const auto at_key = [&](const char* key, const std::string& problem) {
    const Node* node = at.node().find(key);
    reader.error_within(at, node ? node->mark : at.node().mark, key, problem);
    return false;
  };
  for (const auto& [key, bound] :
       {std::pair{"lower", entry.lower}, {"upper", entry.upper}})
    if (!std::isfinite(bound))
      return at_key(key,
                    "missing: nothing is known of how far '" + entry.path + "' may go");
  if (entry.lower < number.lower)
    return at_key("lower", shortest(entry.lower) + " is below the least value of '" +
                               entry.path + "', " + shortest(number.lower));
  if (entry.upper > number.upper)
    return at_key("upper", shortest(entry.upper) + " is above the greatest value of '" +
                               entry.path + "', " + shortest(number.upper));
  if (!(entry.lower < entry.upper))
    return at_key("lower", shortest(entry.lower) + " isn't below upper, " +
                               shortest(entry.upper) +
                               "; a variable needs room to change");
  if (entry.scale == ParamScale::log && !(entry.lower > 0)) {
    if (at.node().find("scale"))
      return at_key("lower", "must be above 0 where the scale is log");
    entry.scale = ParamScale::linear;
  }
  return true;
}

}  // namespace

Shape variable_shape() { return map<kVariableKeys>(); }

void read_variables(Reader& reader, const Place& at, Scene& scene) {
  if (!reader.expect(at, Node::Kind::list, "a list of variables")) return;
  std::map<std::string, int> line_of;
  for (std::size_t i = 0; i < at.node().items.size(); ++i) {
    const Node& node = at.node().items[i];
    const Place place(at, std::to_string(i), node);
    const std::size_t before = reader.findings.errors();
    VariableDraft draft{&scene, {}, {}};
    if (!read_map(reader, place, kVariableKeys, draft)) continue;
    if (reader.findings.errors() != before) continue;
    for (std::size_t e = 0; e < draft.entries.size(); ++e) {
      VariableEntry& entry = draft.entries[e];
      if (!check_bounds(reader, place, entry, draft.numbers[e])) break;
      std::vector<std::string> paths = {entry.path};
      for (const Follower& f : entry.followers) paths.push_back(f.path);
      for (const std::string& path : paths) {
        const auto [first, is_new] = line_of.emplace(path, node.mark.line);
        if (!is_new)
          reader.error(place, '\'' + path + "' is changed by the variable on line " +
                                  std::to_string(first->second) + " already");
      }
      scene.variables.push_back(std::move(entry));
    }
  }
}

std::optional<Node> write_variables(const Scene& scene) {
  if (scene.variables.empty()) return std::nullopt;
  std::vector<Node> list;
  for (const VariableEntry& entry : scene.variables)
    list.push_back(write_map(kVariableKeys, VariableDraft{nullptr, {entry}, {}}));
  return to_node(std::move(list));
}

}  // namespace delos

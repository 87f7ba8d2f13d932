#include "document/override.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>
#include <vector>

#include "document/reader.h"

namespace delos {
namespace {

std::vector<std::string> split(const std::string& path) {
  std::vector<std::string> segments;
  for (std::size_t begin = 0;;) {
    const std::size_t dot = std::min(path.find('.', begin), path.size());
    segments.push_back(path.substr(begin, dot - begin));
    if (dot == path.size()) return segments;
    begin = dot + 1;
  }
}

/// Names of a list's components, by the key that the list stands under.
std::vector<std::string> components(const std::string& key) {
  if (key == "rpy") return {"roll", "pitch", "yaw"};
  if (key == "quaternion_wxyz") return {"w", "x", "y", "z"};
  return {"x", "y", "z"};
}

bool is_list(const Node& node) { return node.kind == Node::Kind::list; }

bool is_vector(const Node& list) {
  return is_list(list) &&
         std::none_of(list.items.begin(), list.items.end(), [](const Node& item) {
           return item.kind == Node::Kind::map || item.kind == Node::Kind::list;
         });
}

/// The member of a list that a segment means.
Node* find_member(Node& list, const std::string& segment, const std::string& key) {
  for (Node& item : list.items) {
    const Node* name = item.find("name");
    if (name && name->kind == Node::Kind::scalar && name->text == segment) return &item;
  }
  std::size_t index = list.items.size();
  const char* end = segment.data() + segment.size();
  const auto parsed = std::from_chars(segment.data(), end, index);
  if (parsed.ec != std::errc{} || parsed.ptr != end) {
    if (!is_vector(list)) return nullptr;
    const auto names = components(key);
    index = static_cast<std::size_t>(std::find(names.begin(), names.end(), segment) -
                                     names.begin());
    if (index == names.size()) return nullptr;
  }
  return index < list.items.size() ? &list.items[index] : nullptr;
}

/// What paths call the members of a list or a map.
std::vector<std::string> member_names(const Node& node) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const Node* name = node.items[i].find("name");
    const bool named = is_list(node) && name && name->kind == Node::Kind::scalar;
    names.push_back(named           ? name->text
                    : is_list(node) ? std::to_string(i)
                                    : node.keys[i].text);
  }
  return names;
}

/// What could have been meant instead of a member that isn't there.
std::string members_text(const Node& list, const std::string& segment,
                         const std::string& key) {
  std::vector<std::string> known;
  for (const Node& item : list.items)
    if (const Node* name = item.find("name"); name && !name->text.empty())
      known.push_back(name->text);
  if (known.empty() && is_vector(list)) known = components(key);
  if (!known.empty()) return suggestion(segment, known);
  return list.items.empty()
             ? "; the list is empty"
             : "; members are 0 to " + std::to_string(list.items.size() - 1);
}

/// Walks down a path and says where it ends.
class Walk {
 public:
  Walk(const std::string& path, Mark where, Findings& findings)
      : segments_(split(path)), where_(where), findings_(findings) {}

  /// The node to replace; null, with a finding, where the path leads nowhere.
  Node* find(Node& root) {
    Node* node = &root;
    std::string key;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      if (segments_[i].empty()) return fail(i, "a part of the path is empty");
      Node* next = step(*node, i, key);
      if (!next) return nullptr;
      if (node->kind == Node::Kind::map) key = segments_[i];
      node = next;
    }
    return node;
  }

 private:
  Node* step(Node& node, std::size_t i, const std::string& key) {
    const std::string& segment = segments_[i];
    if (segment == "+" && (node.kind == Node::Kind::null || is_list(node))) {
      node.kind = Node::Kind::list;
      node.items.emplace_back().mark = where_;
      return &node.items.back();
    }
    if (node.kind == Node::Kind::null) node.kind = Node::Kind::map;
    if (node.kind == Node::Kind::scalar)
      return fail(i, "there is nothing inside a single value");
    if (is_list(node)) {
      Node* member = find_member(node, segment, key);
      return member ? member
                    : fail(i, "there is no such member" +
                                  members_text(node, segment, key));
    }
    if (Node* value = node.find(segment)) return value;
    return add(node, i);
  }

  Node* add(Node& map, std::size_t i) {
    const std::string& segment = segments_[i];
    for (const auto& [key, member] :
         {std::pair{"groups", "group"}, {"surfaces", "surface"}, {"regions", "region"}})
      if (i == 1 && segments_.size() > 2 && segments_[0] == key)
        return fail(
            i, std::string("there is no such ") + member + keys_text(map, segment));
    if (i + 1 < segments_.size()) {
      const auto axes = components({});
      const bool of_vector =
          std::find(axes.begin(), axes.end(), segments_[i + 1]) != axes.end();
      // `at` is the origin where it isn't given; no other vector is known to be
      // anything.
      if (of_vector && segment != "at")
        return fail(i, "isn't given, so one component can't be set; set it whole");
      Node& value = append(map, segment);
      if (of_vector) {
        value.kind = Node::Kind::list;
        const Node zero{Node::Kind::scalar, value.mark, "0", {}, {}};
        value.items.assign(axes.size(), zero);
      }
      return &value;
    }
    return &append(map, segment);
  }

  Node& append(Node& map, const std::string& key) {
    map.keys.push_back({key, where_});
    map.items.emplace_back();
    map.items.back().mark = where_;
    return map.items.back();
  }

  static std::string keys_text(const Node& map, const std::string& segment) {
    std::vector<std::string> known;
    for (const Node::Key& key : map.keys) known.push_back(key.text);
    return suggestion(segment, known);
  }

  Node* fail(std::size_t i, const std::string& problem) {
    std::string path = segments_[0];
    for (std::size_t j = 1; j <= i; ++j) path += '.' + segments_[j];
    findings_.error(where_, path, problem);
    return nullptr;
  }

  std::vector<std::string> segments_;
  Mark where_;
  Findings& findings_;
};

/// Take a key with its value out of a map. @returns false where there is none
bool remove_key(Node& map, const std::string& key) {
  for (std::size_t i = 0; i < map.keys.size(); ++i) {
    if (map.keys[i].text != key) continue;
    map.keys.erase(map.keys.begin() + static_cast<std::ptrdiff_t>(i));
    map.items.erase(map.items.begin() + static_cast<std::ptrdiff_t>(i));
    return true;
  }
  return false;
}

/// Take a member out of a list, or a key out of a map. @param path of it; empty: all
/// @param which a name or an index
void remove_member(Node& root, const std::string& path, const Node& which, Mark where,
                   Findings& findings) {
  Node* list = path.empty() ? &root : Walk(path, where, findings).find(root);
  if (!list) return;
  if (list->kind == Node::Kind::map && remove_key(*list, which.text)) return;
  const std::string key = split(path).back();
  const Node* member = is_list(*list) && which.kind == Node::Kind::scalar
                           ? find_member(*list, which.text, key)
                           : nullptr;
  if (member)
    list->items.erase(list->items.begin() + (member - list->items.data()));
  else
    findings.error(where, path.empty() ? "-" : path + ".-",
                   "there is no such member" +
                       (is_list(*list) ? members_text(*list, which.text, key) : ""));
}

}  // namespace

void replace_value(Node& root, const std::string& path, Node value, Mark where,
                   Findings& findings) {
  const std::size_t star = path.starts_with("*.") ? 0 : path.find(".*.");
  if (star != std::string::npos) {
    const std::string before = path.substr(0, star),
                      after = path.substr(path.find('*', star) + 1);
    const Node* all = before.empty() ? &root : Walk(before, where, findings).find(root);
    if (!all) return;
    const std::vector<std::string> members = member_names(*all);
    if (members.empty())
      findings.error(where, before.empty() ? "*" : before + ".*",
                     "there are no members");
    for (const std::string& member : members)
      replace_value(root, (before.empty() ? "" : before + '.') + member + after, value,
                    where, findings);
    return;
  }
  if (path == "-") return remove_member(root, "", value, where, findings);
  if (path.ends_with(".-"))
    return remove_member(root, path.substr(0, path.size() - 2), value, where, findings);
  if (Node* node = Walk(path, where, findings).find(root)) *node = std::move(value);
}

std::optional<Mark> mark_at(Node root, const std::string& path) {
  constexpr int kAdded = -1;
  Findings ignored;
  const Node* node = Walk(path, {kAdded, 0, 0}, ignored).find(root);
  return node && node->mark.source != kAdded ? std::optional(node->mark) : std::nullopt;
}

void apply_override(Node& root, const Override& change, Findings& findings) {
  const int source = findings.add_source("--set " + change.path);
  auto value = parse_yaml(change.value, source, false, findings);
  if (!value) return;
  replace_value(root, change.path, std::move(*value), {source, 0, 0}, findings);
}

std::optional<Override> parse_override(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos || equals == 0) return std::nullopt;
  return Override{std::string(text.substr(0, equals)),
                  std::string(text.substr(equals + 1))};
}

}  // namespace delos

#include "session/names_used.h"

#include <algorithm>

#include "delos/model/metric.h"
#include "delos/scene/definition.h"
#include "session/value_tree.h"

namespace delos::session {
namespace {

/// A key of a section that holds names of another section's members, one or a list.
struct NameUse {
  const char* of;
  const char* section;
  const char* key;
};

constexpr NameUse kUses[] = {
    {"regions", "constraints", "inside"},    {"regions", "constraints", "outside"},
    {"sample", "constraints", "in"},         {"sample", "objective", "set"},
    {"surfaces", "devices", "on"},           {"surfaces", "selection", "surface"},
    {"beacons", "devices", "beacons"},       {"beacons", "selection", "beacons"},
    {"groups", "devices", "group"},          {"groups", "common_errors", "group"},
    {"clocks", "devices", "clock"},          {"devices", "constraints", "devices"},
    {"devices", "common_errors", "devices"}, {"devices", "objective", "failures"},
    {"devices", "selection", "devices"},
};

/// Keys under which paths of numbers stand, in `variables`.
constexpr const char* kPathKeys[] = {"path", "tie", "mirror"};

void rename_text(Json& value, const std::string& from, const std::string& to) {
  if (value.is_array())
    for (Json& item : value) rename_text(item, from, to);
  if (value.is_string() && value == from) value = to;
}

/// The start of a path, where it is that part.
void rename_in_path(Json& value, const std::string& from, const std::string& to) {
  if (value.is_array())
    for (Json& item : value) rename_in_path(item, from, to);
  if (!value.is_string()) return;
  const std::string path = value.get<std::string>();
  if (path.starts_with(from + '.')) value = to + path.substr(from.size());
}

/// Do something to what stands under a key, however deep.
template <class Change>
void each_under(Json& value, const std::string& key, const Change& change) {
  for (auto& [name, inner] : value.items()) {
    if (value.is_object() && name == key) change(inner);
    if (inner.is_structured()) each_under(inner, key, change);
  }
}

std::vector<std::string> members_of(const Json& tree, const std::string& section) {
  std::vector<std::string> names;
  if (!tree.contains(section)) return names;
  const Json& members = tree[section];
  // A single sample set is a mapping of its keys.
  if (section == "sample" && members.is_object())
    return members.contains("name") ? std::vector{members["name"].get<std::string>()}
                                    : names;
  if (members.is_object())
    for (const auto& [name, member] : members.items()) names.push_back(name);
  else
    for (std::size_t i = 0; i < members.size(); ++i)
      if (members[i].contains("name")) names.push_back(member_name(members, i));
  return names;
}

}  // namespace

std::vector<std::string> names_for(const Scene& scene, const Json& tree,
                                   std::string_view section, std::string_view key) {
  if ((section == "constraints" && key == "metric") ||
      (section == "objective" && key == "of"))
    return metric_names(known_metrics(scene));
  for (const NameUse& use : kUses)
    if (use.section == section && use.key == key) return members_of(tree, use.of);
  return {};
}

void rename_part(Json& tree, const std::string& section, const std::string& from,
                 const std::string& to) {
  Json& members = tree[section];
  if (members.is_object()) {
    Json renamed = Json::object();
    for (auto& [name, member] : members.items())
      renamed[name == from ? to : name] = std::move(member);
    members = std::move(renamed);
  } else {
    for (std::size_t i = 0; i < members.size(); ++i)
      if (member_name(members, i) == from) {
        members[i]["name"] = to;
        break;
      }
  }
  for (const NameUse& use : kUses)
    if (use.of == section && tree.contains(use.section))
      each_under(tree[use.section], use.key,
                 [&](Json& value) { rename_text(value, from, to); });
  if (!tree.contains("variables")) return;
  for (const char* key : kPathKeys)
    each_under(tree["variables"], key, [&](Json& value) {
      rename_in_path(value, section + '.' + from, section + '.' + to);
    });
}

}  // namespace delos::session

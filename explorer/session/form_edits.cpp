#include "session/form_edits.h"

#include <algorithm>

#include "delos/document/changed_text.h"
#include "delos/scene/definition.h"
#include "delos/scene/io.h"
#include "session/names_used.h"
#include "session/refusal.h"
#include "session/scene_changes.h"
#include "session/value_tree.h"

namespace delos::session {
namespace {

/// "regions.door" → "regions", "door"
std::pair<std::string, std::string> parted(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  if (dot == std::string::npos)
    throw Refusal(Blame::question, "'" + path + "' is no member of anything");
  return {path.substr(0, dot), path.substr(dot + 1)};
}

std::vector<std::string> member_names(const Json& members) {
  std::vector<std::string> names;
  if (members.is_object())
    for (const auto& [name, member] : members.items()) names.push_back(name);
  for (std::size_t i = 0; members.is_array() && i < members.size(); ++i)
    names.push_back(member_name(members, i));
  return names;
}

const Json& member_at(const Json& tree, const std::string& path) {
  const Json* member = value_at(tree, path);
  if (!member) throw Refusal(Blame::question, "there is no " + path);
  return *member;
}

/// Call the other of two keys, with its value.
void swap_key(const Json& part, const std::string& path, const std::string& from,
              const std::string& to, std::vector<Override>& changes) {
  if (!part.contains(from)) return;
  changes.push_back({path + ".-", from});
  changes.push_back({path + '.' + to, part[from].get<std::string>()});
}

/// What has to change with the metric that a term or a constraint is about.
void follow_metric(const Scene& scene, const Json& tree, const Override& change,
                   std::vector<Override>& changes) {
  const std::vector<std::string> parts = segments_of(change.path);
  const bool term = parts.front() == "objective" && parts.back() == "of";
  if (!term && (parts.front() != "constraints" || parts.back() != "metric")) return;
  const auto metric = parse_metric(change.value, known_metrics(scene));
  const std::string path = parted(change.path).first;
  const Json* part = value_at(tree, path);
  if (!part || !std::holds_alternative<Metric>(metric)) return;
  const bool more = std::get<Metric>(metric).larger_is_better;
  if (!term)
    swap_key(*part, path, more ? "below" : "above", more ? "above" : "below", changes);
  else if (part->value(more ? "minimize" : "maximize", "fraction") != "fraction")
    swap_key(*part, path, more ? "minimize" : "maximize",
             more ? "maximize" : "minimize", changes);
}

}  // namespace

std::string free_among(const std::vector<std::string>& names, const std::string& like) {
  const auto taken = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (!taken(like)) return like;
  std::string base = like;
  const std::size_t mark = base.find_last_not_of("0123456789");
  if (mark != std::string::npos && mark + 1 < base.size() && base[mark] == '_')
    base.resize(mark);
  for (int n = 2;; ++n) {
    std::string name = base + '_' + std::to_string(n);
    if (!taken(name)) return name;
  }
}

std::vector<Override> edits(const Scene& scene, std::vector<Override> changes) {
  const Json tree = value_tree(scene);
  const std::size_t asked = changes.size();
  for (std::size_t i = 0; i < asked; ++i)
    follow_metric(scene, tree, Override(changes[i]), changes);
  const std::string before = write_scene(scene);
  Diagnostics findings;
  const auto after = changed_text(before, changes, findings);
  if (!after) throw Refusal(std::move(findings));
  return changes_between_texts(before, *after);
}

std::vector<Override> copying_part(const Scene& scene, const std::string& path) {
  const auto [list, name] = parted(path);
  const Json tree = value_tree(scene);
  Json copy = member_at(tree, path);
  const Json& members = member_at(tree, list);
  const std::string free = free_among(member_names(members), name);
  if (members.is_object()) return edits(scene, {{list + '.' + free, copy.dump()}});
  if (copy.is_object() && copy.contains("name")) copy["name"] = free;
  return edits(scene, {{list + ".+", copy.dump()}});
}

std::vector<Override> renaming_part(const Scene& scene, const std::string& path,
                                    const std::string& name) {
  const auto [section, old] = parted(path);
  Json tree = value_tree(scene);
  member_at(tree, path);
  const std::vector<std::string> names = member_names(member_at(tree, section));
  if (name == old) return {};
  if (std::find(names.begin(), names.end(), name) != names.end())
    throw Refusal(Blame::question, "there is a " + section + '.' + name + " already");
  const Json before = tree;
  rename_part(tree, section, old, name);
  std::vector<Override> changes;
  for (const auto& [key, value] : tree.items())
    if (value != before[key]) changes.push_back({key, value.dump()});
  return changes;
}

}  // namespace delos::session

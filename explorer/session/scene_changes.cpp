#include "session/scene_changes.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "delos/scene/io.h"
#include "delos/scene/number.h"

namespace delos::session {
namespace {

/// A top-level key of a scene's text, and the YAML behind it.
using WrittenKey = std::pair<std::string, std::string>;

/// What write_scene() writes: a key begins where a line isn't indented.
std::vector<WrittenKey> keys_of(const std::string& text) {
  std::vector<WrittenKey> sections;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(':');
    if (line.empty() || line[0] == ' ' || line[0] == '-' || colon == std::string::npos)
      sections.back().second += '\n' + line;
    else
      sections.emplace_back(line.substr(0, colon), line.substr(colon + 1));
  }
  return sections;
}

const std::string* find_key(const std::vector<WrittenKey>& sections,
                            const std::string& key) {
  const auto found = std::find_if(sections.begin(), sections.end(),
                                  [&](const WrittenKey& k) { return k.first == key; });
  return found == sections.end() ? nullptr : &found->second;
}

/// Orientations may stand in `sample` or beside it: where one of the two is set, both
/// are, so that they stand in one place, whichever the file has chosen.
void keep_orientations(const std::vector<WrittenKey>& after,
                       std::vector<Override>& changes) {
  const auto is_set = [&](const std::string& key) {
    return std::any_of(changes.begin(), changes.end(),
                       [&](const Override& change) { return change.path == key; });
  };
  if (!is_set("sample") && !is_set("orientations")) return;
  for (const char* key : {"sample", "orientations"})
    if (const std::string* text = find_key(after, key); text && !is_set(key))
      changes.push_back({key, *text});
  if (find_key(after, "orientations")) return;
  std::erase_if(changes, [](const Override& change) {
    return change.path == "-" && change.value == "orientations";
  });
  // The file may have none to take away.
  changes.push_back({"orientations", "{}"});
  changes.push_back({"-", "orientations"});
}

double& number_at(Scene& scene, const std::string& path, PluginRegistry& plugins) {
  const auto found = find_number(scene, path, plugins);
  if (const auto* why = std::get_if<std::string>(&found))
    throw std::invalid_argument(path + ": " + *why);
  return *std::get<SceneNumber>(found).value;
}

}  // namespace

std::vector<Override> changes_between(const Scene& from, const Scene& to) {
  return changes_between_texts(write_scene(from), write_scene(to));
}

std::vector<Override> changes_between_texts(const std::string& from,
                                            const std::string& to) {
  const std::vector<WrittenKey> before = keys_of(from), after = keys_of(to);
  std::vector<Override> changes;
  for (const auto& [key, text] : before)
    if (!find_key(after, key)) changes.push_back({"-", key});
  for (const auto& [key, text] : after) {
    const std::string* old = find_key(before, key);
    if (!old || *old != text) changes.push_back({key, text});
  }
  keep_orientations(after, changes);
  return changes;
}

VariableValues values_of(Scene scene, PluginRegistry& plugins) {
  VariableValues all;
  for (const VariableEntry& v : scene.variables) {
    all.paths.push_back(v.path);
    all.values.push_back(number_at(scene, v.path, plugins));
  }
  return all;
}

Scene with_values(Scene scene, const VariableValues& values, PluginRegistry& plugins) {
  for (std::size_t i = 0; i < values.paths.size(); ++i) {
    const std::string& path = values.paths[i];
    const auto v =
        std::find_if(scene.variables.begin(), scene.variables.end(),
                     [&](const VariableEntry& entry) { return entry.path == path; });
    if (v == scene.variables.end())
      throw std::invalid_argument("the scene has no variable " + path +
                                  " any more; undo to where it had");
    number_at(scene, path, plugins) = values.values[i];
    for (const Follower& f : v->followers)
      number_at(scene, f.path, plugins) = f.factor * values.values[i] + f.offset;
  }
  return scene;
}

}  // namespace delos::session

#include "session/search_task.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "delos/optimize/tradeoff.h"
#include "delos/scene/number.h"
#include "delos/text/units.h"
#include "session/description.h"
#include "session/scene_changes.h"
#include "session/search_answer.h"

namespace delos::session {
namespace {

Json selection_kind(const Selection& selection) {
  if (selection.cover) return "cover";
  if (selection.count) return "count";
  return selection.budget ? Json("budget") : Json();
}

VariableEntry* find_variable(Scene& scene, const std::string& path) {
  const auto v =
      std::find_if(scene.variables.begin(), scene.variables.end(),
                   [&](const VariableEntry& entry) { return entry.path == path; });
  return v == scene.variables.end() ? nullptr : &*v;
}

std::vector<std::string> numbers_named(Scene& scene, const std::string& path,
                                       PluginRegistry& plugins) {
  auto found = expand_numbers(scene, path, plugins);
  if (const auto* why = std::get_if<std::string>(&found))
    throw std::invalid_argument(path + ": " + *why);
  return std::get<std::vector<std::string>>(std::move(found));
}

/// A bound: what is typed, else what is known of the number, else that of the room.
double bound_of(const std::string& path, const std::optional<std::string>& typed,
                const std::string& unit, double known, const Eigen::Vector3d& room) {
  if (typed) {
    const auto read = parse_quantity(*typed, unit);
    if (const auto* why = std::get_if<std::string>(&read))
      throw std::invalid_argument(path + ": " + *why);
    return std::get<double>(read);
  }
  if (std::isfinite(known)) return known;
  const std::size_t axis = std::string("xyz").find(path.back());
  const bool component = path.size() > 1 && path[path.size() - 2] == '.';
  if (unit == "m" && component && axis != std::string::npos)
    return room(static_cast<Eigen::Index>(axis));
  throw std::invalid_argument(path + ": nothing bounds it; say its bounds, in " + unit);
}

}  // namespace

Json search_task(const LoadedScene& loaded, PluginRegistry& plugins) {
  Scene scene = loaded.scene;
  Json json{
      {"variables", Json::array()},
      {"objective", {{"name", objective_text(scene)}, {"unit", objective_unit(scene)}}},
      {"constraints", Json::array()},
      {"selection", selection_kind(scene.selection)}};
  for (const VariableEntry& v : scene.variables) {
    const SceneNumber own = variable_of(scene, v.path, plugins);
    json["variables"].push_back({{"path", v.path},
                                 {"unit", own.unit},
                                 {"value", number(*own.value)},
                                 {"lower", number(v.lower)},
                                 {"upper", number(v.upper)},
                                 {"logarithmic", v.scale == ParamScale::log},
                                 {"followers", v.followers.size()}});
  }
  for (const ConstraintEntry& entry : loaded.scene.constraints)
    json["constraints"].push_back(
        {{"name", entry.name},
         {"limit", number(constraint_limit(scene, entry.name))},
         {"unit", constraint_unit(entry, loaded.scene)}});
  return json;
}

std::vector<Override> varying(const LoadedScene& loaded, const std::string& path,
                              const std::optional<std::string>& lower,
                              const std::optional<std::string>& upper,
                              PluginRegistry& plugins) {
  Scene scene = loaded.scene;
  const Eigen::AlignedBox3d room = room_box(loaded);
  for (const std::string& one : numbers_named(scene, path, plugins)) {
    const SceneNumber own = std::get<SceneNumber>(find_number(scene, one, plugins));
    const VariableEntry* known = find_variable(scene, one);
    VariableEntry v = known ? *known : VariableEntry{one, 0, 0, own.scale, {}};
    v.lower = bound_of(one, lower, own.unit, known ? v.lower : own.lower, room.min());
    v.upper = bound_of(one, upper, own.unit, known ? v.upper : own.upper, room.max());
    if (!(v.lower < v.upper))
      throw std::invalid_argument(one + ": its least value must be below its greatest");
    if (!(v.lower > 0)) v.scale = ParamScale::linear;
    if (VariableEntry* there = find_variable(scene, one))
      *there = v;
    else
      scene.variables.push_back(v);
  }
  return changes_between(loaded.scene, scene);
}

std::vector<Override> fixing(const LoadedScene& loaded, const std::string& path,
                             PluginRegistry& plugins) {
  Scene scene = loaded.scene;
  const std::vector<std::string> fixed = numbers_named(scene, path, plugins);
  const auto removed = std::erase_if(scene.variables, [&](const VariableEntry& v) {
    return std::find(fixed.begin(), fixed.end(), v.path) != fixed.end();
  });
  if (removed == 0) throw std::invalid_argument(path + " is no variable");
  return changes_between(loaded.scene, scene);
}

}  // namespace delos::session

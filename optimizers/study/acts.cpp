#include "study/acts.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>

#include "delos/scene/io.h"
#include "delos/scene/number.h"
#include "delos/scene/units.h"

namespace delos {
namespace {

/// Whether a path fits a pattern in which '*' stands for anything; a pattern also fits
/// what its path is a part of: "devices.c1" is all of c1.
bool fits(std::string_view path, std::string_view pattern) {
  if (pattern.empty()) return path.empty() || path.front() == '.';
  if (pattern.front() != '*')
    return !path.empty() && path.front() == pattern.front() &&
           fits(path.substr(1), pattern.substr(1));
  for (std::size_t skip = 0; skip <= path.size(); ++skip)
    if (fits(path.substr(skip), pattern.substr(1))) return true;
  return false;
}

void lock(StudyPosition& now, const std::string& pattern, bool on) {
  bool any = false;
  for (const VariableEntry& v : now.scene.variables) {
    if (!fits(v.path, pattern)) continue;
    any = true;
    const auto at = std::find(now.locked.begin(), now.locked.end(), v.path);
    if (on && at == now.locked.end()) now.locked.push_back(v.path);
    if (!on && at != now.locked.end()) now.locked.erase(at);
  }
  if (!any) {
    std::string known;
    for (const VariableEntry& v : now.scene.variables)
      known += (known.empty() ? "" : ", ") + v.path;
    throw std::invalid_argument("no variable fits '" + pattern + "'; there are " +
                                known);
  }
  if (on && now.locked.size() == now.scene.variables.size())
    throw std::invalid_argument("that would lock every variable; nothing could change");
}

void set(StudyPosition& now, const std::string& text,
         const std::filesystem::path& folder, PluginRegistry& plugins) {
  const auto change = parse_override(text);
  if (!change)
    throw std::invalid_argument("'" + text +
                                "': write PATH=VALUE, such as "
                                "devices.c1.at.z=2.5");
  Diagnostics findings;
  const auto scene = parse_scene(write_scene(now.scene), folder / "scene.yaml",
                                 {*change}, plugins, findings);
  if (!scene) {
    std::string all;
    for (const Diagnostic& finding : findings)
      all += (all.empty() ? "" : "\n") + to_string(finding);
    throw std::invalid_argument(all);
  }
  Scene changed = *scene;
  const auto number = [&](Scene& of, const std::string& path) {
    return std::get<SceneNumber>(find_number(of, path, plugins)).value;
  };
  // What follows a variable follows a hand that moves it too.
  for (const VariableEntry& v : now.scene.variables) {
    const auto own = find_number(changed, v.path, plugins);
    if (!std::holds_alternative<SceneNumber>(own)) continue;
    const double value = *std::get<SceneNumber>(own).value;
    if (value == *number(now.scene, v.path)) continue;
    for (const Follower& f : v.followers)
      *number(changed, f.path) = f.factor * value + f.offset;
  }
  now.scene = std::move(changed);
}

Eigen::Vector3d corner(const std::string& text) {
  std::istringstream in(text);
  Eigen::Vector3d p;
  for (int i = 0; i < 3; ++i) {
    std::string number;
    if (!std::getline(in, number, ','))
      throw std::invalid_argument("'" + text + "': expected a corner X,Y,Z");
    const auto value = parse_quantity(number, "m");
    if (const auto* problem = std::get_if<std::string>(&value))
      throw std::invalid_argument("'" + text + "': " + *problem);
    p(i) = std::get<double>(value);
  }
  return p;
}

void forbid(StudyPosition& now, const std::string& text) {
  const std::size_t blank = text.find(' ');
  if (blank == std::string::npos)
    throw std::invalid_argument("'" + text + "': expected two corners X,Y,Z X,Y,Z");
  const Eigen::Vector3d a = corner(text.substr(0, blank)),
                        b = corner(text.substr(blank + 1));
  const BoxShape box{a.cwiseMin(b), a.cwiseMax(b)};
  if (!((box.max - box.min).array() > 0).all())
    throw std::invalid_argument("'" + text + "': the box is flat");
  std::string name;
  for (int i = 1; name.empty(); ++i) {
    name = "forbidden" + std::to_string(i);
    for (const RegionEntry& region : now.scene.regions)
      if (region.name == name) name.clear();
    if (name.empty()) continue;
    for (const ConstraintEntry& constraint : now.scene.constraints)
      if (constraint.name == name) name.clear();
  }
  now.scene.regions.push_back({name, box, {}});
  KeepInside keep{{}, name, true, 0};
  for (const DeviceEntry& device : now.scene.devices)
    keep.devices.push_back(device.name);
  now.scene.constraints.push_back({name, std::move(keep)});
}

}  // namespace

StudyPosition after_acts(StudyPosition position, const std::vector<StudyAct>& acts,
                         const std::filesystem::path& folder, PluginRegistry& plugins) {
  std::vector<StudyPosition> before;
  for (const StudyAct& act : acts) {
    if (act.verb == "undo") {
      if (before.empty())
        throw std::invalid_argument("there is no act since the last round to undo");
      position = std::move(before.back());
      before.pop_back();
      continue;
    }
    before.push_back(position);
    if (act.verb == "lock" || act.verb == "unlock") {
      lock(position, act.argument, act.verb == "lock");
    } else if (act.verb == "set") {
      set(position, act.argument, folder, plugins);
    } else if (act.verb == "forbid") {
      forbid(position, act.argument);
    } else if (act.verb == "extend") {
      const auto count = parse_quantity(act.argument, "1");
      const auto* number = std::get_if<double>(&count);
      if (!number || !(*number >= 1 && *number <= 1e9))
        throw std::invalid_argument("'" + act.argument +
                                    "': expected a number of evaluations");
    } else {
      throw std::invalid_argument("there is no act '" + act.verb + "'");
    }
  }
  return position;
}

void remove_locked(Scene& scene, const std::vector<std::string>& locked) {
  std::erase_if(scene.variables, [&](const VariableEntry& v) {
    return std::find(locked.begin(), locked.end(), v.path) != locked.end();
  });
}

std::string text_of(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  return text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace delos

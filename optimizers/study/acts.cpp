#include "study/acts.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>

#include "delos/scene/followers.h"
#include "delos/scene/io.h"
#include "delos/scene/number.h"
#include "delos/text/units.h"
#include "delos/text/words.h"

namespace delos {
namespace {

/// A pattern also fits what its path is a part of: "devices.c1" is all of c1.
bool path_fits(std::string_view path, const std::string& pattern) {
  return fits(path, pattern) || fits(path, pattern + ".*");
}

void lock(StudyPosition& now, const std::string& pattern, bool on) {
  bool any = false;
  for (const VariableEntry& v : now.scene.variables) {
    if (!path_fits(v.path, pattern)) continue;
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

/// The scene with some of its text changed.
Scene changed(const Scene& scene, const std::vector<Override>& changes,
              const std::filesystem::path& folder, PluginRegistry& plugins) {
  Diagnostics findings;
  auto read = parse_scene(write_scene(scene), folder / "scene.yaml", changes, plugins,
                          findings);
  if (read) return *std::move(read);
  std::string all;
  for (const Diagnostic& finding : findings)
    all += (all.empty() ? "" : "\n") + to_string(finding);
  throw std::invalid_argument(all);
}

void set(StudyPosition& now, const std::string& text,
         const std::filesystem::path& folder, PluginRegistry& plugins) {
  const auto change = parse_override(text);
  if (!change)
    throw std::invalid_argument("'" + text +
                                "': write PATH=VALUE, such as "
                                "devices.c1.at.z=2.5");
  Scene other = changed(now.scene, {*change}, folder, plugins);
  const std::vector<Override> more = following(now.scene, other, plugins);
  now.scene = more.empty() ? std::move(other) : changed(other, more, folder, plugins);
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

std::string free_name(const Scene& scene) {
  for (int i = 1;; ++i) {
    const std::string name = "forbidden" + std::to_string(i);
    const auto is = [&](const auto& entry) { return entry.name == name; };
    if (std::none_of(scene.regions.begin(), scene.regions.end(), is) &&
        std::none_of(scene.constraints.begin(), scene.constraints.end(), is))
      return name;
  }
}

/// The body that text stands for: two corners, or a region as scenes write it.
RegionEntry region_of(const StudyPosition& now, const std::string& text,
                      const std::filesystem::path& folder, PluginRegistry& plugins) {
  const std::string name = free_name(now.scene);
  if (text.find('{') != std::string::npos) {
    const Scene scene = changed(
        now.scene, {{"constraints", "[]"}, {"regions", '{' + name + ": " + text + '}'}},
        folder, plugins);
    return scene.regions.front();
  }
  const std::size_t blank = text.find(' ');
  if (blank == std::string::npos)
    throw std::invalid_argument(
        "'" + text +
        "': expected a region's name, two corners X,Y,Z X,Y,Z "
        "or a body such as {sphere: {radius: 1}, at: [0, 0, 2]}");
  const Eigen::Vector3d a = corner(text.substr(0, blank)),
                        b = corner(text.substr(blank + 1));
  const BoxShape box{a.cwiseMin(b), a.cwiseMax(b)};
  if (!((box.max - box.min).array() > 0).all())
    throw std::invalid_argument("'" + text + "': the box is flat");
  return {name, box, {}};
}

void forbid(StudyPosition& now, const std::string& text,
            const std::filesystem::path& folder, PluginRegistry& plugins) {
  std::vector<RegionEntry>& regions = now.scene.regions;
  const auto known = std::find_if(regions.begin(), regions.end(),
                                  [&](const RegionEntry& r) { return r.name == text; });
  const std::string name = free_name(now.scene);
  std::string region = text;
  if (known == regions.end()) {
    RegionEntry entry = region_of(now, text, folder, plugins);
    region = entry.name;
    regions.push_back(std::move(entry));
  }
  set(now, "constraints.+={name: " + name + ", outside: " + region + ", devices: '*'}",
      folder, plugins);
}

void drop(StudyPosition& now, const std::string& name) {
  std::vector<ConstraintEntry>& all = now.scene.constraints;
  if (std::erase_if(all, [&](const ConstraintEntry& c) { return c.name == name; }) > 0)
    return;
  std::string known;
  for (const ConstraintEntry& c : all) known += (known.empty() ? "" : ", ") + c.name;
  throw std::invalid_argument("there is no constraint '" + name + "'" +
                              (known.empty() ? "" : "; there are " + known));
}

/// A design from elsewhere: PATH=VALUE in SI, line by line.
void inject(StudyPosition& now, const std::string& text, PluginRegistry& plugins) {
  for (const std::string& line : lines_of(text)) {
    const auto change = parse_override(line);
    const auto& variables = now.scene.variables;
    const auto v = std::find_if(variables.begin(), variables.end(),
                                [&](const VariableEntry& entry) {
                                  return change && entry.path == change->path;
                                });
    if (v == variables.end())
      throw std::invalid_argument("'" + line + "': expected VARIABLE=VALUE");
    const auto parsed = parse_quantity(change->value, "1");
    const auto* value = std::get_if<double>(&parsed);
    if (!value)
      throw std::invalid_argument("'" + line + "': " + std::get<std::string>(parsed));
    if (!(*value >= v->lower && *value <= v->upper))
      throw std::invalid_argument("'" + line + "': the bounds of the variable are " +
                                  shortest(v->lower) + " and " + shortest(v->upper));
    const auto number = [&](const std::string& path) {
      return std::get<SceneNumber>(find_number(now.scene, path, plugins)).value;
    };
    *number(v->path) = *value;
    for (const Follower& f : v->followers)
      *number(f.path) = f.factor * *value + f.offset;
  }
}

int count_of(const std::string& text) {
  const auto count = parse_quantity(text, "1");
  const auto* number = std::get_if<double>(&count);
  if (!number || !(*number >= 1 && *number <= 1e9))
    throw std::invalid_argument("'" + text + "': expected a number of evaluations");
  return static_cast<int>(*number);
}

}  // namespace

StudyPosition after_act(StudyPosition position, const StudyAct& act,
                        const std::filesystem::path& folder, PluginRegistry& plugins) {
  if (act.verb == "lock" || act.verb == "unlock") {
    lock(position, act.argument, act.verb == "lock");
  } else if (act.verb == "set") {
    set(position, act.argument, folder, plugins);
  } else if (act.verb == "keep") {
    set(position, "constraints.+=" + act.argument, folder, plugins);
  } else if (act.verb == "drop") {
    drop(position, act.argument);
  } else if (act.verb == "forbid") {
    forbid(position, act.argument, folder, plugins);
  } else if (act.verb == "inject") {
    inject(position, act.argument, plugins);
  } else if (act.verb == "extend") {
    position.evaluations = count_of(act.argument);
  } else {
    throw std::invalid_argument("there is no act '" + act.verb + "'");
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

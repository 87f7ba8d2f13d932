#include "delos/optimize/design.h"

#include <algorithm>
#include <cmath>

#include "delos/text/units.h"

namespace delos {

Design::Design(const Scene& scene, PluginRegistry& plugins)
    : plugins_(&plugins), scene_(std::make_unique<Scene>(scene)) {
  for (const VariableEntry& v : scene_->variables) {
    const auto number = [&](const std::string& path) {
      return std::get<SceneNumber>(find_number(*scene_, path, plugins));
    };
    const SceneNumber own = number(v.path);
    std::vector<Drive> drives = {{own.value, 1, 0}};
    for (const Follower& f : v.followers)
      drives.push_back({number(f.path).value, f.factor, f.offset});
    drives_.push_back(std::move(drives));

    const double given = *own.value, inside = std::clamp(given, v.lower, v.upper);
    if (given != inside)
      repairs_.push_back(v.path + " is " + shortest(given) + ", outside " +
                         shortest(v.lower) + " to " + shortest(v.upper) +
                         "; the search starts at " + shortest(inside));
    const bool log = v.scale == ParamScale::log;
    start_.push_back(log ? std::log(inside / v.lower) / std::log(v.upper / v.lower)
                         : (inside - v.lower) / (v.upper - v.lower));
  }
}

const double* Design::number(const std::string& path) const {
  return std::get<SceneNumber>(find_number(*scene_, path, *plugins_)).value;
}

double Design::value(std::size_t variable, double x) const {
  const VariableEntry& v = scene_->variables[variable];
  if (v.scale == ParamScale::log) return v.lower * std::pow(v.upper / v.lower, x);
  // Both ends are met exactly.
  return x == 1 ? v.upper : v.lower + x * (v.upper - v.lower);
}

void Design::set(std::size_t variable, double x) {
  const double v = value(variable, x);
  for (const Drive& drive : drives_[variable])
    *drive.number = drive.factor * v + drive.offset;
}

void Design::set(std::span<const double> x) {
  for (std::size_t i = 0; i < size(); ++i) set(i, x[i]);
}

}  // namespace delos

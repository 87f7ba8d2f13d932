#include "delos/scene/followers.h"

#include "delos/plugin/registry.h"
#include "delos/scene/number.h"
#include "delos/text/units.h"

namespace delos {
namespace {

/// Null where the scene has no number of this path.
const double* value_at(Scene& scene, const std::string& path, PluginRegistry& plugins) {
  const auto found = find_number(scene, path, plugins);
  const auto* number = std::get_if<SceneNumber>(&found);
  return number ? number->value : nullptr;
}

}  // namespace

std::vector<Override> following(Scene before, Scene after, PluginRegistry& plugins) {
  std::vector<Override> changes;
  const std::vector<VariableEntry> variables = after.variables;
  for (const VariableEntry& v : variables) {
    if (v.followers.empty()) continue;
    const double *was = value_at(before, v.path, plugins),
                 *is = value_at(after, v.path, plugins);
    if (!was || !is || *was == *is) continue;
    for (const Follower& f : v.followers)
      changes.push_back({f.path, shortest(f.factor * *is + f.offset)});
  }
  return changes;
}

}  // namespace delos

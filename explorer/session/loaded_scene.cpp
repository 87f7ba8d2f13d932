#include "session/loaded_scene.h"

#include "delos/scene/definition.h"

namespace delos::session {

std::optional<LoadedScene> load(const std::filesystem::path& file,
                                const std::vector<Override>& overrides,
                                PluginRegistry& plugins, Diagnostics& diagnostics,
                                const MeshProgress& progress, const System* previous) {
  const std::optional<Scene> scene =
      load_scene(file, overrides, plugins, diagnostics, progress);
  if (!scene) return std::nullopt;
  const auto metric = parse_metric(scene->metric, known_metrics(*scene));
  LoadedScene loaded{*scene, build_system(*scene, plugins, previous),
                     std::get<Metric>(metric)};
  if (loaded.scene.name.empty()) loaded.scene.name = file.stem().string();
  return loaded;
}

}  // namespace delos::session

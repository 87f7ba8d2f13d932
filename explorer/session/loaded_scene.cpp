#include "session/loaded_scene.h"

#include <utility>

#include "delos/scene/definition.h"
#include "session/refusal.h"

namespace delos::session {

LoadedScene loaded_from(Scene scene, PluginRegistry& plugins, const System* previous) {
  const auto metric = parse_metric(scene.metric, known_metrics(scene));
  System system = build_system(scene, plugins, previous);
  return {std::move(scene), std::move(system), std::get<Metric>(metric)};
}

std::optional<LoadedScene> load(const SceneSource& source, PluginRegistry& plugins,
                                Diagnostics& diagnostics, const MeshProgress& progress,
                                const System* previous) {
  std::optional<Scene> scene =
      source.text
          ? parse_scene(*source.text, source.file, source.changes, plugins, diagnostics,
                        progress)
          : load_scene(source.file, source.changes, plugins, diagnostics, progress);
  if (!scene) return std::nullopt;
  if (scene->name.empty()) scene->name = source.file.stem().string();
  return loaded_from(std::move(*scene), plugins, previous);
}

std::optional<LoadedScene> load(const std::filesystem::path& file,
                                const std::vector<Override>& overrides,
                                PluginRegistry& plugins, Diagnostics& diagnostics,
                                const MeshProgress& progress, const System* previous) {
  return load({file, std::nullopt, overrides}, plugins, diagnostics, progress,
              previous);
}

LoadedScene load(const SceneSource& source, PluginRegistry& plugins) {
  Diagnostics findings;
  std::optional<LoadedScene> loaded = load(source, plugins, findings);
  if (!loaded) throw Refusal(std::move(findings));
  return std::move(*loaded);
}

}  // namespace delos::session

#include "session/loaded_scene.h"

#include <utility>

#include "delos/scene/definition.h"
#include "session/refusal.h"

namespace delos::session {
namespace {

void name_after(const std::filesystem::path& file, Scene& scene) {
  if (scene.name.empty()) scene.name = file.stem().string();
}

}  // namespace

LoadedScene loaded_from(Scene scene, PluginRegistry& plugins, const System* previous) {
  const auto metric = parse_metric(scene.metric, known_metrics(scene));
  System system = build_system(scene, plugins, previous);
  return {std::move(scene), std::move(system), std::get<Metric>(metric)};
}

std::optional<LoadedScene> load(const std::filesystem::path& file,
                                const std::vector<Override>& overrides,
                                PluginRegistry& plugins, Diagnostics& diagnostics,
                                const MeshProgress& progress, const System* previous) {
  std::optional<Scene> scene =
      load_scene(file, overrides, plugins, diagnostics, progress);
  if (!scene) return std::nullopt;
  name_after(file, *scene);
  return loaded_from(std::move(*scene), plugins, previous);
}

LoadedScene load(const SceneSource& source, PluginRegistry& plugins) {
  Diagnostics findings;
  std::optional<Scene> scene =
      source.text
          ? parse_scene(*source.text, source.file, source.changes, plugins, findings)
          : load_scene(source.file, source.changes, plugins, findings);
  if (!scene) throw Refusal(std::move(findings));
  name_after(source.file, *scene);
  return loaded_from(std::move(*scene), plugins);
}

}  // namespace delos::session

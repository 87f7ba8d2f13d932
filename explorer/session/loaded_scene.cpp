#include "session/loaded_scene.h"

#include "delos/scene/definition.h"

namespace delos::session {

namespace {

std::optional<LoadedScene> built(const std::optional<Scene>& scene,
                                 const std::filesystem::path& file,
                                 PluginRegistry& plugins, const System* previous) {
  if (!scene) return std::nullopt;
  const auto metric = parse_metric(scene->metric, known_metrics(*scene));
  LoadedScene loaded{*scene, build_system(*scene, plugins, previous),
                     std::get<Metric>(metric)};
  if (loaded.scene.name.empty()) loaded.scene.name = file.stem().string();
  return loaded;
}

}  // namespace

std::optional<LoadedScene> load(const std::filesystem::path& file,
                                const std::vector<Override>& overrides,
                                PluginRegistry& plugins, Diagnostics& diagnostics,
                                const MeshProgress& progress, const System* previous) {
  return built(load_scene(file, overrides, plugins, diagnostics, progress), file,
               plugins, previous);
}

std::optional<LoadedScene> load_text(const std::string& text,
                                     const std::filesystem::path& file,
                                     const std::vector<Override>& overrides,
                                     PluginRegistry& plugins, Diagnostics& diagnostics,
                                     const System* previous) {
  return built(parse_scene(text, file, overrides, plugins, diagnostics), file, plugins,
               previous);
}

}  // namespace delos::session

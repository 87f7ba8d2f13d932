#include "delos/scene/io.h"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "scene/extends.h"
#include "scene/node_text.h"
#include "scene/override.h"
#include "scene/scene_keys.h"

namespace delos {

std::optional<Scene> load_scene(const std::filesystem::path& file,
                                const std::vector<Override>& overrides,
                                PluginRegistry& plugins, Diagnostics& diagnostics,
                                const MeshProgress& progress) {
  const auto refuse = [&](const std::string& why) {
    Diagnostic diagnostic;
    diagnostic.where.file = file.string();
    diagnostic.message = "the scene can't be read: " + why;
    diagnostics.push_back(std::move(diagnostic));
    return std::nullopt;
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) return refuse("it is a folder");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return refuse(std::generic_category().message(errno));
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return parse_scene(text, file, overrides, plugins, diagnostics, progress);
}

std::optional<Scene> parse_scene(std::string_view text,
                                 const std::filesystem::path& file,
                                 const std::vector<Override>& overrides,
                                 PluginRegistry& plugins, Diagnostics& diagnostics,
                                 const MeshProgress& progress) {
  Findings findings;
  const int source = findings.add_source(file.string());
  std::optional<Scene> scene;
  Reader reader{findings, plugins, file.parent_path(), MeshFiles(progress)};
  auto tree = parse_yaml(text, source, true, findings);
  if (tree) tree = resolve_extends(std::move(*tree), reader);
  if (tree) {
    for (const Override& change : overrides) apply_override(*tree, change, findings);
    scene = read_scene(reader, *tree);
  }
  if (findings.errors() > 0) scene.reset();
  findings.move_to(diagnostics);
  return scene;
}

std::string write_scene(const Scene& scene) { return to_yaml(scene_node(scene)); }

}  // namespace delos

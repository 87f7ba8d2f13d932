#include "imports/imported.h"

namespace delos::test {

PluginRegistry& import_plugins() {
  static PluginRegistry registry({DELOS_PLUGINS});
  return registry;
}

Imported imported(const std::vector<std::pair<std::string, std::string>>& files,
                  const imports::ImportOptions& options) {
  const Folder folder;
  for (const auto& [name, bytes] : files) folder.write(name, bytes);
  Diagnostics findings;
  Imported out;
  out.rig = imports::import_file(folder / files[0].first, {}, options, findings);
  if (out.rig) {
    out.text = imports::scene_text(*out.rig, files[0].first, files[0].first);
    out.scene =
        parse_scene(out.text, folder / "scene.yaml", {}, import_plugins(), findings);
  }
  if (out.scene) out.system = build_system(*out.scene, import_plugins());
  for (const Diagnostic& d : findings) {
    const std::string line = to_string(d);
    out.findings += line.substr(line.rfind('/', line.find(": ")) + 1) + "\n";
  }
  return out;
}

}  // namespace delos::test

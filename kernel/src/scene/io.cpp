#include "delos/scene/io.h"

#include <utility>

#include "delos/document/file_commit.h"
#include "document/extends.h"
#include "document/file_text.h"
#include "document/node_text.h"
#include "document/override.h"
#include "scene/device_keys.h"
#include "scene/motion_keys.h"
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
  std::string why;
  const std::optional<std::string> text = file_text(file, why);
  if (!text) return refuse(why);
  return parse_scene(*text, file, overrides, plugins, diagnostics, progress);
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

Diagnostics warnings_of(const std::filesystem::path& file,
                        const std::vector<Remark>& remarks, PluginRegistry& plugins) {
  Diagnostics warnings;
  if (remarks.empty()) return warnings;
  Findings ignored, findings;
  for (Findings* both : {&ignored, &findings}) both->add_source(file.string());
  std::optional<Node> tree;
  std::string why;
  if (const std::optional<std::string> text = file_text(file, why)) {
    Reader reader{ignored, plugins, file.parent_path()};
    tree = parse_yaml(*text, 0, true, ignored);
    if (tree) tree = resolve_extends(std::move(*tree), reader);
  }
  for (const Remark& remark : remarks) {
    // Bases are texts of their own, whose numbers mean nothing here.
    std::optional<Mark> mark = tree ? mark_at(*tree, remark.path) : std::nullopt;
    if (mark && mark->source != 0) mark.reset();
    findings.warning(mark.value_or(Mark{}), remark.path, remark.message);
  }
  findings.move_to(warnings);
  return warnings;
}

namespace {

/// Every file that a scene names by a path relative to itself.
template <class Visit>
void visit_files(Scene& scene, Visit&& visit) {
  const auto body = [&](Body& b) {
    if (auto* mesh = std::get_if<MeshShape>(&b)) visit(mesh->file);
  };
  for (OccluderEntry& occluder : scene.occluders) body(occluder.body);
  for (RegionEntry& region : scene.regions) body(region.body);
  for (SurfaceEntry& surface : scene.surfaces) {
    if (auto* mesh = std::get_if<MeshSurface>(&surface.shape)) visit(mesh->mesh.file);
  }
  for (BeaconSet& set : scene.beacons) {
    auto* list = std::get_if<BeaconList>(&set.layout);
    if (list && !list->file.empty()) visit(list->file);
  }
  for (SampleSet& set : scene.samples) {
    if (auto* mesh = std::get_if<MeshSampling>(&set.shape)) visit(mesh->surface.file);
    if (auto* path = std::get_if<PathSampling>(&set.shape)) {
      if (!path->file.empty()) visit(path->file);
    }
    if (auto* points = std::get_if<PointSampling>(&set.shape)) {
      if (!points->file.empty()) visit(points->file);
    }
  }
}

// A scene in the current folder has "" for its own: with a name it can be resolved.
std::filesystem::path whole(const std::filesystem::path& path) {
  return std::filesystem::absolute(path).lexically_normal();
}

}  // namespace

Scene with_absolute_files(Scene scene, const std::filesystem::path& folder) {
  visit_files(scene, [&](std::string& name) {
    const std::filesystem::path path = name;
    if (!path.is_absolute()) name = whole(folder / path).string();
  });
  return scene;
}

std::string save_scene(Scene scene, const std::filesystem::path& folder,
                       const std::filesystem::path& file) {
  visit_files(scene, [&](std::string& name) {
    const std::filesystem::path path = name;
    if (path.is_absolute()) return;
    name = whole(folder / path).lexically_relative(whole(file).parent_path()).string();
  });
  if (const std::string problem = missing_folder(file); !problem.empty())
    return problem;
  return commit_file(file, [&](std::ostream& out) { out << write_scene(scene); });
}

Override motion_override(const MotionEntry& motion) {
  return {"motion", to_yaml(write_motion(motion.motion))};
}

Override device_override(const DeviceEntry& device) {
  return {"devices.+", to_yaml(write_devices({device}).items.front())};
}

std::string write_scene(const Scene& scene) { return to_yaml(scene_node(scene)); }

}  // namespace delos

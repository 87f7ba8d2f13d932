// Scenes from text and back.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "delos/document/diagnostic.h"
#include "delos/document/override.h"
#include "delos/geometry/mesh.h"
#include "delos/plugin/registry.h"
#include "delos/scene/scene.h"

namespace delos {

/// Read a scene file.
///
/// Every value is checked against the parameter tables of the plugins that the scene
/// names; all findings of the file are reported together, none is mended silently.
/// A scene may extend another: `extends: base.yaml` takes over the base's keys but
/// those that it has itself, and `set: {PATH: value}` then changes single values.
/// @param overrides applied in order before the check; findings in them are located as
///        "--set PATH".
/// @returns nullopt where a finding is an error.
[[nodiscard]] DELOS_API std::optional<Scene> load_scene(
    const std::filesystem::path& file, const std::vector<Override>& overrides,
    PluginRegistry& plugins, Diagnostics& diagnostics,
    const MeshProgress& progress = {});

/// The same from text; `file` names it in messages and is what relative paths start
/// from.
[[nodiscard]] DELOS_API std::optional<Scene> parse_scene(
    std::string_view text, const std::filesystem::path& file,
    const std::vector<Override>& overrides, PluginRegistry& plugins,
    Diagnostics& diagnostics, const MeshProgress& progress = {});

/// Remarks on a scene as warnings, located where its file has the parts that they
/// are about.
/// @param file as load_scene() read it
[[nodiscard]] DELOS_API Diagnostics warnings_of(const std::filesystem::path& file,
                                                const std::vector<Remark>& remarks,
                                                PluginRegistry& plugins);

/// The scene as YAML in SI units; reading it gives the same scene, bit for bit.
[[nodiscard]] DELOS_API std::string write_scene(const Scene& scene);

/// The change that gives a scene one of its `motions`, by name, as its motion.
[[nodiscard]] DELOS_API Override motion_override(const MotionEntry& motion);

/// The change that adds a device to a scene.
[[nodiscard]] DELOS_API Override device_override(const DeviceEntry& device);

/// The scene with the files that it names by relative paths named by absolute ones, so
/// that its text can stand in any folder.
/// @param folder where its relative paths start
[[nodiscard]] DELOS_API Scene with_absolute_files(Scene scene,
                                                  const std::filesystem::path& folder);

/// Write the scene to a file, whole or not at all. Files that it names by relative
/// paths are found from the new place too.
/// @param folder where the scene's relative paths start now
/// @returns empty, or a sentence that says why it was not written
[[nodiscard]] DELOS_API std::string save_scene(Scene scene,
                                               const std::filesystem::path& folder,
                                               const std::filesystem::path& file);

}  // namespace delos

// A scene's field as files, and as what pictures of it are cut from.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "output/write.h"
#include "session/scene_field.h"

namespace delos::session {

/// The samples that a scene will have; of adaptive ones, an octree without nodes.
[[nodiscard]] Samples planned_samples(const Scene& scene);

/// Where a level plane misses all that is sampled, from where to where that reaches;
/// else empty.
[[nodiscard]] std::string missed_by_slice(const Scene& scene, const Samples& samples,
                                          double z);

/// Whether a file to be written is a scene, by its name.
[[nodiscard]] bool is_scene(const std::filesystem::path& file);

/// Why `file` can't show these samples; empty where it can. As writable(), but that
/// octrees are drawn too.
[[nodiscard]] std::string drawable(const Scene& scene, const Samples& samples,
                                   const std::filesystem::path& file);

/// Write a field as write_field() does, or, ".field", as store_field(); a picture of an
/// octree is read on a plane.
/// @returns empty, or why it was not written
[[nodiscard]] std::string write_evaluation(const Evaluation& evaluation,
                                           const Scene& scene,
                                           const std::filesystem::path& file,
                                           const PictureOptions& picture);

/// What a picture shows: the field itself, or an octree read on a level plane.
[[nodiscard]] Field picture_field(const Evaluation& evaluation, const Scene& scene,
                                  const PictureOptions& picture);

}  // namespace delos::session

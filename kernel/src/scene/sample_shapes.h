// Shapes of samples: the keys of `volume`, `plane`, `path` and `mesh`.
#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "delos/scene/scene.h"
#include "document/keys.h"

namespace delos {

// nullopt: there is a finding.
[[nodiscard]] std::optional<std::variant<VolumeSampling, AdaptiveSampling>> read_volume(
    Reader& reader, const Place& at);
/// Warns where the last samples of a box are far from its end.
void check_reach(Reader& reader, const Place& at, const VolumeSampling& volume);

[[nodiscard]] std::optional<PlaneSampling> read_plane(Reader& reader, const Place& at);
[[nodiscard]] std::optional<MeshSampling> read_mesh_samples(Reader& reader,
                                                            const Place& at);

[[nodiscard]] std::optional<PathSampling> read_path(Reader& reader, const Place& at);

/// A value of the metric, above 0. @returns nullopt where there is a finding.
[[nodiscard]] std::optional<double> read_near_value(Reader& reader, const Place& at,
                                                    std::string_view unit);

[[nodiscard]] Node write_volume(const VolumeSampling& volume);
[[nodiscard]] Node write_volume(const AdaptiveSampling& volume);
[[nodiscard]] Node write_mesh_samples(const MeshSampling& mesh);
[[nodiscard]] Node write_plane(const PlaneSampling& plane);
[[nodiscard]] Node write_path(const PathSampling& path);

[[nodiscard]] std::vector<KeyShape> volume_keys();
[[nodiscard]] std::vector<KeyShape> plane_keys();
[[nodiscard]] std::vector<Shape> mesh_sample_forms();
[[nodiscard]] std::vector<Shape> path_forms();

}  // namespace delos

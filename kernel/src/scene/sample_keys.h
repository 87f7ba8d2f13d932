// Where a system is evaluated: the keys of `sample` and `orientations`.
#pragma once

#include <optional>
#include <string_view>

#include "delos/scene/scene.h"
#include "document/keys.h"

namespace delos {

/// Most samples of a scene; more would rather fill a machine's memory than tell
/// anything.
inline constexpr std::int64_t kMostSamples = 50'000'000;

/// Read the sets of `sample`: one mapping, or a list of them. Orientations belong to
/// the whole scene; they may stand in the mapping, or beside `sample` in the scene.
void read_samples(Reader& reader, const Place& at, Scene& out);
/// Read `near` of an adaptive set, a value of the metric.
/// @param at  `sample`, which has been read
/// @param unit the metric's
void read_near(Reader& reader, const Place& at, std::string_view unit, Scene& out);
void read_orientations(Reader& reader, const Place& at, Orientations& out);

[[nodiscard]] Node write_samples(const Scene& scene);
/// @returns nullopt where write_samples() has written them.
[[nodiscard]] std::optional<Node> write_orientations(const Scene& scene);

[[nodiscard]] std::vector<KeyShape> orientation_keys();
[[nodiscard]] std::vector<Shape> sample_forms();

}  // namespace delos

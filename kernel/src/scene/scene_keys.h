// The whole scene: its top-level keys and the checks that need several of them.
#pragma once

#include "delos/scene/scene.h"
#include "document/keys.h"

namespace delos {

/// @returns a scene that is complete where the reader has no findings.
[[nodiscard]] Scene read_scene(Reader& reader, const Node& root);

/// All keys of a scene.
[[nodiscard]] std::vector<KeyShape> scene_keys();

[[nodiscard]] Node scene_node(const Scene& scene);

}  // namespace delos

// The target: what of it devices see.
#pragma once

#include "delos/scene/scene.h"
#include "document/keys.h"

namespace delos {

void read_target(Reader& reader, const Place& at, Scene& scene);

/// nullopt where it is one marker at its origin.
[[nodiscard]] std::optional<Node> write_target(const Scene& scene);

[[nodiscard]] std::vector<KeyShape> target_keys();

}  // namespace delos

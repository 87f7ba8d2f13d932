// Scenes with a device more or less.
#pragma once

#include <string>

#include "delos/scene/scene.h"

namespace delos {

/// Whether variables of its own move a device or change it.
[[nodiscard]] bool has_variables(const Scene& scene, const std::string& device);

/// The scene without a device: without its variables, and no constraint speaks of it.
/// @throws std::invalid_argument others follow its variables, or it follows theirs
[[nodiscard]] Scene without_device(Scene scene, const std::string& device);

/// The scene with a copy of a device, with variables like its own; constraints that
/// speak of the device speak of the copy too, sums with the same factor.
/// @returns the scene, in which the copy is the last device
/// @throws std::invalid_argument as without_device()
[[nodiscard]] Scene with_copy(Scene scene, const std::string& device);

}  // namespace delos

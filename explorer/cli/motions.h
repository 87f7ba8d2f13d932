// A scene under one of its motions, or all of them.
#pragma once

#include "command.h"

namespace delos::cli {

/// The options with the scene's motion changed to one of its `motions`; --set comes
/// after, as always.
/// @param scene as it was loaded without
/// @throws Failure kUsage the scene has no such motion
[[nodiscard]] SceneOptions with_motion(const SceneOptions& options, const Scene& scene,
                                       const std::string& name);

}  // namespace delos::cli

// Changes of a scene as its form shows it.
#pragma once

#include <string>
#include <vector>

#include "delos/document/override.h"
#include "delos/scene/scene.h"

namespace delos::session {

/// The changes of top-level keys that changes of the scene as it is written come to:
/// whatever its file says, they mean what scene_form() shows. Where a metric is named
/// of which more is better, what was minimized is maximized, and the other way round.
/// @throws Refusal a path leads nowhere, or a value isn't YAML
[[nodiscard]] std::vector<Override> edits(const Scene& scene,
                                          std::vector<Override> changes);

/// The same member of a list or a table once more, by another name.
/// @param path "regions.door" @throws Refusal there is no such member
[[nodiscard]] std::vector<Override> copying_part(const Scene& scene,
                                                 const std::string& path);

/// A member of a section called otherwise, also where others name it.
/// @throws Refusal there is no such member, or another one is called so
[[nodiscard]] std::vector<Override> renaming_part(const Scene& scene,
                                                  const std::string& path,
                                                  const std::string& name);

/// "door" → "door_2" where others are called so
[[nodiscard]] std::string free_among(const std::vector<std::string>& names,
                                     const std::string& like);

}  // namespace delos::session

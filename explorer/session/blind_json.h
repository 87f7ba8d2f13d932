// Where a field is blind and why, for pages.
#pragma once

#include "delos/field/blind.h"
#include "session/json.h"
#include "session/loaded_scene.h"

namespace delos::session {

/// {samples, count, regions: [{samples, unseen, least_lost, most_lost, box: {min, max},
/// why, views: [{device, sees, hidden, beyond}]}]}, the largest first.
/// @param most regions that are told; `samples` and `count` are of all
[[nodiscard]] Json blind_json(const LoadedScene& loaded, const Field& field,
                              std::size_t most);

}  // namespace delos::session

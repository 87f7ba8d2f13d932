// Some of a scene's places, for questions that needn't be asked of all.
#pragma once

#include <cstddef>
#include <vector>

#include "delos/api.h"
#include "delos/model/pose.h"
#include "delos/scene/scene.h"

namespace delos {

/// X_WT at some of the samples and orientations of a scene, at most `most`: one out of
/// each of as many equal ranges, always the same ones. Of adaptive samples, the middles
/// of equal parts of the box.
[[nodiscard]] DELOS_API std::vector<Pose> spread_poses(const Scene& scene,
                                                       std::size_t most);

}  // namespace delos

// Bodies and regions put somewhere by hand, as changes of their scene.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "delos/document/override.h"
#include "session/loaded_scene.h"

namespace delos::session {

/// The changes that put an occluder or a region elsewhere, or give a box another size
/// about its middle.
/// @param path "occluders.NAME", by index where it has no name, or "regions.NAME"
/// @param p    where the middle of its bounds goes, world, metres; nullopt: it stays
/// @param size of a box, along its own axes, metres; nullopt: as it is
/// @throws Refusal there is no such body, or it can't be
[[nodiscard]] std::vector<Override> shaping(const Scene& scene, const std::string& path,
                                            const std::optional<Eigen::Vector3d>& p,
                                            const std::optional<Eigen::Vector3d>& size);

/// The changes that make a box a part of the scene.
/// @param what "region", "occluder" or "samples", a set beside those that there are
/// @param box  world, metres; without height it is as high as the samples
/// @throws Refusal it has no area, or `what` is something else
[[nodiscard]] std::vector<Override> painting(const LoadedScene& loaded,
                                             const std::string& what,
                                             Eigen::AlignedBox3d box);

}  // namespace delos::session

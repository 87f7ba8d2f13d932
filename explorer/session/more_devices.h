// Devices more and fewer, as changes of their scene.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "delos/document/override.h"
#include "delos/plugin/registry.h"
#include "session/loaded_scene.h"

namespace delos::session {

/// Changes that are made together, by several ways, of which the first counts that
/// leaves the scene in order; or a sentence that says why there is none.
using Ways = std::variant<std::vector<std::vector<Override>>, std::string>;

/// Another device of a plugin, with its first parameters or those of a preset. It looks
/// at the middle of the samples, and reports as often as the scene's first device. What
/// can't stand in the world is carried by the target; what looks at beacons where there
/// are none gets a ceiling of them.
/// @param preset empty: none
/// @param at where, world, metres; nullopt: above the middle of the samples, as high as
///        the room
[[nodiscard]] Ways adding(const LoadedScene& loaded, const std::string& type,
                          const std::string& preset,
                          const std::optional<Eigen::Vector3d>& at,
                          PluginRegistry& plugins);

/// The same device once more.
/// @param by how far from it, in the world, metres; of one that a surface or the target
///        carries it stays where it is
[[nodiscard]] Ways copying(const LoadedScene& loaded, const std::string& device,
                           const Eigen::Vector3d& by);

/// The same device once more, mirrored by the plane across an axis of the world through
/// the middle of the samples: its view is the mirrored one, left for right. It stands
/// free, whatever the first one is mounted on.
/// @param axis 0, 1 or 2
[[nodiscard]] Ways mirroring(const LoadedScene& loaded, const std::string& device,
                             int axis);

/// Changes that are made together, or a sentence that says why there are none.
using Together = std::variant<std::vector<Override>, std::string>;

/// The most copies that are made at once.
inline constexpr int kMostCopies = 200;

/// The same device more times: the k-th copy is k times as far from it, turned as it
/// is.
/// @param copies 1 to kMostCopies @param by in the world, metres
[[nodiscard]] Together in_a_row(const LoadedScene& loaded, const std::string& device,
                                int copies, const Eigen::Vector3d& by);

/// The same device more times, evenly on a circle about an upright axis and turned with
/// it, so that all of them look at the axis as the first one does. They stand free.
/// @param copies 1 to kMostCopies; with the first there is one more
/// @param centre of the axis a point, world, metres
[[nodiscard]] Together in_a_circle(const LoadedScene& loaded, const std::string& device,
                                   int copies, const Eigen::Vector3d& centre);

/// One device fewer.
[[nodiscard]] Ways removing(const LoadedScene& loaded, const std::string& device);

/// A name that no device has yet: "s1" or "s1_2" → "s1_3".
[[nodiscard]] std::string free_name(const Scene& scene, const std::string& like);

/// `pose` as a placement says it in its own frame, by the key that it uses: an aim
/// keeps its distance.
[[nodiscard]] Placement placed_like(const Placement& like, const Pose& pose);

}  // namespace delos::session

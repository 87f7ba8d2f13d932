// A device put somewhere by hand, as changes of its scene.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "delos/document/override.h"
#include "delos/model/pose.h"
#include "delos/scene/scene.h"

namespace delos::session {

/// What to set so that a device stands at a place of the world. It keeps the way in
/// which its scene says where it faces: `aim` keeps its point, or its distance to one,
/// but then not the roll; without any it is `rpy`.
/// @param p where, metres; nullopt: it stays
/// @param R its orientation in the world; nullopt: as it is, or as its aim says
/// @returns the changes, or a sentence that says why it can't be put there
[[nodiscard]] std::variant<std::vector<Override>, std::string> placing(
    const Scene& scene, const std::string& device,
    const std::optional<Eigen::Vector3d>& p, const std::optional<Eigen::Matrix3d>& R);

/// The frame that the members of a group are placed in: X_WG.
/// @param group empty: the world
[[nodiscard]] Pose group_frame(const Scene& scene, const std::string& group);

/// (roll, pitch, yaw) of a rotation, radians; where the pitch is a right angle, without
/// roll.
[[nodiscard]] Eigen::Vector3d rpy_of(const Eigen::Matrix3d& R);

}  // namespace delos::session

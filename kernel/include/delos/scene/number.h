// Numbers of a loaded scene by their paths: what variables of a search are.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "delos/scene/scene.h"

namespace delos {

class PluginRegistry;

/// A number of a scene, and what is known of it.
struct SceneNumber {
  double* value;     ///< in the scene; valid until a list of it changes its size
  std::string unit;  ///< SI: "m", "rad", "1/s", "1"
  double lower = 0;  ///< least value that makes sense; −∞: none is known
  double upper = 0;  ///< greatest; +∞: none is known
  ParamScale scale = ParamScale::linear;
};

/// Find a number by the path that an override would use:
///
///   devices.NAME.at.x  .aim.y  .roll  .rpy.yaw  .quaternion_wxyz.w  .coordinates.0
///   .rate .phase  .exposure devices.NAME.params.P  .params.P.0  .params.P.0.1
///   groups.NAME.at.x …
///   occluders.NAME.at.x …   target.markers.0.x   target.bodies.NAME.at.x  .half_angle
///   surfaces.NAME.patch.origin.x  .patch.u.x  .from.origin.x  .rail.0.x   motion.q.0
///   lag
///
/// @returns the number, or a sentence that says why there is none, with a suggestion
[[nodiscard]] DELOS_API std::variant<SceneNumber, std::string> find_number(
    Scene& scene, std::string_view path, PluginRegistry& plugins);

/// The paths that a pattern means, in the order of the scene: `*` in a name stands for
/// any part of it, and a vector for its components: "devices.cam*.at" is
/// "devices.cam1.at.x", ….
/// @returns at least one path, or a sentence
[[nodiscard]] DELOS_API std::variant<std::vector<std::string>, std::string>
expand_numbers(Scene& scene, std::string_view pattern, PluginRegistry& plugins);

/// Names of devices that patterns mean, in the order of the scene.
/// @returns at least one, or a sentence
[[nodiscard]] DELOS_API std::variant<std::vector<std::string>, std::string>
expand_devices(const Scene& scene, const std::vector<std::string>& patterns);

}  // namespace delos

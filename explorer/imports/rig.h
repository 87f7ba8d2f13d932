// Devices and all else that an import can tell of a scene, before it is text.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "delos/scene/scene.h"
#include "imports/calibration.h"

namespace delos::imports {

/// A device; texts are as scenes write them.
struct RigDevice {
  std::string name, type, rate, group;
  std::string rate_remark;  ///< "assumed"; may be empty
  Placement placement;
  std::vector<std::pair<std::string, std::string>> params;
};

/// A number that a search may change.
struct RigVariable {
  std::string path;
  std::string lower, upper;  ///< empty: what is known of the number
  std::vector<std::string> tie;
  std::string remark;  ///< "slider S1_Noise"; may be empty
};

/// What a file tells, and what was assumed of the rest.
struct Rig {
  std::string kind;  ///< "calibration of Vicon (.xcp)"
  std::vector<std::string> facts;
  /// What the file doesn't say, as sentences.
  std::vector<std::string> assumed;
  std::string motion, sample;  ///< as scenes write them; empty: assumed below
  std::vector<Group> groups;
  std::vector<RigDevice> devices;
  std::vector<RigVariable> variables;
  std::vector<std::string> occluders;  ///< as scenes write them
};

/// Cameras as devices.
[[nodiscard]] Rig rig_of(const Calibration& calibration, const std::string& kind);

/// Motion and samples where the file has none: somebody who walks where the devices
/// look. Devices that all look away from each other are an error.
/// @param sights the devices' poses, x right, y down, z forward, metres
void assume_rest(Rig& rig, const std::vector<Pose>& sights, Source& source);

/// The scene's text, with comments that say where it is from and what is assumed.
/// @param title its name
/// @param from  the file that it was made of
[[nodiscard]] std::string scene_text(const Rig& rig, const std::string& title,
                                     const std::string& from);

/// Base stations of the Crazyflie's lighthouse system, a YAML file of geometry.
[[nodiscard]] bool is_lighthouse(const Value& root);
[[nodiscard]] Rig read_lighthouse(const Value& root, const ImportOptions& options,
                                  Source& source, std::vector<Pose>& sights);

/// Input files of Artemis, .ext, told by their first line.
[[nodiscard]] bool is_artemis(std::string_view text);
/// @param file   where files that it names are looked for beside
/// @param folder of the scene, which files of points are named from
[[nodiscard]] Rig read_artemis(std::string_view text, const std::filesystem::path& file,
                               const std::filesystem::path& folder, Source& source);

/// "[0.5, -1, 2e-05]", the shortest that reads back as the same numbers.
[[nodiscard]] std::string list_text(const Eigen::Ref<const Eigen::VectorXd>& numbers);

/// A name as scenes take it: without '.' and '=', not empty.
[[nodiscard]] std::string scene_name(std::string name);

}  // namespace delos::imports

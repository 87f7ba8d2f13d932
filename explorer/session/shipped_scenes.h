// The scenes that come with the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace delos::session {

struct ShippedScene {
  std::string id;     ///< file name without suffix, within the folder: "01-acoustic"
  std::string about;  ///< the first paragraph of the comment that it opens with
  std::filesystem::path file;
};

/// The scenes of an installation, or of the source tree that the program was built in.
/// @throws std::runtime_error they are missing
[[nodiscard]] std::filesystem::path scenes_folder();

/// All of them, and those of the folders within, sorted by id.
/// @throws std::runtime_error likewise
[[nodiscard]] std::vector<ShippedScene> shipped_scenes();

}  // namespace delos::session

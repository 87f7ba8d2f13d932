// What comes with the program: the scenes, and other folders.
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

/// Where this program stands.
struct Installation {
  std::filesystem::path prefix;  ///< an install tree or a build tree

  /// A folder that comes with it: PREFIX/share/delos/NAME, or in the source tree.
  /// @throws std::runtime_error it is missing
  [[nodiscard]] std::filesystem::path shared(const std::string& name,
                                             const std::string& in_source) const;
};
[[nodiscard]] Installation this_installation();

/// The scenes of an installation, or of the source tree that the program was built in.
/// @throws std::runtime_error they are missing
[[nodiscard]] std::filesystem::path scenes_folder();

/// All of them, and those of the folders within, sorted by id.
/// @throws std::runtime_error likewise
[[nodiscard]] std::vector<ShippedScene> shipped_scenes();

}  // namespace delos::session

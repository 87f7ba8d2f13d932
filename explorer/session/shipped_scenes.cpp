#include "session/shipped_scenes.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace delos::session {
namespace {

std::string first_paragraph(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string about;
  for (std::string line; std::getline(in, line) && line.rfind("# ", 0) == 0;)
    about += (about.empty() ? "" : " ") + line.substr(2);
  return about;
}

}  // namespace

std::filesystem::path scenes_folder() {
  const std::filesystem::path program = std::filesystem::canonical("/proc/self/exe");
  const std::filesystem::path prefix = program.parent_path().parent_path();
  for (const auto& folder :
       {prefix / "share/delos/scenes", prefix.parent_path().parent_path() / "scenes"}) {
    if (std::filesystem::is_directory(folder)) return folder;
  }
  throw std::runtime_error("the scenes that come with the program are missing from " +
                           (prefix / "share/delos/scenes").string());
}

std::vector<ShippedScene> shipped_scenes() {
  const std::filesystem::path folder = scenes_folder();
  std::vector<ShippedScene> scenes;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".yaml") continue;
    const std::filesystem::path name = entry.path().lexically_relative(folder);
    scenes.push_back({std::filesystem::path(name).replace_extension().generic_string(),
                      first_paragraph(entry.path()), entry.path()});
  }
  std::sort(scenes.begin(), scenes.end(),
            [](const ShippedScene& a, const ShippedScene& b) { return a.id < b.id; });
  return scenes;
}

}  // namespace delos::session

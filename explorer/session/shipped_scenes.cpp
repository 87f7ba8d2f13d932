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

Installation this_installation() {
  const std::filesystem::path program = std::filesystem::canonical("/proc/self/exe");
  return {program.parent_path().parent_path()};
}

std::filesystem::path Installation::shared(const std::string& name,
                                           const std::string& in_source) const {
  const std::filesystem::path installed = prefix / "share/delos" / name;
  for (const auto& folder :
       {installed, prefix.parent_path().parent_path() / in_source}) {
    if (std::filesystem::is_directory(folder)) return folder;
  }
  throw std::runtime_error("what comes with the program is missing: " +
                           installed.string());
}

std::filesystem::path scenes_folder() {
  return this_installation().shared("scenes", "scenes");
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

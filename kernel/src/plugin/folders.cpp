#include <boost/dll/runtime_symbol_info.hpp>
#include <cstdlib>
#include <sstream>

#include "delos/plugin/registry.h"

namespace delos {

std::vector<std::filesystem::path> plugin_folders(
    const std::vector<std::filesystem::path>& extra) {
  std::vector<std::filesystem::path> folders = extra;
  if (const char* listed = std::getenv("DELOS_PLUGIN_PATH")) {
    std::istringstream stream(listed);
    for (std::string folder; std::getline(stream, folder, ':');) {
      if (!folder.empty()) folders.emplace_back(folder);
    }
  }
  // Beside the kernel's library, whichever program or interpreter has loaded it.
  const std::filesystem::path kernel = boost::dll::this_line_location();
  folders.push_back(std::filesystem::absolute(kernel).parent_path() / "delos");
  return folders;
}

}  // namespace delos
